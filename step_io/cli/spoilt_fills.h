#pragma once

#include "cli/fill_model.h"
#include "suture/choose/report.h"
#include "suture/choose/request.h"

#include <map>
#include <string>
#include <vector>

namespace suture::cli {

/// Fills that are worse in the written file than they were in memory. For such a hole the next
/// method that auto would take is tried, up to three in all; what came out of the file best is
/// taken then, and stays out of the model if it is bad.
class SpoiltFills {
  public:
    explicit SpoiltFills(const FillRequest& request);

    /// Takes in what a run came to. True: all is to be done once more, as the request now says.
    ///
    /// Changes  request: spoilt, leave_open.
    [[nodiscard]] bool take(const FillSummary& summary, FillRequest& request);

    /// In place of the holes that were left open, the reports of the fills that they had.
    void put_back(std::vector<HoleReport>& holes);

  private:
    struct Spoilt {
        std::vector<HoleReport> tried;
        bool settled = false;
        bool well = false;  ///< the last one tried came out as it was
        bool open = false;
    };
    [[nodiscard]] bool settle(Spoilt& hole, bool filled) const;

    bool automatic_;
    std::map<int, Spoilt> holes_;  ///< by the first of their ids
};

}  // namespace suture::cli

#pragma once

#include "cli/command.h"
#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <memory>
#include <string>

namespace suture::cli {

/// A process beside the job that takes its pictures: a browser needs sockets and files that the
/// job's sandbox does not have, and makes a sandbox of its own.
class PictureBroker {
  public:
    /// Starts the process, before the job's; none if the command wants no picture.
    explicit PictureBroker(const Command& command);
    PictureBroker(const PictureBroker&) = delete;
    PictureBroker& operator=(const PictureBroker&) = delete;
    /// Ends it, the browser and its temporary files.
    ~PictureBroker();

    /// In the job: has a page's picture taken, as report::take_picture does.
    [[nodiscard]] Result<void> take(const std::string& page, const Progress& progress) const;

  private:
    int process_ = -1;
    int line_ = -1;
};

}  // namespace suture::cli

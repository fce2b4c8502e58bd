#pragma once

#include "suture/base/result.h"
#include "suture/choose/report.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace suture::cli {

/// What of a hole's fill is worse in the file than it was in memory.
struct WritingLoss {
    enum class Kind {
        Face,   ///< of `memory` new faces, `file` were not found again
        Side,   ///< of `memory` sides, `file` were not found again
        Gap,    ///< the largest, model units
        Angle,  ///< the largest, radians
    };
    std::vector<int> hole;  ///< its ids
    Kind kind = Kind::Face;
    double memory = 0.0, file = 0.0;
};

/// Compares the reports of the same holes: what is read back may be at most 1.5 times what memory
/// had. Figures that rounding alone can make, 1e-6 of a model unit and of a radian, are none.
///
/// Input    memory, file: filled holes in the same order.
[[nodiscard]] std::vector<WritingLoss> lost_by_writing(std::span<const HoleReport> memory,
                                                       std::span<const HoleReport> file);

/// Writes in one way after another until nothing is lost, and once more in the way that loses least
/// where that was not the last.
///
/// Input    accuracies: that the file may state, at least one; write: writes, reads back, compares.
/// Result   what is lost all the same.
[[nodiscard]] Result<std::vector<WritingLoss>> write_with_least_loss(
    const std::vector<double>& accuracies,
    const std::function<Result<std::vector<WritingLoss>>(double accuracy)>& write);

/// "the largest angle is 148 deg in the file, 0.0014 deg in memory".
[[nodiscard]] std::string to_string(const WritingLoss& loss);

/// The same for the judge.
[[nodiscard]] Finding finding_of(const WritingLoss& loss);

}  // namespace suture::cli

#pragma once

#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/choose/request.h"
#include "suture/choose/trial.h"
#include "suture/model/patch.h"
#include "suture/model/recognised.h"
#include "suture/model/ribbon.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// A method together with all that it needs.
struct Attempt {
    std::string name;
    /// Sets what was recognised, if anything.
    ///
    /// Input    passed_over: so many of the surfaces that are recognised turned out to be bad.
    std::function<Result<FillResult>(std::optional<Recognised>&, int passed_over)> fill;
    bool improving = false;    ///< costly: where a fill is usable but none within tolerance
    bool slow = false;         ///< OCCT's filling
    bool last_resort = false;  ///< position only, where nothing else is worth taking
};

/// What is tried for a hole, cheap ways first. For `occt` the first attempt is what was asked for,
/// and the others are there for holes over which that surface folds.
///
/// Input    what is referred to has to outlive the attempts.
[[nodiscard]] std::vector<Attempt> attempts_for(const Site& site, const Hole& hole,
                                                const FillRequest& request,
                                                const Tolerance& tolerance);

}  // namespace suture

#pragma once

#include "suture/base/result.h"
#include "suture/choose/request.h"
#include "suture/choose/trial.h"
#include "suture/choose/twin_figures.h"
#include "suture/judge/judge_fill.h"
#include "suture/model/patch.h"
#include "suture/model/recognised.h"
#include "suture/model/ribbon.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// The fill that was chosen, and why.
struct Choice {
    std::string method;
    FillResult fill;
    FillMeasures measures;
    std::vector<Placement> placements;  ///< of the hole's edges on the new faces
    Judgement verdict;
    std::string reason;
    double seconds = 0.0;  ///< in the fill methods, all that were tried
    std::optional<Recognised> recognised;
    std::optional<TwinFigures> twin;  ///< of the face whose copy it is, where that was measured
    bool relaxed = false;  ///< position only, along all sides that nobody asked to be smooth

    /// OCCT's filling, which can take a minute, would not come noticeably nearer.
    [[nodiscard]] bool near() const;
};

/// Which methods take part where the request leaves the choice.
enum class Tries {
    Own,  ///< the methods of our own
    All   ///< OCCT's filling as well
};

/// Fills one hole with the method asked for, or (auto) with the best of those that apply: each is
/// tried and judged; the first within tolerance is taken, else the one that comes nearest.
///
/// Input    hole: with the continuity wanted on each ribbon.
/// Result   a fill that is bad only where there is no better one: it is the caller's to refuse it.
/// Refuses  when no method gives a valid face; the message has every method's own reason.
[[nodiscard]] Result<Choice> choose_fill(const Site& site, const Hole& hole,
                                         const FillRequest& request, const Tolerance& tolerance,
                                         Tries tries = Tries::All);

/// What is left to be tried for a hole.
enum class Left {
    Improving,  ///< costly methods, where a fill is usable but none within tolerance
    Slow        ///< OCCT's filling
};

/// The same for a hole for which choose_fill with Tries::Own gave this.
[[nodiscard]] Result<Choice> choose_further(const Site& site, const Hole& hole,
                                            const FillRequest& request, const Tolerance& tolerance,
                                            Result<Choice> earlier, Left left);

/// Whether --method takes this name; the Usage error lists those that exist.
[[nodiscard]] Result<void> validate_method(const std::string& method);

/// The options that a method of that name has; `auto` and `occt` have none.
[[nodiscard]] std::span<const MethodOption> options_of(std::string_view method);

}  // namespace suture

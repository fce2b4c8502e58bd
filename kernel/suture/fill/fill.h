#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/fill/option.h"
#include "suture/model/patch.h"
#include "suture/model/recognised.h"
#include "suture/model/ribbon.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// A surface of the model on which a hole's lost face may lie, and where it comes from.
struct Candidate {
    Surface surface;
    std::string kind;  ///< "same surface", "offset", "twin"
    /// "the surface of face 4", "face 3, offset by 2", "mirrored twin of face 31"
    std::string from;
    double allowed = 0.0;  ///< how far it may miss the border by its origin, in model units
    double chance = 1.0;   ///< how probable it is that another one is as plain
    std::optional<TwinSource> twin = {};  ///< of a twin: the face that it is a copy of
    std::shared_ptr<const ModelSurface> original = {};  ///< as Patch::original
};

/// Looks for such surfaces: asked only where they are needed, thread safe.
using CandidateFinder = std::function<std::vector<Candidate>()>;

/// Which of two surfaces is taken that the lost face may have had.
enum class Prefer {
    Tight,    ///< the one that fits better: a ball's own envelope
    Original  ///< a face's: also where it is a CAD system's approximation of a ball
};

struct FillOptions {
    Tolerance tolerance;
    Progress progress;
    OptionValues own;    ///< of the options that the method itself declares
    double noise = 0.0;  ///< how far the model's edges lie off its faces here, in model units
    std::vector<double> side_noise = {};  ///< the same of each side, loop by loop; may be empty
    CandidateFinder candidates = {};
    int passed_over = 0;  ///< so many of the surfaces that are recognised turned out to be bad
    Prefer prefer = Prefer::Tight;
    /// Told by a method that knows the lost surface again.
    std::function<void(const Recognised&)> recognised = {};
};

/// A fill method: patches for a hole, or a refusal that names the ribbon and the reason.
using FillFunction = Result<FillResult> (*)(const Hole&, const FillOptions&);

/// When `auto` tries a method; else it is run by --method only.
enum class AutoUse {
    Always,
    Recognising,  ///< where the lost face is to be looked for
    /// Where edges are to be connected: between the rims of a hole it would bulge where the lost
    /// face met them sharply.
    Bridging,
    Improving,  ///< where a fill is usable but none within tolerance: nearer, with more poles
    Never
};

/// One row of the method table.
struct FillMethod {
    std::string_view id;  ///< as given to --method
    std::string_view title;
    std::string_view source;  ///< citation
    std::string_view sides;   ///< how many sides it takes
    Continuity highest;       ///< the highest continuity it can reach
    FillFunction fill;
    std::span<const MethodOption> options = {};  ///< its own, for --option
    AutoUse in_auto = AutoUse::Always;
};

/// Every method that needs nothing but the ribbons, in the order in which `auto` tries them.
[[nodiscard]] std::span<const FillMethod> fill_methods();

}  // namespace suture

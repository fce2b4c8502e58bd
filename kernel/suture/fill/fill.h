#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/fill/option.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <span>
#include <string_view>

namespace suture {

struct FillOptions {
    Tolerance tolerance;
    Progress progress;
    OptionValues own;  ///< of the options that the method itself declares
};

/// A fill method: patches for a hole, or a refusal that names the ribbon and the reason.
using FillFunction = Result<FillResult> (*)(const Hole&, const FillOptions&);

/// One row of the method table.
struct FillMethod {
    std::string_view id;  ///< as given to --method
    std::string_view title;
    std::string_view source;  ///< citation
    std::string_view sides;   ///< how many sides it takes
    Continuity highest;       ///< the highest continuity it can reach
    FillFunction fill;
    std::span<const MethodOption> options = {};  ///< its own, for --option
    bool in_auto = true;  ///< whether `auto` tries it; else it is run by --method only
};

/// Every method that needs nothing but the ribbons, in the order in which `auto` tries them.
[[nodiscard]] std::span<const FillMethod> fill_methods();

}  // namespace suture

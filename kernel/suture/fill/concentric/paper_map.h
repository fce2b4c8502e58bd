#pragma once

#include "suture/base/result.h"
#include "suture/fill/concentric/closed_spline.h"
#include "suture/fill/concentric/map.h"

namespace suture::concentric {

/// Whose axis the paper's map has.
enum class PaperAxis {
    Basic,  ///< of the control polygon (figure 7)
    Moved   ///< the same, its vertices moved onto the axis of a refined polygon (figure 11)
};

/// The concentric map as the paper has it, where it does not fold.
///
/// Input    curve: counterclockwise.
/// Refuses  what make_sites() and medial_axis() do; a map that folds, naming the parameters; with
///          Moved also what concentric_map() does, for the refined polygon.
/// Source   Martin & Cohen 2003, figures 7 and 11. Deviation: the certificate; the paper looks for
///          edges of the axis that cross the boundary.
[[nodiscard]] Result<ConcentricMap> paper_map(const ClosedSpline& curve, PaperAxis kind);

}  // namespace suture::concentric

#pragma once

#include "suture/fill/fill.h"

#include <array>

namespace suture {

inline constexpr std::array kTubeOptions = {
    MethodOption{"pole", OptionKind::Position, "X,Y,Z", "the closing point (default: found)"},
    MethodOption{"normal", OptionKind::Direction, "X,Y,Z",
                 "the outward normal at the closing point (default: found)"},
    MethodOption{"energy", OptionKind::Word, "plate|F1|F2|F3",
                 "the fairness functional that is least (default plate)"},
    MethodOption{"magnitude", OptionKind::Number, "LENGTH",
                 "of all tangents at the closing point (default: as the functional wants them)",
                 0.0},
    MethodOption{"move-pole", OptionKind::Number, "WEIGHT",
                 "let the functional move the closing point; the weight holds it back, 1 with the "
                 "functional's own stiffness (default: it stays)",
                 0.0},
    MethodOption{"curvature", OptionKind::Numbers, "K,...",
                 "normal curvatures at the closing point, 1/length, positive towards the normal: "
                 "one, or one for each side (default: free)"},
    MethodOption{"border", OptionKind::Word, "interpolated|bezier|taylor",
                 "the border as a spline through its points, or as one near quadratic pieces"},
    MethodOption{"join", OptionKind::Word, "fit|march",
                 "such pieces by least squares, or each in its turn"},
    MethodOption{"layers", OptionKind::Count, "N",
                 "rows of patches beside the border, each half as wide as the one before (default: "
                 "as many as keep creases within the angle tolerance)",
                 0.0},
};

/// The B-spline tube with a pole: one surface of bidegree (3,2), around the hole and shrunk to a
/// point in its middle, smooth there, the rest as fair as a quadratic functional makes it.
///
/// Result    one patch with a seam from the first corner to the pole.
/// Promises  one normal at the pole; no fold. The notes say what was reached.
/// Refuses   islands and inner points; a loop that is not star-shaped seen from the pole, naming
///           the side; a surface that folds; curvatures that cannot be reached.
/// Source    Szilvasi-Nagy, Filling holes with B-spline surfaces, 2002; docs/methods/tube.md.
[[nodiscard]] Result<FillResult> fill_tube(const Hole& hole, const FillOptions& options);

}  // namespace suture

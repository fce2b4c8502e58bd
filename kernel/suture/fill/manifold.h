#pragma once

#include "suture/fill/fill.h"

#include <array>

namespace suture {

/// The n-sided C^k patch with B-spline borders: a star of control points whose outer rows are
/// fitted to the neighbours and whose inner rows are as fair as these allow.
///
/// Result    2 n patches: n border strips, exact, and n quads of the middle, fitted, or its exact
///           cells; for a loop
///           without corners one patch closed at an apex. Layers are added until the border is
///           within tolerance. The notes say what was reached.
/// Options   k, aperture, layers, middle (kManifoldOptions).
/// Refuses   islands and points to pass through; a loop with one or two corners or with a reflex
///           one; a border or a surface that folds.
/// Source    Cotrina-Navau, Pla-Garcia, Vigo-Anglada, N-sided patches with B-spline boundaries,
///           2001; fitting it to a hole is our own: docs/methods/manifold.md.
[[nodiscard]] Result<FillResult> fill_manifold(const Hole& hole, const FillOptions& options);

inline constexpr std::array kManifoldOptions = {
    MethodOption{"k", OptionKind::Count, "0..4", "order of continuity inside (default 2)", 0.0},
    MethodOption{"aperture", OptionKind::Number, "F",
                 "size of the central face in the parameters (default: even knots)", 0.0},
    MethodOption{"layers", OptionKind::Count, "S",
                 "layers of the control mesh (default: as many as the tolerance needs)", 1.0},
    MethodOption{"middle", OptionKind::Word, "quads|exact",
                 "n fitted faces, or for k = 0 and 1 exact cells (default: quads; for k = 0 and 1 "
                 "exact where quads do not do)"},
};

}  // namespace suture

#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/mvs/layout.h"
#include "suture/fill/mvs/samples.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace suture::mvs {

/// A corner whose neighbours agree in normal but not in curvature: no C2 surface is tangent to
/// both along their edges.
struct TwistedCorner {
    std::size_t index = 0;     ///< of the ribbon that begins there
    double start = 0.0;        ///< direction in the domain of the side that begins there
    double wedge = 0.0;        ///< interior angle in the domain
    double space_wedge = 0.0;  ///< and on the surface
    /// II of the side before less that of the side after, in the frame of the latter's tangent.
    Eigen::Matrix2d twist = Eigen::Matrix2d::Zero();
    double shorter_side = 0.0;  ///< in the solver's unit
    double disagreement = 0.0;  ///< what no C2 surface meets of the twist
};

/// Input    least: the disagreement, in the solver's unit, from which on a corner counts.
[[nodiscard]] std::vector<TwistedCorner> twisted_corners(const RibbonLoop& loop,
                                                         const Layout& layout, const Scale& scale,
                                                         double least);

/// How the net's lines run in the domain, as angles: those of v = const, along u, and those of
/// u = const.
struct LineDirections {
    double along_u = 0.0;
    double along_v = 0.5 * kPi;
};

/// The lines through a corner that meet the neighbours' forms.
struct CornerLines {
    std::array<bool, 2> axes = {false, false};  ///< u = const, v = const
    double residual = 0.0;                      ///< what they leave of the disagreement
    double jump = 0.0;                          ///< the largest jump of curvature across them
    [[nodiscard]] int count() const { return (axes[0] ? 1 : 0) + (axes[1] ? 1 : 0); }
};

/// The fewest lines that meet the neighbours' forms, with the least jump; none where no line parts
/// the two edges.
///
/// Source   docs/methods/mvs.md, "knot lines".
[[nodiscard]] CornerLines choose_lines(const TwistedCorner& corner,
                                       const LineDirections& directions);

}  // namespace suture::mvs

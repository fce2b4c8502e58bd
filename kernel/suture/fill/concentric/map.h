#pragma once

#include "suture/base/result.h"
#include "suture/fill/concentric/closed_spline.h"
#include "suture/fill/concentric/concentric_curve.h"

#include <vector>

namespace suture::concentric {

struct MapOptions {
    /// Branches of the axis that stick out of the disc at their root by less than this share of the
    /// largest radius are cut.
    double salience = 0.0;
    /// Nodes of the axis go where it moves by less than this share of the largest radius; 0 keeps
    /// them all.
    double flatness = 0.0;
    /// Whether c rests at a node between corners whose seams end there: then the boundary between
    /// them is a region that ends in a point. Else it passes the node in the middle.
    bool rest_between_corners = true;
    /// How often the control polygon may be refined before the map is refused.
    int refinements = 8;
    /// Whether c rests where it turns back, wherever the map stays certified. Where it turns at
    /// once, a spoke runs along the axis, and the surface has no normal there.
    bool rest_at_tips = false;
};

/// A concentric map: (1-t) curve(s) + t axis(s).
struct ConcentricMap {
    ConcentricCurve axis;
    ClosedSpline refined;  ///< the boundary over the knots whose polygon the axis is of
    int refinements = 0;   ///< how often it was refined
    double radius = 0.0;   ///< of the largest inscribed circle of that polygon
};

/// The concentric map of a simple closed curve, certified not to fold.
///
/// Input    curve: counterclockwise.
/// Result   an axis whose map has a Jacobian of one sign, proved by Bernstein coefficients.
/// Refuses  a curve that crosses itself or nearly touches itself, naming where; a map that folds
///          after all refinements, naming the parameters.
/// Source   Martin & Cohen 2003, figure 7. Deviation: the boundary's part of a cut branch may be
///          mapped to one point, parameters are feet instead of interpolated ones, and what folds
///          is refined until a certificate holds.
[[nodiscard]] Result<ConcentricMap> concentric_map(const ClosedSpline& curve,
                                                   const MapOptions& options = {});

}  // namespace suture::concentric

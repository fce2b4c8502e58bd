#pragma once

#include "suture/base/tolerance.h"
#include "suture/fill/concentric/assemble.h"
#include "suture/fill/concentric/boundary.h"
#include "suture/fill/concentric/fit.h"
#include "suture/fill/concentric/guide.h"
#include "suture/fill/concentric/radial.h"
#include "suture/fill/concentric/spokes.h"
#include "suture/model/ribbon.h"

#include <vector>

namespace suture::concentric {

/// The concentric map carried into space along a guide (Spokes), as B-spline surfaces. All have the
/// same knots in t, as few as bring the spokes' normals within the tolerance, and each knots of its
/// own in s, where its error asks for them. The first row of poles is the side's own curve; what
/// lies on a seam or at a node comes from the same data on both sides.
///
/// Source   ours: what Martin & Cohen 2003 name as their next step.
class Lift {
  public:
    /// What is referred to has to outlive it.
    Lift(const Hole& hole, const Boundary& boundary, const Guide& guide,
         const ConcentricCurve& axis, const std::vector<Region>& regions,
         const Tolerance& tolerance);

    [[nodiscard]] SplineSurface surface(const Region& region);
    [[nodiscard]] Eigen::Vector3d vertex(int node) const { return spokes_.node(node); }

    /// How far the surfaces made so far miss what they stand for, against what they may; more than
    /// 1 where knots ran out.
    [[nodiscard]] double missed() const { return missed_; }
    /// The largest distance from it, in model units.
    [[nodiscard]] double error() const { return error_; }

  private:
    Tolerance tolerance_;
    Spokes spokes_;
    Radial radial_{{0.0, 1.0}};
    double missed_ = 0.0;
    double error_ = 0.0;

    [[nodiscard]] static std::vector<Strip> strips(const Region& region);
    /// What a spoke's spline is made of, and how that changes with s.
    struct Data {
        Eigen::MatrixXd points, changes;
    };
    [[nodiscard]] Data data(const MovingSpoke& spoke) const;
    void choose_radial_knots(const std::vector<Region>& regions);
    void measure_spoke(const MovingSpoke& spoke, double share, std::vector<double>& missed) const;
    [[nodiscard]] double missed_by(const SpokeJet& made, const SpokeJet& wanted, double angle,
                                   double place) const;
    [[nodiscard]] double missed_on(const Strip& strip, const SplineCurve& gamma,
                                   const SplineCurve& rows, double from, double to);
    [[nodiscard]] FittedCurve fit(const Region& region, const SplineCurve& gamma);
};

}  // namespace suture::concentric

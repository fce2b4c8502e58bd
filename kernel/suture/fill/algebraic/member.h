#pragma once

#include "suture/base/progress.h"
#include "suture/fill/algebraic/frustum.h"
#include "suture/fill/algebraic/space.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace suture::algebraic {

/// Where the surface should run, and how.
struct GuideSample {
    int cell = 0;
    Eigen::Vector3d point;
    Eigen::Vector3d normal;  ///< of length 1
};

/// A frustum in which a cell's surface has to be one sheet, with the layer of Bernstein
/// coefficients that may have any sign: all below are negative, all above positive.
struct SheetCondition {
    int cell = 0;
    Frustum frustum;
    int split = 0;
};

struct GuideWeights {
    double normals = 1.0;
    double bending = 1e-3;
    /// Misses of this size cost as much as being 1 off the guide.
    double miss = 1.0;
};

/// The member of a space of piecewise polynomials that follows a guide best:
///   least sum of g(p)^2 + normals |grad g(p) - n|^2 + bending |Hess g(p)|^2 + |misses / miss|^2.
class Member {
  public:
    Member(const Space& space, const std::vector<GuideSample>& guide, const GuideWeights& weights);

    /// Coordinates in the space's basis.
    [[nodiscard]] Eigen::VectorXd best() const { return best_; }

    /// The best one that satisfies the conditions, which are sufficient but not necessary for a
    /// single sheet; nothing if no member satisfies them all.
    ///
    /// Input  sign: +1 if the sheets' normals point away from the frusta's centre.
    [[nodiscard]] std::optional<Eigen::VectorXd> best_under(
        const std::vector<SheetCondition>& conditions, double sign, double margin,
        const Progress& progress) const;

  private:
    const Space& space_;
    Eigen::MatrixXd factor_;  ///< L of the normal equations L L^T
    Eigen::VectorXd best_;
};

}  // namespace suture::algebraic

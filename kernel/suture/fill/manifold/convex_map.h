#pragma once

#include "suture/base/result.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace suture::manifold {

/// The harmonic map of a plane region onto a convex one, and its inverse: however the region is
/// bent, nothing folds (Rado, Kneser, Choquet).
///
/// Each coordinate is the potential of a layer of charges that is constant on each segment of the
/// boundary, plus a constant, and has its values at the segments' middles.
class ConvexMap {
  public:
    /// Input    boundary: a simple closed polygon; images: of its vertices, around a convex region.
    /// Refuses  a system that has no solution.
    [[nodiscard]] static Result<ConvexMap> make(const std::vector<Eigen::Vector2d>& boundary,
                                                const std::vector<Eigen::Vector2d>& images);

    [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& p) const;

    /// The point of the region that goes there; none within a segment's length of the boundary,
    /// where steps of the charges show, and where the iteration does not end.
    [[nodiscard]] std::optional<Eigen::Vector2d> inverse(const Eigen::Vector2d& image) const;

  private:
    struct Value {
        Eigen::Vector2d point;
        Eigen::Matrix2d slope;
    };

    /// A place of the region, and where it goes.
    struct Seed {
        Eigen::Vector2d at;
        Value value;
    };

    std::vector<Eigen::Vector2d> boundary_;
    Eigen::Matrix2Xd vertices_;  ///< the same
    Eigen::Matrix2Xd along_;     ///< directions of the segments that start there
    Eigen::VectorXd lengths_;    ///< of these
    Eigen::Matrix2Xd charges_;   ///< one column a segment
    Eigen::Vector2d constant_ = Eigen::Vector2d::Zero();
    double size_ = 1.0;  ///< of the region
    std::vector<Seed> seeds_;

    /// Calls take(segment, potential, slope) for the layers of all segments at p.
    template <class Take>
    void for_each_potential(const Eigen::Vector2d& p, Take&& take) const;
    [[nodiscard]] Value expand(const Eigen::Vector2d& p) const;
    [[nodiscard]] bool is_inside(const Eigen::Vector2d& p) const;
    [[nodiscard]] bool is_near_boundary(const Eigen::Vector2d& p) const;
    void make_seeds();
};

}  // namespace suture::manifold

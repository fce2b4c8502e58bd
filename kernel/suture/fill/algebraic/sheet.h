#pragma once

#include "suture/fill/algebraic/solution.h"

#include <Eigen/Core>

#include <optional>

namespace suture::algebraic {

/// The surface over one sector, as a function of the ray.
class Sheet {
  public:
    Sheet(const Problem& problem, const Solution& solution, int sector);

    [[nodiscard]] const Eigen::Matrix3d& directions() const { return directions_; }
    [[nodiscard]] const Polynomial<double>& polynomial() const { return g_; }

    /// The point on the ray with these barycentric coordinates: the root nearest to `t`, where the
    /// polynomial has the right sign on both sides; to rounding errors. Nothing if there is none
    /// within a third of t.
    [[nodiscard]] std::optional<Eigen::Vector3d> at(const Eigen::Vector3d& b, double t) const;

    /// How far along its ray the guide's nearest point is: where to look for the root.
    [[nodiscard]] double guess(const Eigen::Vector3d& b) const;

  private:
    Polynomial<double> g_;
    Eigen::Vector3d centre_;
    Eigen::Matrix3d directions_;
    double sign_;
    Eigen::Matrix3Xd guide_b_;
    Eigen::VectorXd guide_t_;
};

}  // namespace suture::algebraic

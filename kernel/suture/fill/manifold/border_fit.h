#pragma once

#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/fill/manifold/fold.h"
#include "suture/fill/manifold/guide.h"
#include "suture/fill/manifold/sides.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace suture::manifold {

/// The border of a surface at one place: the control points that act there, and how.
struct BorderRow {
    std::vector<int> points;
    Eigen::MatrixXd weights;  ///< S, S_x, S_y, S_xx as rows of weights of these points
};

/// A surface whose border is to follow ribbons: x leads outwards, y along the border.
struct BorderModel {
    int k = 2;
    int points = 0;                          ///< how many control points there are
    std::vector<std::vector<double>> knots;  ///< y of each side, from its first to its last point
    /// Of each side the place, from -1 to 1, that comes to lie in the middle of its range of y.
    std::vector<double> centres;
    double depth = 1.0;                  ///< how far a unit of x leads, in model units, roughly
    Eigen::SparseMatrix<double> energy;  ///< of one coordinate of the points
    /// The least squares of first differences, from which the cross derivatives take their size
    /// where a surface folds else; empty: it is `depth`.
    Eigen::SparseMatrix<double> membrane;
    std::function<BorderRow(int side, double y)> row;
    /// Places all over the inside, closer than the knots: rows of S alone. Only with a guide.
    std::function<std::vector<BorderRow>()> inner;
    std::function<std::optional<Fold>(const Eigen::Matrix3Xd& points)> fold;

    /// y on a side at a share of its length.
    [[nodiscard]] double y_at(int side, double share) const;
    /// y on a side of a piece's ribbon at its parameter s.
    [[nodiscard]] double y_of(int side, const Piece& piece, double s) const;
};

/// Control points whose border follows the ribbons.
struct BorderFit {
    Eigen::Matrix3Xd points;
    double gap = 0.0;    ///< largest distance from the ribbons, between the fitted samples
    double angle = 0.0;  ///< largest angle from the neighbours' tangent planes, where wanted
    /// The least cross derivative outwards, as a share of its median on the same ribbon: near zero
    /// the surface almost folds.
    double evenness = 1.0;
    /// Largest distance from the guide's point of the same parameters; negative: without a guide.
    double from_guide = -1.0;
    std::string left_guide;  ///< why it does not follow the guide that was given
};

/// Least squares over the border's samples
///     |S - c|^2 + (weight / depth)^2 ((n . S_x)^2 [+ (n . S_xx - II(S_x, S_x))^2])
/// plus a small multiple of the net's energy. Linear but for G2, which takes Gauss-Newton steps.
/// With a guide, what the border leaves open comes near that: the model's plane and the guide's
/// domain are both laid onto a regular polygon by harmonic maps, and each place is wished to be
/// where the guide is there. Where that folds, and without a guide, the energy alone decides.
///
/// Input    the model has one side for each of `sides`, in the same order. limits: of gap and
/// angle;
///          the steps for G2 are spared where these are not met without it.
/// Refuses  a system that cannot be factorised; a border that faces the other way than the
///          neighbours; a surface that folds.
[[nodiscard]] Result<BorderFit> fit_border(const BorderModel& model, const Hole& hole,
                                           const Sides& sides, const Tolerance& limits,
                                           const GuideSurface* guide);

}  // namespace suture::manifold

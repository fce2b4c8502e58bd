#pragma once

#include "suture/base/result.h"
#include "suture/fill/tube/chart.h"
#include "suture/fill/tube/net.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <optional>
#include <vector>

namespace suture::tube {

/// The fairness functionals; F1 to F3 are integrals of squares over the parameters, equations (24)
/// to (26).
enum class Functional {
    F1,     ///< |r_uu|^2 + 2 |r_uv|^2 + |r_vv|^2
    F2,     ///< F1 + |r_u|^2 + |r_v|^2
    F3,     ///< F1 + |r_uuu|^2
    Plate,  ///< the thin plate in a chart, instead of in the parameters (chart.h)
};

/// The quadratic form of F1, F2 or F3 on a net's points, one coordinate at a time. Exact.
[[nodiscard]] RealSparse energy_matrix(const Net& net, Functional functional);

/// The value of a functional.
[[nodiscard]] double energy(const Net& net, const RealSparse& matrix);

/// What closes the tube: the pole, its unit normal, and for each column the unit direction in which
/// it leaves the pole, perpendicular to the normal.
struct Closing {
    Eigen::Vector3d pole, normal;
    std::vector<Eigen::Vector3d> directions;
};

/// How the pole may move in the extended functional F + weight |P - P0|^2.
struct PoleWeight {
    double weight = 1.0;
    bool relative = true;  ///< to the functional's own stiffness against moving the pole
};

/// What the free part of a net is found from.
struct FairingTask {
    Closing closing;
    Functional functional = Functional::F3;
    std::optional<Chart> chart;  ///< of the plate
    bool free_rows = true;       ///< the rows between are unknowns too, else they stay as they are
    std::optional<std::vector<double>> magnitudes;  ///< of the end tangents, given; else unknowns
    std::optional<PoleWeight> moving;               ///< else the pole stays
    /// Normal curvatures at the pole, towards the closing's normal: none, one for all directions,
    /// or one for each interval around (0-based, of those that are not empty).
    std::vector<double> curvatures;
};

struct Fairing {
    Net net;
    Eigen::VectorXd magnitudes;  ///< lambda_j of every column
    Eigen::Vector3d pole;
    double value = 0.0;   ///< of the functional, without the distance term
    int steps = 0;        ///< of Newton's method for curvatures, else 0
    double defect = 0.0;  ///< largest difference from a curvature asked for
};

/// Closes a net: rows 0 to n - 3 from the two last ones, by minimising a functional.
///
/// Input    net: its last two rows are kept; `free_rows` false: all but the first two. At a double
///          knot every other row has continuous tangents.
/// Refuses  a chart that folds so that nothing can be minimised over it; curvatures that Newton's
///          method does not reach.
/// Source   Szilvasi-Nagy 2002, sections 4 to 6.
[[nodiscard]] Result<Fairing> close(const Net& net, const FairingTask& task);

}  // namespace suture::tube

#pragma once

#include "suture/base/result.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace suture::manifold {

/// A line or parabola in the plane, p(t) = (offset + bend t^2) axis + t across, with `across` the
/// unit vector `axis` turned left.
struct PlaneCurve {
    Eigen::Vector2d axis = Eigen::Vector2d::UnitX();
    double offset = 0.0;
    double bend = 0.0;
    double from = 0.0;
    double to = 1.0;

    [[nodiscard]] Eigen::Vector2d across() const { return {-axis.y(), axis.x()}; }
    [[nodiscard]] Eigen::Vector2d at(double t) const {
        return (offset + bend * t * t) * axis + t * across();
    }
    [[nodiscard]] Eigen::Vector2d tangent(double t) const {
        return 2.0 * bend * t * axis + across();
    }
};

/// Curves that cut the plane into cells.
struct Arrangement {
    /// A part of a curve between two vertices, in the curve's own direction.
    struct Edge {
        PlaneCurve curve;
        int from = 0;
        int to = 0;
    };
    struct Use {
        int edge = 0;
        bool backwards = false;
    };

    std::vector<Eigen::Vector2d> vertices;
    std::vector<Edge> edges;
    std::vector<std::vector<Use>> cells;  ///< each with its interior to the left
};

/// Cuts curves at each other and finds the cells between them. Parts of lines that lie on each
/// other count once; what ends inside a cell is left away.
///
/// Input    inside: whether a point belongs to the part of the plane that is wanted.
///          size: a length that is large here: 1e-9 of it is nothing.
/// Refuses  curves that leave an edge shorter than 1e-6 `size`; curves that do not hang together.
[[nodiscard]] Result<Arrangement> arrange(
    std::vector<PlaneCurve> curves, double size,
    const std::function<bool(const Eigen::Vector2d&)>& inside);

}  // namespace suture::manifold

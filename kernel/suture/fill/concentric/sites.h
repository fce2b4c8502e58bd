#pragma once

#include "suture/base/result.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace suture::concentric {

/// A simple polygon on an integer grid, counterclockwise, as the Voronoi diagram wants it: no
/// vertex twice, none in the middle of a straight side. Site edge i leads from vertex i to vertex i
/// + 1.
struct Sites {
    struct Vertex {
        std::int32_t x = 0;
        std::int32_t y = 0;
        /// The boundary's parameter there: a range where several vertices fall together.
        double before = 0.0;
        double after = 0.0;
        bool reflex = false;
    };
    std::vector<Vertex> vertices;
    /// edges[i]: what the side's parameter is at a fraction of its length, piecewise linear from
    /// (0, vertices[i].after) to (1, vertices[i + 1].before).
    std::vector<std::vector<Eigen::Vector2d>> edges;
    double period = 0.0;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double scale = 1.0;  ///< grid = (point - centre) * scale

    [[nodiscard]] int count() const { return static_cast<int>(vertices.size()); }
    [[nodiscard]] Eigen::Vector2d grid(int vertex) const {
        const Vertex& v = vertices[static_cast<std::size_t>(vertex % count())];
        return {static_cast<double>(v.x), static_cast<double>(v.y)};
    }
    [[nodiscard]] Eigen::Vector2d point(const Eigen::Vector2d& grid) const {
        return centre + grid / scale;
    }
    /// The parameter of side `edge` at a fraction of its length.
    [[nodiscard]] double parameter(int edge, double fraction) const;
};

/// Input    polygon: 2 x n, counterclockwise; parameters: of its vertices, increasing by less than
///          the period in all.
/// Refuses  a polygon that crosses or touches itself, naming where.
[[nodiscard]] Result<Sites> make_sites(const Eigen::Matrix2Xd& polygon,
                                       const std::vector<double>& parameters, double period);

/// Twice the signed area.
[[nodiscard]] double double_area(const Eigen::Matrix2Xd& polygon);

}  // namespace suture::concentric

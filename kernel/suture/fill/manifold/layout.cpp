#include "suture/fill/manifold/layout.h"

#include <cmath>
#include <iterator>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;

TrimCurve line(const Vector2d& a, const Vector2d& b) {
    return [=](double s) -> Vector2d { return a + s * (b - a); };
}

/// The strips around a middle.
class Layout {
  public:
    Layout(const StarSurface& surface, Middle middle,
           const std::vector<std::vector<SideEdge>>& edges)
        : surface_(surface),
          star_(surface.star()),
          middle_(std::move(middle)),
          edges_(edges),
          reach_(star_.f_y() + star_.inner() * std::sin(star_.alpha())),
          strips_(star_.border(0) > star_.inner()) {
        result_.inner_vertices = middle_.vertices;
        result_.inner_edges = middle_.edges;
        for (int m = 0; strips_ && m < star_.n(); ++m) {
            add_corner(m);
        }
        for (int m = 0; strips_ && m < star_.n(); ++m) {
            add_border(m);
        }
        for (int m = 0; strips_ && m < star_.n(); ++m) {
            add_strip(m);
        }
        std::move(middle_.patches.begin(), middle_.patches.end(),
                  std::back_inserter(result_.patches));
    }

    [[nodiscard]] FillResult take() { return std::move(result_); }

  private:
    const StarSurface& surface_;
    const Star& star_;
    Middle middle_;
    const std::vector<std::vector<SideEdge>>& edges_;
    double reach_;
    bool strips_;
    std::vector<Node> outer_corners_;  ///< that side m shares with side m + 1
    std::vector<int> mitres_;          ///< from K_m outwards
    std::vector<int> borders_;         ///< of a patch that stands for itself
    FillResult result_;

    [[nodiscard]] bool alone() const { return edges_.empty(); }
    [[nodiscard]] std::size_t index(int m) const {
        return static_cast<std::size_t>((m + star_.n()) % star_.n());
    }

    [[nodiscard]] int add_edge(const Node& from, const Node& to) {
        result_.inner_edges.push_back({from, to});
        return static_cast<int>(result_.inner_edges.size()) - 1;
    }

    /// The outer corner of the mitre between the sides m and m + 1, and the mitre.
    void add_corner(int m) {
        Node corner{0, 0};
        if (alone()) {
            const Vector2d at(star_.border(m), upper_end(star_, m));
            corner = {-1, static_cast<int>(result_.inner_vertices.size())};
            result_.inner_vertices.push_back(
                evaluate(border_spline(surface_, m), at.x(), at.y()).point);
        } else {
            corner.index = edges_[index(m + 1)].front().ribbon;
        }
        outer_corners_.push_back(corner);
        mitres_.push_back(add_edge({-1, middle_.corners[index(m)]}, corner));
    }

    void add_border(int m) {
        if (alone()) {
            borders_.push_back(add_edge(outer_corners_[index(m - 1)], outer_corners_[index(m)]));
        }
    }

    void add_strip(int m) {
        const double inner = star_.inner();
        const double border = star_.border(m);
        const Vector2d upper(border, upper_end(star_, m));
        const Vector2d lower(border, lower_end(star_, m));
        Patch patch;
        patch.surface = border_spline(surface_, m);
        std::vector<EdgeUse>& wire = patch.wires.emplace_back();
        if (alone()) {
            wire.push_back({-1, borders_[index(m)], false, line(lower, upper)});
        } else {
            for (const SideEdge& edge : edges_[index(m)]) {
                wire.push_back({0, edge.ribbon, false, [border, y = edge.y](double s) -> Vector2d {
                                    return {border, y(s)};
                                }});
            }
        }
        wire.push_back({-1, mitres_[index(m)], true, line({inner, reach_}, upper)});
        const std::vector<Middle::Outer>& outer = middle_.outer[index(m)];
        for (auto it = outer.rbegin(); it != outer.rend(); ++it) {
            const Vector2d from(inner, it->from);
            const Vector2d to(inner, it->to);
            // The strip's outline runs down here.
            wire.push_back(
                {-1, it->edge, !it->backwards, it->backwards ? line(to, from) : line(from, to)});
        }
        wire.push_back({-1, mitres_[index(m - 1)], false, line({inner, -reach_}, lower)});
        result_.patches.push_back(std::move(patch));
    }
};

}  // namespace

double upper_end(const Star& star, int m) {
    return star.f_y() + std::sin(star.alpha()) * star.border(m + 1);
}

double lower_end(const Star& star, int m) {
    return -star.f_y() - std::sin(star.alpha()) * star.border(m - 1);
}

SplineSurface border_spline(const StarSurface& surface, int m) {
    const Star& star = surface.star();
    SplineSurface spline;
    spline.degree_u = spline.degree_v = star.degree();
    spline.knots_u = star.knots_x(m);
    spline.knots_v = star.knots_y(m);
    spline.poles.resize(3, star.charts_x() * star.charts_y(m));
    for (int j = 0; j < star.charts_y(m); ++j) {
        for (int i = 0; i < star.charts_x(); ++i) {
            spline.poles.col(spline.index(i, j)) = surface.points().col(star.point_of(m, i, j));
        }
    }
    return restricted(spline, star.inner(), star.border(m), lower_end(star, m), upper_end(star, m));
}

FillResult lay_out(const StarSurface& surface, Middle middle,
                   const std::vector<std::vector<SideEdge>>& edges) {
    return Layout(surface, std::move(middle), edges).take();
}

}  // namespace suture::manifold

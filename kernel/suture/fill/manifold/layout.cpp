#include "suture/fill/manifold/layout.h"

#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;

TrimCurve line(const Vector2d& a, const Vector2d& b) {
    return [=](double s) -> Vector2d { return a + s * (b - a); };
}

/// Numbers of the inner vertices and edges, side by side.
class Numbers {
  public:
    explicit Numbers(int n) : n_(n) {}

    [[nodiscard]] Node middle() const { return {-1, 0}; }
    [[nodiscard]] Node on_spoke(int m) const { return {-1, 1 + wrap(m)}; }
    [[nodiscard]] Node inner_corner(int m) const { return {-1, 1 + n_ + wrap(m)}; }
    [[nodiscard]] Node outer_corner(int m) const { return {-1, 1 + 2 * n_ + wrap(m)}; }

    [[nodiscard]] int spoke(int m) const { return wrap(m); }
    [[nodiscard]] int upper_half(int m) const { return n_ + wrap(m); }      ///< A_m to K_m
    [[nodiscard]] int lower_half(int m) const { return 2 * n_ + wrap(m); }  ///< A_m to K_(m-1)
    [[nodiscard]] int mitre(int m) const { return 3 * n_ + wrap(m); }       ///< from K_m outwards
    [[nodiscard]] int border(int m) const { return 4 * n_ + wrap(m); }

  private:
    int n_;
    [[nodiscard]] int wrap(int m) const { return ((m % n_) + n_) % n_; }
};

class Layout {
  public:
    Layout(const StarSurface& surface, const Centre& centre,
           const std::vector<std::vector<SideEdge>>& edges)
        : surface_(surface),
          star_(surface.star()),
          centre_(centre),
          edges_(edges),
          numbers_(star_.n()),
          reach_(star_.f_y() + star_.inner() * std::sin(star_.alpha())),
          strips_(star_.border(0) > star_.inner()) {
        add_vertices();
        add_edges();
        for (int m = 0; strips_ && m < star_.n(); ++m) {
            add_strip(m);
        }
        for (int m = 0; m < star_.n(); ++m) {
            add_quad(m);
        }
    }

    [[nodiscard]] FillResult take() { return std::move(result_); }

  private:
    const StarSurface& surface_;
    const Star& star_;
    const Centre& centre_;
    const std::vector<std::vector<SideEdge>>& edges_;
    Numbers numbers_;
    double reach_;
    bool strips_;
    FillResult result_;

    [[nodiscard]] bool alone() const { return edges_.empty(); }

    /// The corner that side m shares with side m + 1.
    [[nodiscard]] Node outer_corner(int m) const {
        return alone()
                   ? numbers_.outer_corner(m)
                   : Node{0, edges_[static_cast<std::size_t>((m + 1) % star_.n())].front().ribbon};
    }

    void add_vertices() {
        const auto add = [&](int m, double x, double y) {
            result_.inner_vertices.push_back(surface_.at(star_.from_side(m, {x + star_.mu(y), y})));
        };
        result_.inner_vertices.push_back(surface_.at(Vector2d::Zero()));
        for (int m = 0; m < star_.n(); ++m) {
            add(m, star_.inner(), 0.0);
        }
        for (int m = 0; m < star_.n(); ++m) {
            add(m, star_.inner(), reach_);
        }
        for (int m = 0; alone() && strips_ && m < star_.n(); ++m) {
            // Just inside: knot intervals are half-open.
            const SurfaceJet corner =
                evaluate(border_spline(surface_, m), star_.border(m), upper_end(star_, m));
            result_.inner_vertices.push_back(corner.point);
        }
    }

    void add_edges() {
        const int n = star_.n();
        for (int m = 0; m < n; ++m) {
            result_.inner_edges.push_back({numbers_.middle(), numbers_.on_spoke(m)});
        }
        for (int m = 0; m < n; ++m) {
            result_.inner_edges.push_back({numbers_.on_spoke(m), numbers_.inner_corner(m)});
        }
        for (int m = 0; m < n; ++m) {
            result_.inner_edges.push_back({numbers_.on_spoke(m), numbers_.inner_corner(m - 1)});
        }
        for (int m = 0; strips_ && m < n; ++m) {
            result_.inner_edges.push_back({numbers_.inner_corner(m), outer_corner(m)});
        }
        for (int m = 0; strips_ && alone() && m < n; ++m) {
            result_.inner_edges.push_back({outer_corner(m - 1), outer_corner(m)});
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
            wire.push_back({-1, numbers_.border(m), false, line(lower, upper)});
        } else {
            for (const SideEdge& edge : edges_[static_cast<std::size_t>(m)]) {
                wire.push_back({0, edge.ribbon, false, [border, y = edge.y](double s) -> Vector2d {
                                    return {border, y(s)};
                                }});
            }
        }
        wire.push_back({-1, numbers_.mitre(m), true, line({inner, reach_}, upper)});
        wire.push_back({-1, numbers_.upper_half(m), true, line({inner, 0.0}, {inner, reach_})});
        wire.push_back({-1, numbers_.lower_half(m), false, line({inner, 0.0}, {inner, -reach_})});
        wire.push_back({-1, numbers_.mitre(m - 1), false, line({inner, -reach_}, lower)});
        result_.patches.push_back(std::move(patch));
    }

    void add_quad(int m) {
        const Vector2d o(0.0, 0.0);
        const Vector2d u(1.0, 0.0);
        const Vector2d v(0.0, 1.0);
        const Vector2d uv(1.0, 1.0);
        Patch patch;
        patch.surface = centre_.quads[static_cast<std::size_t>(m)];
        patch.exact = false;
        patch.fit_error = centre_.error;
        patch.wires = {{{-1, numbers_.spoke(m), false, line(o, u)},
                        {-1, numbers_.upper_half(m), false, line(u, uv)},
                        {-1, numbers_.lower_half(m + 1), true, line(v, uv)},
                        {-1, numbers_.spoke(m + 1), true, line(o, v)}}};
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

FillResult lay_out(const StarSurface& surface, const Centre& centre,
                   const std::vector<std::vector<SideEdge>>& edges) {
    return Layout(surface, centre, edges).take();
}

}  // namespace suture::manifold

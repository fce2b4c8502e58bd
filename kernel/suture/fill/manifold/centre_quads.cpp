#include "suture/fill/manifold/centre.h"

namespace suture::manifold {
namespace {

using Eigen::Vector2d;

TrimCurve line(const Vector2d& a, const Vector2d& b) {
    return [=](double s) -> Vector2d { return a + s * (b - a); };
}

}  // namespace

Middle quads_of(const StarSurface& surface, const Centre& centre) {
    const Star& star = surface.star();
    const int n = star.n();
    const double reach = star.f_y() + star.inner() * std::sin(star.alpha());
    const auto wrap = [n](int m) { return (m + n) % n; };
    // Vertices: O, the A_m, the K_m; edges: the spokes, A_m to K_m, A_m to K_(m-1).
    const auto on_spoke = [&](int m) { return Node{-1, 1 + wrap(m)}; };
    const auto corner = [&](int m) { return Node{-1, 1 + n + wrap(m)}; };
    const auto spoke = [&](int m) { return wrap(m); };
    const auto upper_half = [&](int m) { return n + wrap(m); };
    const auto lower_half = [&](int m) { return 2 * n + wrap(m); };

    Middle middle;
    middle.vertices.push_back(surface.at(Vector2d::Zero()));
    for (const double y : {0.0, reach}) {
        for (int m = 0; m < n; ++m) {
            middle.vertices.push_back(
                surface.at(star.from_side(m, {star.inner() + star.mu(y), y})));
        }
    }
    for (int m = 0; m < n; ++m) {
        middle.edges.push_back({{-1, 0}, on_spoke(m)});
    }
    for (int m = 0; m < n; ++m) {
        middle.edges.push_back({on_spoke(m), corner(m)});
    }
    for (int m = 0; m < n; ++m) {
        middle.edges.push_back({on_spoke(m), corner(m - 1)});
    }
    for (int m = 0; m < n; ++m) {
        const Vector2d o(0.0, 0.0);
        const Vector2d u(1.0, 0.0);
        const Vector2d v(0.0, 1.0);
        const Vector2d uv(1.0, 1.0);
        Patch patch;
        patch.surface = centre.quads[static_cast<std::size_t>(m)];
        patch.exact = false;
        patch.fit_error = centre.error;
        patch.wires = {{{-1, spoke(m), false, line(o, u)},
                        {-1, upper_half(m), false, line(u, uv)},
                        {-1, lower_half(m + 1), true, line(v, uv)},
                        {-1, spoke(m + 1), true, line(o, v)}}};
        middle.patches.push_back(std::move(patch));
        middle.outer.push_back(
            {{lower_half(m), -reach, 0.0, true}, {upper_half(m), 0.0, reach, false}});
        middle.corners.push_back(corner(m).index);
    }
    return middle;
}

}  // namespace suture::manifold

#include "suture/fill/quad.h"

#include "support/ribbon_zoo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Hole at_position(Hole hole) {
    for (Ribbon& ribbon : hole.loops[0].ribbons) {
        ribbon.continuity = Continuity::G0;
    }
    return hole;
}

// The same hole with its sides numbered from another one on, at another scale.
Hole turned(Hole hole, int first, double scale) {
    std::vector<Ribbon>& ribbons = hole.loops[0].ribbons;
    std::rotate(ribbons.begin(), ribbons.begin() + first, ribbons.end());
    for (Ribbon& ribbon : ribbons) {
        ribbon.at = [at = ribbon.at, scale](double s) {
            RibbonPoint p = at(s);
            p.point *= scale;
            p.tangent *= scale;
            p.curvature /= scale;
            return p;
        };
    }
    hole.diameter *= scale;
    return hole;
}

double gap_of(const Hole& hole, const FillResult& fill) {
    const auto& surface = std::get<SplineSurface>(fill.patches[0].surface);
    double gap = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (int k = 0; k <= 97; ++k) {
            const Vector2d uv = fill.patches[0].wires[0][i].at(k / 97.0);
            gap = std::max(gap, (evaluate(surface, uv.x(), uv.y()).point -
                                 hole.loops[0].ribbons[i].at(k / 97.0).point)
                                    .norm());
        }
    }
    return gap;
}

// A flank of a screw: straight lines from an inner helix to an outer one that climbs otherwise.
zoo::Surface flank() {
    return [](const zoo::Jet& u, const zoo::Jet& v) {
        const zoo::Jet radius = zoo::Jet(1.0) + v;
        return zoo::Point{radius * cos(u), radius * sin(u), zoo::Jet(0.3) * u + zoo::Jet(0.2) * v};
    };
}

TEST(FillQuad, GivesRuledSurfacesBack) {
    const std::vector<std::pair<zoo::Surface, std::vector<Vector2d>>> ruled = {
        {flank(), {{0.0, 0.0}, {2.5, 0.0}, {2.5, 1.0}, {0.0, 1.0}}},
        {zoo::cylinder(2.0), {{0.0, 0.0}, {2.8, 0.0}, {2.8, 9.0}, {0.0, 9.0}}}};
    for (const auto& [surface, corners] : ruled) {
        for (const double scale : {1e-3, 1.0, 1e3}) {
            for (const int first : {0, 1, 3}) {
                const Hole hole =
                    turned(at_position(zoo::window(surface, zoo::polygon(corners))), first, scale);
                FillOptions options;
                options.tolerance.linear = 1e-3 * scale;
                const auto fill = fill_quad(hole, options);
                ASSERT_TRUE(fill) << fill.error().message;
                EXPECT_LT(gap_of(hole, *fill), 2e-5 * scale);
                const auto& face = std::get<SplineSurface>(fill->patches[0].surface);
                for (const double u : {0.1, 0.45, 0.9}) {
                    for (const double v : {0.2, 0.5, 0.77}) {
                        const Vector3d p = evaluate(face, u, v).point / scale;
                        EXPECT_LT(zoo::distance(surface, p, {-0.5, -0.5}, {3.0, 9.5}), 1e-4);
                    }
                }
            }
        }
    }
}

TEST(FillQuad, FacesTheWayItsNeighboursDo) {
    const Hole hole = at_position(
        zoo::window(zoo::cylinder(2.0), zoo::polygon({{0, 0}, {2.8, 0}, {2.8, 9}, {0, 9}})));
    const auto fill = fill_quad(hole, {});
    ASSERT_TRUE(fill) << fill.error().message;
    const SurfaceJet jet = evaluate(std::get<SplineSurface>(fill->patches[0].surface), 0.5, 0.5);
    EXPECT_GT(jet.u.cross(jet.v).dot(Vector3d(jet.point.x(), jet.point.y(), 0.0)), 0.0);
}

TEST(FillQuad, SaysWhichSideItIsNotTangentTo) {
    const auto corners = zoo::polygon({{-0.4, -0.4}, {0.4, -0.4}, {0.4, 0.4}, {-0.4, 0.4}});
    const auto dome = fill_quad(zoo::window(zoo::sphere(1.0), corners), {});
    ASSERT_FALSE(dome);
    EXPECT_NE(dome.error().message.find("edge 1"), std::string::npos) << dome.error().message;
    EXPECT_TRUE(fill_quad(zoo::window(zoo::cylinder(1.0), corners), {}));
}

TEST(FillQuad, RefusesWhatIsNoQuad) {
    const Hole five = zoo::window(zoo::sphere(1.0), zoo::regular({0, 0}, 0.5, 5), Continuity::G0);
    EXPECT_FALSE(fill_quad(five, {}));
    // A straight angle is no corner.
    const Hole flat = zoo::window(zoo::cylinder(1.0),
                                  zoo::polygon({{0, 0}, {1, 0}, {2, 0}, {1, 2}}), Continuity::G0);
    const auto refused = fill_quad(flat, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("no corner"), std::string::npos);
    // Bent so far inwards that opposite sides cross over each other.
    const Hole folded =
        zoo::window(zoo::graph([](const zoo::Jet& x, const zoo::Jet& y) { return 0.0 * x * y; }),
                    zoo::polygon({{0, 0}, {4, 0}, {0.2, 0.2}, {0, 4}}), Continuity::G0);
    EXPECT_FALSE(fill_quad(folded, {}));
}

}  // namespace
}  // namespace suture

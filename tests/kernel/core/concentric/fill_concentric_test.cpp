#include "support/ribbon_zoo.h"
#include "support/windows.h"
#include "suture/fill/concentric.h"

#include "kernel/core/concentric/shapes.h"
#include <gtest/gtest.h>

#include <map>

namespace suture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// How well the patches meet the ribbons and each other.
struct Fit {
    double gap = 0.0;
    double angle = 0.0;        ///< to the ribbons' normals
    double inner_gap = 0.0;    ///< between the two uses of an inner edge
    double inner_angle = 0.0;  ///< away from its ends
    double seam_angle = 0.0;   ///< likewise, of the edges that start in a corner of the hole
};

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vector3d normal_at(const Surface& surface, const Vector2d& uv) {
    const SurfaceJet jet = evaluate(surface, uv.x(), uv.y());
    return jet.u.cross(jet.v).normalized();
}

Vector3d point_at(const Surface& surface, const Vector2d& uv) {
    return evaluate(surface, uv.x(), uv.y()).point;
}

void measure_side(const Ribbon& ribbon, const Patch& patch, const EdgeUse& use, Fit& fit) {
    for (int k = 1; k < 40; ++k) {
        const RibbonPoint p = ribbon.at(k / 40.0);
        const Vector2d uv = use.at(k / 40.0);
        fit.gap = std::max(fit.gap, (point_at(patch.surface, uv) - p.point).norm());
        fit.angle = std::max(fit.angle, angle_between(normal_at(patch.surface, uv), p.normal));
    }
}

Fit fit_of(const Hole& hole, const FillResult& fill) {
    Fit fit;
    std::map<int, std::vector<std::pair<const Patch*, const EdgeUse*>>> inner;
    for (const Patch& patch : fill.patches) {
        for (const EdgeUse& use : patch.wires.front()) {
            if (use.loop < 0) {
                inner[use.index].emplace_back(&patch, &use);
                continue;
            }
            measure_side(hole.loops[0].ribbons[static_cast<std::size_t>(use.index)], patch, use,
                         fit);
        }
    }
    EXPECT_EQ(inner.size(), fill.inner_edges.size());
    for (const auto& [index, uses] : inner) {
        const InnerEdge& edge = fill.inner_edges[static_cast<std::size_t>(index)];
        EXPECT_EQ(uses.size(), 2U);
        EXPECT_NE(uses[0].second->backwards, uses[1].second->backwards);
        for (int k = 0; k <= 20; ++k) {
            const double s = k / 20.0;
            Vector3d points[2];
            Vector3d normals[2];
            for (int i = 0; i < 2; ++i) {
                const auto& [patch, use] = uses[static_cast<std::size_t>(i)];
                points[i] = point_at(patch->surface, use->at(s));
                Vector2d uv = use->at(s);
                uv.x() = std::min(uv.x(), 1.0 - 1e-5);
                normals[i] = normal_at(patch->surface, uv);
            }
            fit.inner_gap = std::max(fit.inner_gap, (points[0] - points[1]).norm());
            if (k > 0 && k < 20) {
                double& angle = edge.from.loop >= 0 ? fit.seam_angle : fit.inner_angle;
                angle = std::max(angle, angle_between(normals[0], normals[1]));
            }
            const Node& end = s < 0.5 ? edge.from : edge.to;
            if ((k == 0 || k == 20) && end.loop < 0) {
                const Vector3d& vertex = fill.inner_vertices[static_cast<std::size_t>(end.index)];
                fit.inner_gap = std::max(fit.inner_gap, (points[0] - vertex).norm());
            }
        }
    }
    return fit;
}

/// A polygon in a tilted plane, as the end of a prism: its walls are across.
Hole opening(const shapes::Points& points, double scale = 1.0) {
    const Frame frame = windows::tilted(scale);
    Hole hole;
    auto& ribbons = hole.loops.emplace_back().ribbons;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector2d a = scale * points[i];
        const Vector2d b = scale * points[(i + 1) % points.size()];
        Ribbon ribbon;
        ribbon.edge = ribbon.face = static_cast<int>(i) + 1;
        ribbon.continuity = Continuity::G0;
        ribbon.at = [=](double s) {
            const Vector2d p = (1.0 - s) * a + s * b;
            RibbonPoint point;
            point.point = frame.origin + p.x() * frame.x + p.y() * frame.y;
            point.tangent = (b - a).x() * frame.x + (b - a).y() * frame.y;
            point.inward = frame.z;
            point.normal = point.tangent.normalized().cross(frame.z);
            point.curvature.setZero();
            return point;
        };
        SplineCurve line{1, {0, 0, 1, 1}, Eigen::MatrixXd(3, 2)};
        line.poles << ribbon.at(0.0).point, ribbon.at(1.0).point;
        ribbon.curve = line;
        ribbons.push_back(ribbon);
    }
    hole.diameter = windows::diameter_of(hole);
    return hole;
}

/// Within 0.01 degrees along the hole's own edges, 0.02 along all others.
void expect_smooth(const Hole& hole, double scale) {
    FillOptions options;
    options.tolerance.linear *= scale;
    const auto fill = fill_concentric(hole, options);
    ASSERT_TRUE(fill) << fill.error().message;
    const Fit fit = fit_of(hole, *fill);
    EXPECT_LT(fit.gap, 1e-6 * scale);
    EXPECT_LT(degrees(fit.angle), 0.01);
    EXPECT_LT(fit.inner_gap, 1e-6 * scale);
    EXPECT_LT(degrees(fit.inner_angle), 0.001);
    EXPECT_LT(degrees(fit.seam_angle), 0.02);
}

FillOptions with_faces(const std::string& word) {
    FillOptions options;
    options.own["faces"] = {OptionKind::Word, {}, word};
    return options;
}

TEST(FillConcentric, CapsPolygonsWithOneFaceForEachSide) {
    for (const auto& points : {shapes::rectangle(), shapes::letter_l(), shapes::letter_t(),
                               shapes::arrow(), shapes::pentagon(), shapes::comb(4, 2.0)}) {
        for (const double scale : {1e-3, 1.0, 1e3}) {
            const Hole hole = opening(points, scale);
            const auto fill = fill_concentric(hole, {});
            ASSERT_TRUE(fill) << fill.error().message;
            EXPECT_EQ(fill->patches.size(), points.size());
            const Fit fit = fit_of(hole, *fill);
            EXPECT_LT(fit.gap, 1e-14 * 20.0 * scale);
            EXPECT_LT(fit.inner_gap, 1e-12 * scale);
            EXPECT_LT(fit.inner_angle, 1e-6);
            EXPECT_LT(fit.seam_angle, 1e-6);
            for (const Patch& patch : fill->patches) {
                EXPECT_TRUE(patch.exact);
                const auto& spline = std::get<SplineSurface>(patch.surface);
                EXPECT_EQ(spline.degree_u, 1);
                EXPECT_EQ(spline.degree_v, 1);
                const Vector3d n = normal_at(patch.surface, {0.37, spline.knots_v.front() + 0.4});
                EXPECT_LT(angle_between(n, windows::tilted().z), 1e-6);
            }
        }
    }
}

TEST(FillConcentric, CapsWithOneFaceForAllSides) {
    auto star = shapes::rectangle();
    star.clear();
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 10.0 : 5.0;
        star.emplace_back(radius * std::cos(kPi * i / 5.0), radius * std::sin(kPi * i / 5.0));
    }
    for (const auto& points : {shapes::rectangle(), shapes::letter_t(), shapes::arrow(), star}) {
        const Hole hole = opening(points);
        const auto fill = fill_concentric(hole, with_faces("one"));
        ASSERT_TRUE(fill) << fill.error().message;
        ASSERT_EQ(fill->patches.size(), 1U);
        const Fit fit = fit_of(hole, *fill);
        EXPECT_LT(fit.gap, 1e-13);
        EXPECT_LT(fit.inner_gap, 2e-11);  // one use of an edge of the axis is moved by 1e-12
    }
}

FillOptions with_axis(const std::string& word) {
    FillOptions options;
    options.own["axis"] = {OptionKind::Word, {}, word};
    return options;
}

TEST(FillConcentric, TakesThePapersOwnAxisWhereItsMapDoesNotFold) {
    for (const auto* word : {"basic", "moved"}) {
        for (const auto& points : {shapes::rectangle(), shapes::letter_l(), shapes::letter_t()}) {
            const Hole hole = opening(points);
            const auto fill = fill_concentric(hole, with_axis(word));
            ASSERT_TRUE(fill) << fill.error().message;
            EXPECT_EQ(fill->patches.size(), points.size());
            const Fit fit = fit_of(hole, *fill);
            EXPECT_LT(fit.gap, 1e-13);
            EXPECT_LT(fit.inner_gap, 1e-11);
        }
        const auto folded = fill_concentric(opening(shapes::folding()), with_axis(word));
        ASSERT_FALSE(folded);
        EXPECT_EQ(folded.error().code, ErrorCode::Refused);
        EXPECT_NE(folded.error().message.find("map folds between s = "), std::string::npos)
            << folded.error().message;
    }
}

TEST(FillConcentric, CapsAClosedEdgeWithAPole) {
    const Plane plane{windows::tilted()};
    for (const int sides : {1, 2, 5}) {
        for (const double width : {1.0, 2.5}) {
            Hole hole = windows::window_in(plane, {{4, -2}, {3, 3 * width}, sides, false});
            const auto fill = fill_concentric(hole, {});
            ASSERT_TRUE(fill) << fill.error().message;
            EXPECT_EQ(fill->patches.size(), static_cast<std::size_t>(sides));
            const Fit fit = fit_of(hole, *fill);
            EXPECT_LT(fit.gap, 1e-6);
            EXPECT_NEAR(fit.gap, fill->patches.front().fit_error, fill->patches.front().fit_error);
            EXPECT_LT(fit.angle, 1e-6);
            EXPECT_LT(fit.inner_gap, 2e-11);  // likewise
        }
    }
}

TEST(FillConcentric, ClosesGentlyCurvedHolesTangentToTheirNeighbours) {
    const std::pair<std::string, zoo::Surface> surfaces[] = {
        {"paraboloid", zoo::graph([](const zoo::Jet& u, const zoo::Jet& v) {
             return zoo::Jet(0.3) * u * u + zoo::Jet(0.1) * u * v - zoo::Jet(0.2) * v * v;
         })},
        {"saddle", zoo::saddle(0.4)},
        {"wavy", zoo::wavy(0.05, 2.0)}};
    for (const auto& [name, surface] : surfaces) {
        SCOPED_TRACE(name);
        for (const auto& curves :
             {zoo::star({0.1, 0.2}, 0.8, 0.2, 3, 4), zoo::regular({0, 0}, 0.9, 5),
              zoo::concave({0, 0}, 0.7), zoo::circle({0, 0}, 0.7, 1)}) {
            expect_smooth(zoo::window(surface, curves), 1.0);
        }
    }
}

TEST(FillConcentric, ClosesASuitcaseCornerSmoothly) {
    for (const double radius : {1e-3, 1.0, 1e3}) {
        expect_smooth(zoo::suitcase_corner(radius), radius);
    }
}

TEST(FillConcentric, ClosesWhatIsLeftOfASphereSmoothly) {
    for (const int sides : {1, 3}) {
        expect_smooth(zoo::sphere_cap(2.0, 0.9, sides), 1.0);
    }
}

/// A circle in four cubics that are no circle: the sides are polynomials.
TEST(FillConcentric, KeepsTheEdgesOwnCurvesAndParameters) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        const Frame frame = windows::tilted(scale);
        Hole hole;
        auto& ribbons = hole.loops.emplace_back().ribbons;
        for (int i = 0; i < 4; ++i) {
            const double a = 0.5 * kPi * i;
            const Vector3d x = std::cos(a) * frame.x + std::sin(a) * frame.y;
            const Vector3d y = std::cos(a) * frame.y - std::sin(a) * frame.x;
            SplineCurve curve{3, {0, 0, 0, 0, 0.3, 1, 1, 1, 1}, Eigen::MatrixXd(3, 5)};
            curve.poles << 2.0 * x, 2.0 * x + 0.3 * y, 1.7 * x + 1.5 * y, 1.1 * x + 2.0 * y,
                2.0 * y;
            curve.poles = (scale * curve.poles).colwise() + frame.origin;
            Ribbon ribbon;
            ribbon.edge = ribbon.face = i + 1;
            ribbon.continuity = Continuity::G0;
            ribbon.curve = curve;
            ribbon.at = [=](double s) {
                const Eigen::MatrixXd jet = evaluate(curve, s, 1);
                RibbonPoint point;
                point.point = jet.col(0);
                point.tangent = jet.col(1);
                point.inward = frame.z;
                point.normal = point.tangent.normalized().cross(frame.z);
                point.curvature.setZero();
                return point;
            };
            ribbons.push_back(ribbon);
        }
        hole.diameter = windows::diameter_of(hole);
        for (const char* faces : {"regions", "one"}) {
            const auto fill = fill_concentric(hole, with_faces(faces));
            ASSERT_TRUE(fill) << fill.error().message;
            EXPECT_LT(fit_of(hole, *fill).gap, 1e-14 * 4.0 * scale);
            EXPECT_TRUE(fill->patches.front().exact);
        }
    }
}

TEST(FillConcentric, RefusesIslandsPointsAndWhatNoSurfaceMeets) {
    const Plane plane{windows::tilted()};
    Hole hole = windows::window_in(plane, {{0, 0}, {3, 2}, 4, false});
    hole.loops.push_back(windows::window_in(plane, {{0, 0}, {1, 1}, 2, true}).loops[0]);
    hole.loops[1].ribbons[0].edge = 77;
    const auto island = fill_concentric(hole, {});
    ASSERT_FALSE(island);
    EXPECT_NE(island.error().message.find("edge 77"), std::string::npos) << island.error().message;

    Hole through = opening(shapes::rectangle());
    through.through.push_back({});
    EXPECT_FALSE(fill_concentric(through, {}));

    // The sides beside it run straight away from the wall, as no surface tangent to it does.
    Hole steep = opening(shapes::rectangle());
    steep.loops[0].ribbons[2].continuity = Continuity::G1;
    const auto lean = fill_concentric(steep, {});
    ASSERT_FALSE(lean);
    EXPECT_NE(lean.error().message.find("edge 3 (face 3)"), std::string::npos)
        << lean.error().message;
    EXPECT_NE(lean.error().message.find("90.0 deg"), std::string::npos) << lean.error().message;
}

}  // namespace
}  // namespace suture

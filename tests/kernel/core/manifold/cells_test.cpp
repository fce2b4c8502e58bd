#include "suture/fill/manifold/cells.h"

#include "suture/base/tolerance.h"
#include "suture/fill/manifold/layout.h"
#include "suture/fill/manifold/make_middle.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "kernel/core/manifold/support.h"

#include <algorithm>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::make_star;
using test::rough_points;
using test::uneven;

double diameter(const Eigen::Matrix3Xd& points) {
    return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// Twice the area to the left of an edge's use, by Simpson's rule.
double area_under(const Arrangement& cells, const Arrangement::Use& use) {
    const PlaneCurve& c = cells.edges[static_cast<std::size_t>(use.edge)].curve;
    const auto sweep = [&](double t) {
        const Vector2d p = c.at(t);
        const Vector2d d = c.tangent(t);
        return p.x() * d.y() - p.y() * d.x();
    };
    const double area =
        (c.to - c.from) / 6.0 * (sweep(c.from) + 4.0 * sweep(0.5 * (c.from + c.to)) + sweep(c.to));
    return use.backwards ? -area : area;
}

TEST(ManifoldCells, CoverTheMiddleOnce) {
    for (const int n : {3, 4, 5, 6, 7}) {
        for (const int k : {0, 1}) {
            const Star star = make_star(uneven(k, n));
            const auto cells = find_cells(star);
            ASSERT_TRUE(cells) << cells.error().message;
            std::vector<int> uses(cells->edges.size(), 0);
            double sum = 0.0;
            for (const auto& cell : cells->cells) {
                double area = 0.0;
                for (const Arrangement::Use& use : cell) {
                    area += area_under(*cells, use);
                    ++uses[static_cast<std::size_t>(use.edge)];
                }
                EXPECT_GT(area, 0.0);
                sum += area;
            }
            // Of the whole: 2 n times the piece of a side between its v_m and the next corner.
            const double reach = star.f_y() + star.inner() * std::sin(star.alpha());
            double whole = 0.0;
            constexpr int kSteps = 20000;
            for (int a = 0; a < kSteps; ++a) {
                const double y = reach * (a + 0.5) / kSteps;
                const double ray = y / std::tan(star.alpha() / 2.0);
                whole += 2.0 * star.n() * (star.inner() + star.mu(y) - ray) * reach / kSteps;
            }
            EXPECT_NEAR(sum, 2.0 * whole, 1e-6 * whole) << "n = " << n << ", k = " << k;
            EXPECT_LE(*std::max_element(uses.begin(), uses.end()), 2);
            const auto v = static_cast<int>(cells->vertices.size());
            const auto e = static_cast<int>(cells->edges.size());
            const auto f = static_cast<int>(cells->cells.size());
            EXPECT_EQ(v - e + f, 1) << "n = " << n << ", k = " << k;
        }
    }
}

/// How a patch's domain lies in X: the affine map that takes its outline to the knot curves.
Eigen::Matrix<double, 2, 3> placement(const Patch& patch, const Arrangement& cells) {
    Eigen::Matrix3Xd from(3, 0);
    Eigen::Matrix2Xd to(2, 0);
    for (const EdgeUse& use : patch.wires.front()) {
        const PlaneCurve& c = cells.edges[static_cast<std::size_t>(use.index)].curve;
        for (const double s : {0.0, 0.5, 1.0}) {
            from.conservativeResize(3, from.cols() + 1);
            to.conservativeResize(2, from.cols());
            from.rightCols(1) << use.at(s), 1.0;
            to.rightCols(1) = c.at(c.from + s * (c.to - c.from));
        }
    }
    return (from * from.transpose()).ldlt().solve(from * to.transpose()).transpose();
}

TEST(ManifoldCells, AreTheSurfaceItself) {
    for (const int n : {3, 4, 5, 6, 7}) {
        for (const int k : {0, 1}) {
            const Star star = make_star(uneven(k, n));
            const StarSurface surface(star, rough_points(star));
            const auto cells = find_cells(star);
            const auto middle = make_cells(surface);
            ASSERT_TRUE(cells && middle) << middle.error().message;
            const double size = diameter(surface.points());
            ASSERT_EQ(middle->patches.size(), cells->cells.size());
            double worst = 0.0;
            double least = 1.0;
            for (const Patch& patch : middle->patches) {
                const auto& spline = std::get<SplineSurface>(patch.surface);
                const Eigen::Matrix<double, 2, 3> to_x = placement(patch, *cells);
                least = std::min(least, spline.weights.minCoeff() / spline.weights.maxCoeff());
                for (const EdgeUse& use : patch.wires.front()) {
                    const PlaneCurve& c = cells->edges[static_cast<std::size_t>(use.index)].curve;
                    for (int i = 0; i <= 10; ++i) {
                        const Vector2d at = use.at(i / 10.0);
                        const Vector2d p = c.at(c.from + i / 10.0 * (c.to - c.from));
                        worst = std::max(
                            worst, (evaluate(spline, at.x(), at.y()).point - surface.at(p)).norm());
                    }
                    // Inside, next to the middle of the edge.
                    const Vector2d a = use.at(0.499);
                    const Vector2d b = use.at(0.501);
                    const double turn = use.backwards ? -1.0 : 1.0;
                    const Vector2d in =
                        0.5 * (a + b) + turn * Vector2d(a.y() - b.y(), b.x() - a.x());
                    const Vector2d p = to_x * in.homogeneous();
                    worst = std::max(
                        worst, (evaluate(spline, in.x(), in.y()).point - surface.at(p)).norm());
                }
            }
            EXPECT_LT(worst, 1e-11 * size) << "n = " << n << ", k = " << k;
            EXPECT_GT(least, 0.1) << "n = " << n << ", k = " << k;
        }
    }
}

/// What is on both sides of every inner edge.
TEST(ManifoldCells, MeetEachOtherAndTheStripsExactly) {
    for (const int n : {3, 5, 6}) {
        const Star star = make_star(uneven(1, n));
        const StarSurface surface(star, rough_points(star));
        const auto made = make_middle(surface, MiddleForm::Cells, 0.0);
        ASSERT_TRUE(made) << made.error().message;
        EXPECT_TRUE(made->exact);
        const FillResult result = lay_out(surface, made->middle, {});
        std::vector<std::vector<std::pair<const SplineSurface*, const EdgeUse*>>> uses(
            result.inner_edges.size());
        for (const Patch& patch : result.patches) {
            EXPECT_TRUE(patch.exact);
            for (const EdgeUse& use : patch.wires.front()) {
                uses[static_cast<std::size_t>(use.index)].emplace_back(
                    &std::get<SplineSurface>(patch.surface), &use);
            }
        }
        const double size = diameter(surface.points());
        int single = 0;
        for (const auto& both : uses) {
            single += both.size() == 1 ? 1 : 0;
            ASSERT_TRUE(both.size() == 1 || both.size() == 2);
            for (int i = 0; both.size() == 2 && i <= 8; ++i) {
                const auto jet = [&](std::size_t which) {
                    const Vector2d at = both[which].second->at(i / 8.0);
                    return evaluate(*both[which].first, at.x(), at.y());
                };
                const SurfaceJet a = jet(0);
                const SurfaceJet b = jet(1);
                EXPECT_LT((a.point - b.point).norm(), 1e-11 * size);
                const Vector3d normal_a = a.u.cross(a.v).normalized();
                const Vector3d normal_b = b.u.cross(b.v).normalized();
                EXPECT_LT(degrees(normal_a.cross(normal_b).norm()), 1e-6);
                EXPECT_GT(normal_a.dot(normal_b), 0.0);
            }
        }
        EXPECT_EQ(single, n);
    }
}

TEST(ManifoldCells, AreRefusedWhereTheirDegreeIsTooHigh) {
    const Star star = make_star(uneven(2, 5));
    const auto made = make_middle(StarSurface(star, rough_points(star)), MiddleForm::Cells, 1.0);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message.find("degree 15"), std::string::npos) << made.error().message;
}

TEST(ManifoldCells, TakeThePlaceOfQuadsThatCannotFollowTheKinks) {
    for (const int k : {0, 1}) {
        const Star star = make_star(uneven(k, 5));
        const StarSurface surface(star, rough_points(star));
        const auto chosen = make_middle(surface, MiddleForm::Auto, 1e-6);
        ASSERT_TRUE(chosen);
        EXPECT_TRUE(chosen->exact);
        EXPECT_NE(chosen->note.find("off by"), std::string::npos) << chosen->note;
        const auto quads = make_middle(surface, MiddleForm::Quads, 1e-6);
        ASSERT_TRUE(quads);
        EXPECT_FALSE(quads->exact);
        EXPECT_GT(quads->error, 1e-6);
        EXPECT_FALSE(make_middle(surface, MiddleForm::Auto, 1e3)->exact);
    }
}

/// A parabola that touches a line, three lines through a point, and lines on each other.
TEST(ManifoldArrangement, CutsCurvesThatTouchAndLieOnEachOther) {
    std::vector<PlaneCurve> curves;
    const auto add = [&](const Vector2d& axis, double offset, double from, double to, double bend) {
        curves.push_back({axis.normalized(), offset, bend, from, to});
    };
    // A square of side 2, its lower side in two parts that overlap.
    add({0.0, -1.0}, 1.0, -1.0, 0.3, 0.0);
    add({0.0, -1.0}, 1.0, 0.1, 1.0, 0.0);
    add({1.0, 0.0}, 1.0, -1.0, 1.0, 0.0);
    add({0.0, 1.0}, 1.0, -1.0, 1.0, 0.0);
    add({-1.0, 0.0}, 1.0, -1.0, 1.0, 0.0);
    // Three lines through the middle, and a loose end.
    add({1.0, 0.0}, 0.0, -1.0, 1.0, 0.0);
    add({0.0, -1.0}, 0.0, -1.0, 1.0, 0.0);
    add({-1.0, 1.0}, 0.0, -std::sqrt(2.0), std::sqrt(2.0), 0.0);
    add({-1.0, 0.2}, 0.0, 0.0, 0.3, 0.0);
    // y = -1 + x^2 / 2 touches the lower side in its middle.
    add({0.0, 1.0}, -1.0, -1.0, 1.0, 0.5);
    const auto cells =
        arrange(curves, 2.0, [](const Vector2d& p) { return p.cwiseAbs().maxCoeff() < 1.01; });
    ASSERT_TRUE(cells) << cells.error().message;
    double sum = 0.0;
    for (const auto& cell : cells->cells) {
        for (const Arrangement::Use& use : cell) {
            sum += 0.5 * area_under(*cells, use);
        }
    }
    EXPECT_NEAR(sum, 4.0, 1e-12);
    // Six sectors, of which the parabola cuts the lower three.
    const auto v = static_cast<int>(cells->vertices.size());
    const auto e = static_cast<int>(cells->edges.size());
    const auto f = static_cast<int>(cells->cells.size());
    EXPECT_EQ(v - e + f, 1);
    EXPECT_EQ(f, 9);
}

TEST(ManifoldArrangement, RefusesEdgesTooShortForAModel) {
    std::vector<PlaneCurve> curves = {
        {{0.0, -1.0}, 1.0, 0.0, -1.0, 1.0}, {{1.0, 0.0}, 1.0, 0.0, -1.0, 1.0},
        {{0.0, 1.0}, 1.0, 0.0, -1.0, 1.0},  {{-1.0, 0.0}, 1.0, 0.0, -1.0, 1.0},
        {{1.0, 0.0}, 0.0, 0.0, -1.0, 1.0},  {{1.0, 0.0}, 1e-7, 0.0, -1.0, 1.0},
    };
    const auto cells = arrange(curves, 2.0, [](const Vector2d&) { return true; });
    ASSERT_FALSE(cells);
    EXPECT_NE(cells.error().message.find("another aperture"), std::string::npos);
}

}  // namespace
}  // namespace suture::manifold

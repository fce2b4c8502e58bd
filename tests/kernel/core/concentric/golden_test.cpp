#include "suture/fill/concentric/basic.h"
#include "suture/fill/concentric/certificate.h"
#include "suture/fill/concentric/map.h"

#include "kernel/core/concentric/shapes.h"
#include <gtest/gtest.h>

#include <map>

/// The numbers of an independent prototype for the paper's own algorithm.
namespace suture::concentric {
namespace {

using Eigen::Vector2d;

/// The paper's axis of a closed spline's control polygon.
ConcentricCurve basic(const ClosedSpline& curve, double widest = 0.05) {
    const auto sites = make_sites(curve.poles, nodal_parameters(curve), curve.period());
    EXPECT_TRUE(sites);
    const auto axis = medial_axis(*sites, widest);
    EXPECT_TRUE(axis);
    return basic_axis(*axis, *sites);
}

/// The integral of the Jacobian, exactly: that of polynomials.
double map_area(const ClosedSpline& curve, const ConcentricCurve& c) {
    const BoundaryPieces boundary(curve);
    double sum = 0.0;
    for (const Course& course : courses(c)) {
        for (const BezierPiece& gamma : boundary.between(course.from, course.to)) {
            BezierPiece piece{gamma.from, gamma.to, Eigen::MatrixXd(2, 2)};
            const auto at = [&](double s) -> Vector2d {
                const double f = (s - course.from) / (course.to - course.from);
                return (1.0 - f) * c.nodes[static_cast<std::size_t>(course.start)] +
                       f * c.nodes[static_cast<std::size_t>(course.end)];
            };
            piece.poles << at(gamma.from), at(gamma.to);
            const JacobianFactors factors = jacobian_factors(gamma, piece);
            sum += 0.5 * (gamma.to - gamma.from) * (factors.boundary.mean() + factors.axis.mean());
        }
    }
    return sum;
}

/// The least gamma' x (c - gamma), at samples.
double least_on_boundary(const ClosedSpline& curve, const ConcentricCurve& c) {
    const SplineCurve around = unrolled(curve);
    double least = INFINITY;
    constexpr int kSamples = 2000;
    for (int span = 0; span < curve.count(); ++span) {
        for (int k = 0; k < kSamples; ++k) {
            const double s = span + (k + 0.5) / kSamples;
            const Eigen::MatrixXd jet = evaluate(around, s, 1);
            const Vector2d spoke = evaluate(c, s) - Vector2d(jet.col(0));
            least = std::min(least, jet(0, 1) * spoke.y() - jet(1, 1) * spoke.x());
        }
    }
    return least;
}

struct Golden {
    std::string name;
    shapes::Points points;
    std::vector<Vector2d> nodes;
    double area;        ///< of the polygon
    double cubic_area;  ///< of the uniform cubic with it as control polygon
    double least;       ///< Jacobian on the boundary
};

std::vector<Golden> golden() {
    return {
        {"rectangle", shapes::rectangle(), {{1, 1}, {3, 1}}, 8, 5.42222222, 2},
        {"L", shapes::letter_l(), {{1.171573, 1.171573}, {5, 1}, {1, 4}}, 18, 13.65, 2},
        {"T", shapes::letter_t(), {{4, 1.25}, {7, 1}, {1, 1}, {4, 5}}, 24, 21.1, 2},
        {"arrow",
         shapes::arrow(),
         {{1.426408, 1.426408}, {6.573592, 1.426408}, {4, 0.75}},
         22,
         15.88888889,
         3},
        {"pentagon",
         shapes::pentagon(),
         {{1.588520, 1.799447}, {3.376762, 1.963629}, {3.885117, 1.691566}},
         30.5,
         23.65972222,
         6.56501},
        {"Z",
         shapes::letter_z(),
         {{2.828427, 1.171573}, {3.171573, 3.828427}, {1, 1}, {6, 4}},
         20,
         16.77777778,
         1.65685},
    };
}

std::vector<Vector2d> used(const ConcentricCurve& c) {
    std::map<int, Vector2d> nodes;
    for (const Stop& stop : c.stops) {
        nodes.insert_or_assign(stop.node, c.node(stop));
    }
    std::vector<Vector2d> result;
    for (const auto& [number, point] : nodes) {
        result.push_back(point);
    }
    return result;
}

TEST(BasicConcentricAxis, HasTheGoldenNodes) {
    for (const Golden& shape : golden()) {
        SCOPED_TRACE(shape.name);
        const std::vector<Vector2d> found = used(basic(shapes::polygon(shape.points)));
        EXPECT_EQ(found.size(), shape.nodes.size());
        for (const Vector2d& node : shape.nodes) {
            double nearest = INFINITY;
            for (const Vector2d& other : found) {
                nearest = std::min(nearest, (other - node).norm());
            }
            EXPECT_LT(nearest, 1e-6) << node.transpose();
        }
    }
}

TEST(BasicConcentricAxis, CoversExactlyTheGoldenArea) {
    for (const Golden& shape : golden()) {
        SCOPED_TRACE(shape.name);
        const ClosedSpline polygon = shapes::polygon(shape.points);
        const ClosedSpline cubic = shapes::spline(shape.points, 3);
        EXPECT_NEAR(map_area(polygon, basic(polygon)), shape.area, 1e-12 * shape.area);
        EXPECT_NEAR(map_area(cubic, basic(cubic)), shape.cubic_area, 1e-8);
        const auto robust = concentric_map(cubic);
        ASSERT_TRUE(robust) << robust.error().message;
        EXPECT_NEAR(map_area(cubic, robust->axis), shape.cubic_area, 1e-8);
        EXPECT_TRUE(folded_courses(BoundaryPieces(polygon), basic(polygon)).empty());
        EXPECT_NEAR(least_on_boundary(polygon, basic(polygon)), shape.least, 1e-2);
    }
}

TEST(BasicConcentricAxis, GivesTheTNinePointsWithTheInsertedOneAtOneHalf) {
    const ConcentricCurve c = basic(shapes::polygon(shapes::letter_t()));
    int points = 0;
    for (const Stop& stop : c.stops) {
        points += stop.to > stop.from ? 2 : 1;
    }
    EXPECT_EQ(points, 9);
    EXPECT_LT((evaluate(c, 0.5) - Vector2d(4, 1.25)).norm(), 1e-6);
    EXPECT_LT((evaluate(c, 0.49) - Vector2d(4, 1.25)).norm(), 0.1);
    EXPECT_GT((evaluate(c, 0.49) - Vector2d(4, 1.25)).norm(), 0.01);
}

/// The sheet of a long rectangle's polygon ends outside of its cubic.
TEST(ConcentricMap, MendsASheetThatLeavesTheCubicByRefiningThePolygonOnce) {
    const ClosedSpline cubic = shapes::spline({{0, 0}, {24, 0}, {24, 1}, {0, 1}}, 3);
    const BoundaryPieces boundary(cubic);
    const ConcentricCurve failing = basic(cubic);
    EXPECT_NEAR(map_area(cubic, failing), 16.26666667, 1e-8);  // it does not show there
    EXPECT_FALSE(folded_courses(boundary, failing).empty());
    EXPECT_FALSE(courses_outside(boundary, failing).empty());
    const ClosedSpline finer = with_knots(cubic, {0.5, 1.5, 2.5, 3.5});
    EXPECT_TRUE(folded_courses(boundary, basic(finer)).empty());
    EXPECT_TRUE(courses_outside(boundary, basic(finer)).empty());
    const auto mended = concentric_map(cubic);
    ASSERT_TRUE(mended) << mended.error().message;
    EXPECT_TRUE(folded_courses(boundary, mended->axis).empty());
    EXPECT_TRUE(courses_outside(boundary, mended->axis).empty());
    EXPECT_EQ(mended->refinements, 1);
}

/// Interpolated parameters and far chords fold on reflex polygons.
TEST(ConcentricMap, MendsAPolygonOnWhichThePapersParametersFold) {
    const ClosedSpline polygon = shapes::polygon(shapes::folding());
    const BoundaryPieces boundary(polygon);
    EXPECT_FALSE(folded_courses(boundary, basic(polygon)).empty());
    const auto mended = concentric_map(polygon);
    ASSERT_TRUE(mended) << mended.error().message;
    EXPECT_TRUE(folded_courses(boundary, mended->axis).empty());
    EXPECT_NEAR(map_area(polygon, mended->axis), shapes::area(shapes::folding()), 1e-12);
}

TEST(ConcentricMap, KeepsFewControlPointsByMovingTheCoarseAxisOntoTheFineOne) {
    const ClosedSpline cubic = shapes::spline({{0, 0}, {24, 0}, {24, 1}, {0, 1}}, 3);
    const BoundaryPieces boundary(cubic);
    ClosedSpline fine = cubic;
    for (int k = 0; k < 3; ++k) {
        std::vector<double> middles;
        for (int i = 0; i < fine.count(); ++i) {
            middles.push_back(0.5 * (fine.knots[static_cast<std::size_t>(i)] +
                                     fine.knots[static_cast<std::size_t>(i) + 1]));
        }
        fine = with_knots(fine, middles);
    }
    const ConcentricCurve coarse = basic(cubic);
    const auto exact = concentric_map(fine, {0.05, 0.0, true, 8});
    ASSERT_TRUE(exact) << exact.error().message;
    const ConcentricCurve moved = moved_onto(coarse, exact->axis);
    EXPECT_EQ(moved.count(), coarse.count());
    EXPECT_LT(moved.count(), exact->axis.count());
    EXPECT_TRUE(courses_outside(boundary, moved).empty());
    EXPECT_TRUE(folded_courses(boundary, moved).empty());
}

/// Step 4: the closest concentric vertex along the seam, here the image of the reflex vertex, which
/// is half-way between the corner and the first branch point.
TEST(BasicConcentricAxis, MapsACornerToTheReflexImageOnItsSeam) {
    const ClosedSpline wedge = shapes::polygon({{0, 0}, {20, -2}, {20, 4}, {10, 0.5}});
    const ConcentricCurve c = basic(wedge);
    const Vector2d image = evaluate(c, 3.0);
    EXPECT_NEAR(image.x(), 10.0, 1.0);
    EXPECT_LT((evaluate(c, 0.0) - image).norm(), 1e-9);
    EXPECT_GT(evaluate(c, 1.0).x(), 15.0);
}

TEST(ConcentricMap, PrunesANoisyEllipseByTheSalienceOfItsBranches) {
    const ClosedSpline noisy = shapes::polygon(shapes::noisy_ellipse(24, 0.05));
    const BoundaryPieces boundary(noisy);
    int before = 1 << 30;
    for (const double salience : {0.0, 0.1, 0.3, 2.0}) {
        const auto map = concentric_map(noisy, {salience, 0.0, true, 0});
        ASSERT_TRUE(map) << map.error().message;
        EXPECT_LT(used_nodes(map->axis), before) << salience;
        EXPECT_TRUE(folded_courses(boundary, map->axis).empty());
        EXPECT_NEAR(map_area(noisy, map->axis), shapes::area(shapes::noisy_ellipse(24, 0.05)),
                    1e-12 * 14.0);
        before = used_nodes(map->axis);
    }
}

}  // namespace
}  // namespace suture::concentric

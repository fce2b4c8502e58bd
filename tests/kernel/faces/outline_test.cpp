#include "support/properties.h"
#include "suture/faces/join.h"
#include "suture/faces/make_faces.h"

#include "kernel/faces/holes.h"
#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeCone.hxx>

#include <cmath>

/// Fills of several patches: the exact fill of a hole, cut into pieces, has to come out as the same
/// solid as in one piece.
namespace suture {
namespace {

using Eigen::Vector2d;
using test::area;
using test::OpenHole;
using test::volume;

/// How well OCCT integrates over faces with several spans.
constexpr double kQuadrature = 2e-5;

TopoDS_Shape filled(const TopoDS_Shape& shape, const OpenHole& open, const FillResult& fill) {
    const auto made = make_faces(open.loops, open.hole, fill);
    EXPECT_TRUE(made) << made.error().message;
    EXPECT_LT(made->max_gap, 2e-8 * open.hole.diameter);
    auto joined = join(shape, made->faces);
    EXPECT_TRUE(joined) << joined.error().message;
    return joined.value_or(TopoDS_Shape());
}

void expect_same_solid(const TopoDS_Shape& pieces, const TopoDS_Shape& whole) {
    EXPECT_TRUE(BRepCheck_Analyzer(pieces).IsValid());
    ASSERT_EQ(pieces.ShapeType(), whole.ShapeType());
    if (whole.ShapeType() == TopAbs_SOLID) {
        EXPECT_NEAR(volume(pieces), volume(whole), kQuadrature * std::abs(volume(whole)));
    }
    EXPECT_NEAR(area(pieces), area(whole), kQuadrature * area(whole));
}

/// Another way round for every second piece, so that pieces of one surface differ in their
/// parameters.
void exchange_u_and_v(Patch& patch) {
    auto* spline = std::get_if<SplineSurface>(&patch.surface);
    if (spline == nullptr) {
        return;
    }
    *spline = transposed(*spline);
    patch.reversed = !patch.reversed;
    for (EdgeUse& use : patch.wires.front()) {
        use.at = [at = use.at](double s) -> Vector2d { return at(s).reverse(); };
    }
}

/// A star of pieces about a vertex in the middle of the domain, one for each side; the edges
/// between them bend.
FillResult star_of(const FillResult& whole) {
    const Patch& patch = whole.patches.front();
    const std::vector<EdgeUse>& sides = patch.wires.front();
    const int n = static_cast<int>(sides.size());
    Vector2d middle = Vector2d::Zero();
    for (const EdgeUse& side : sides) {
        middle += side.at(0.0) / n;
    }
    FillResult result;
    result.inner_vertices = {evaluate(patch.surface, middle.x(), middle.y()).point};
    for (int i = 0; i < n; ++i) {
        result.inner_edges.push_back({{0, i}, {-1, 0}});
    }
    const auto spoke = [&](int i) -> TrimCurve {
        const Vector2d corner = sides[static_cast<std::size_t>(i)].at(0.0);
        const Vector2d bend = 0.2 * Vector2d(corner.y() - middle.y(), middle.x() - corner.x());
        return [=](double s) -> Vector2d {
            return corner + s * (middle - corner) + s * (1.0 - s) * bend;
        };
    };
    for (int i = 0; i < n; ++i) {
        const int next = (i + 1) % n;
        Patch piece;
        piece.surface = patch.surface;
        piece.reversed = patch.reversed;
        piece.wires = {{sides[static_cast<std::size_t>(i)],
                        {-1, next, false, spoke(next), false},
                        {-1, i, true, spoke(i), false}}};
        if (i % 2 == 1) {
            exchange_u_and_v(piece);
        }
        result.patches.push_back(piece);
    }
    return result;
}

TEST(Outline, JoinsAStarOfPatchesToTheSameSolid) {
    for (const auto& [name, shape, scale] : test::open_shells()) {
        SCOPED_TRACE(name);
        for (const OpenHole& open : test::holes_of(shape)) {
            const FillResult star = star_of(open.fill);
            expect_same_solid(filled(shape, open, star), filled(shape, open, open.fill));
            const auto made = make_faces(open.loops, open.hole, star);
            EXPECT_EQ(made->faces.size(), open.hole.loops.front().ribbons.size());
        }
    }
}

/// A square in the middle of the hole, bounded by lines of constant parameters, and the rest.
FillResult square_in(const FillResult& whole) {
    const Patch& patch = whole.patches.front();
    const std::vector<EdgeUse>& sides = patch.wires.front();
    FillResult result;
    Vector2d middle = Vector2d::Zero();
    for (const EdgeUse& side : sides) {
        middle += side.at(0.0) / static_cast<double>(sides.size());
    }
    const Vector2d reach = 0.3 * (sides[0].at(0.0) - middle).cwiseAbs();
    const std::vector<Vector2d> square = {
        middle + Vector2d(reach.x(), reach.y()), middle + Vector2d(-reach.x(), reach.y()),
        middle + Vector2d(-reach.x(), -reach.y()), middle + Vector2d(reach.x(), -reach.y())};
    const auto edge = [&](std::size_t i) -> TrimCurve {
        const Vector2d a = square[i];
        const Vector2d b = square[(i + 1) % 4];
        return [=](double s) -> Vector2d { return a + s * (b - a); };
    };
    Patch outer;
    outer.surface = patch.surface;
    outer.reversed = patch.reversed;
    Patch inner = outer;
    outer.wires = patch.wires;
    auto& island = outer.wires.emplace_back();
    auto& around = inner.wires.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
        const auto index = static_cast<int>(i);
        result.inner_vertices.push_back(
            evaluate(patch.surface, square[i].x(), square[i].y()).point);
        result.inner_edges.push_back({{-1, index}, {-1, (index + 1) % 4}});
        // The square is walked counterclockwise: with the inside of the patch on the left, unless
        // the patch is turned over.
        around.push_back({-1, index, false, edge(i), false});
        island.insert(island.begin(), {-1, index, true, edge(i), false});
    }
    if (patch.reversed) {
        for (auto* wire : {&island, &around}) {
            std::reverse(wire->begin(), wire->end());
            for (EdgeUse& use : *wire) {
                use.backwards = !use.backwards;
            }
        }
    }
    result.patches = {outer, inner};
    return result;
}

TEST(Outline, TakesAPatchThatTouchesNoSideOfTheHole) {
    for (const auto& [name, shape, scale] : test::open_shells()) {
        SCOPED_TRACE(name);
        for (const OpenHole& open : test::holes_of(shape)) {
            expect_same_solid(filled(shape, open, square_in(open.fill)),
                              filled(shape, open, open.fill));
        }
    }
}

TEST(Outline, ClosesACapWithASeamAndAPole) {
    constexpr double kRadius = 2.0;
    constexpr double kTop = 1.0;
    constexpr double kHeight = 1.5;
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(kRadius, kTop, kHeight).Shape();
    for (const test::Variant& variant : test::variants_of(grids::without_faces(cone, {1}))) {
        SCOPED_TRACE(variant.name);
        TopoDS_Shape shape = variant.shape;
        for (const OpenHole& open : test::holes_of(variant.shape)) {
            ASSERT_EQ(open.fill.inner_edges.size(), 1U);
            shape = filled(shape, open, open.fill);
        }
        EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
        EXPECT_EQ(shape.ShapeType(), TopAbs_SOLID);
        const double truth = kPi / 3.0 * kRadius * kRadius * kHeight * kRadius / (kRadius - kTop) *
                             std::pow(variant.scale, 3.0);
        EXPECT_NEAR(std::abs(volume(shape)), truth, 1e-6 * truth);
    }
}

}  // namespace
}  // namespace suture

#include "suture/faces/make_faces.h"

#include "suture/occ/convert.h"

#include <Eigen/Geometry>

#include "kernel/faces/holes.h"
#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>

#include <cmath>

namespace suture {
namespace {

using occ::from_occ;
using occ::Handle;
using test::OpenHole;

struct Made {
    TopoDS_Shape shape;
    OpenHole open;
    NewFaces faces;
    double scale = 1.0;

    [[nodiscard]] const TopoDS_Face& face() const { return faces.faces.front(); }
};

/// Runs an action on the new face of every hole of every open shell.
template <class Action>
void for_every_hole(Action&& action) {
    for (const auto& [name, shape, scale] : test::open_shells()) {
        SCOPED_TRACE(name);
        for (OpenHole& open : test::holes_of(shape)) {
            auto faces = make_faces(open.loops, open.hole, open.fill);
            ASSERT_TRUE(faces) << faces.error().message;
            ASSERT_EQ(faces->faces.size(), 1U);
            action(Made{shape, std::move(open), std::move(*faces), scale});
        }
    }
}

/// The edge's curve and its image on the face, both at the edge's parameter t.
struct EdgeOnFace {
    double first = 0.0, last = 0.0, first2d = 0.0, last2d = 0.0;
    Handle<Geom_Curve> curve;
    Handle<Geom2d_Curve> pcurve;
    Handle<Geom_Surface> surface;

    EdgeOnFace(const TopoDS_Edge& edge, const TopoDS_Face& face)
        : curve(BRep_Tool::Curve(edge, first, last)),
          pcurve(BRep_Tool::CurveOnSurface(edge, face, first2d, last2d)),
          surface(BRep_Tool::Surface(face)) {}

    [[nodiscard]] double at(int k, int of) const { return first + (last - first) * k / of; }
    [[nodiscard]] double distance(double t) const {
        const gp_Pnt2d uv = pcurve->Value(t);
        return curve->Value(t).Distance(surface->Value(uv.X(), uv.Y()));
    }
    [[nodiscard]] double largest_distance(int samples) const {
        double largest = 0.0;
        for (int k = 0; k <= samples; ++k) {
            largest = std::max(largest, distance(at(k, samples)));
        }
        return largest;
    }
};

TEST(MakeFaces, StandsOnTheHolesOwnEdges) {
    for_every_hole([](const Made& made) {
        const auto& sides = made.open.loops.front().edges;
        const auto edges = occ::edges_of(made.face());
        EXPECT_EQ(edges.size(), sides.size());
        for (const BoundaryEdge& side : sides) {
            EXPECT_TRUE(std::any_of(edges.begin(), edges.end(),
                                    [&](const auto& edge) { return edge.IsSame(side.edge); }));
        }
    });
}

TEST(MakeFaces, LeavesEveryToleranceAsItWas) {
    for (const auto& [name, shape, scale] : test::open_shells()) {
        SCOPED_TRACE(name);
        const auto before = test::tolerances_of(shape);
        for (const OpenHole& open : test::holes_of(shape)) {
            const auto made = make_faces(open.loops, open.hole, open.fill);
            ASSERT_TRUE(made) << made.error().message;
            EXPECT_LT(made->max_gap, 1e-8 * open.hole.diameter);
            EXPECT_EQ(made->grown_edges, 0);
        }
        EXPECT_EQ(test::tolerances_of(shape), before);
    }
}

TEST(MakeFaces, GivesPcurvesThatRunWithTheEdges) {
    for_every_hole([](const Made& made) {
        for (const BoundaryEdge& side : made.open.loops.front().edges) {
            const EdgeOnFace on(side.edge, made.face());
            ASSERT_FALSE(on.pcurve.IsNull());
            EXPECT_NEAR(on.first, on.first2d, 1e-9 * (on.last - on.first));
            EXPECT_NEAR(on.last, on.last2d, 1e-9 * (on.last - on.first));
            EXPECT_LT(on.largest_distance(1000), 1e-8 * made.open.hole.diameter);
        }
    });
}

TEST(MakeFaces, FacesTheWayOfTheNeighboursAndIsValid) {
    for_every_hole([](const Made& made) {
        const double sign = made.face().Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
        const bool tangent = made.shape.NbChildren() > 6;  // the torus, not the box
        const auto& sides = made.open.loops.front().edges;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const EdgeOnFace on(sides[i].edge, made.face());
            const Ribbon& ribbon = made.open.hole.loops.front().ribbons[i];
            const double s = 0.4;
            const gp_Pnt2d uv = on.pcurve->Value(ribbon.first + (ribbon.last - ribbon.first) * s);
            gp_Pnt point;
            gp_Vec u, v;
            on.surface->D1(uv.X(), uv.Y(), point, u, v);
            const Eigen::Vector3d normal = sign * from_occ(u.Crossed(v)).normalized();
            const RibbonPoint p = ribbon.at(s);
            // Of two planes at a right angle the new one's normal points away from the old face.
            const Eigen::Vector3d outward = tangent ? p.normal : Eigen::Vector3d(-p.inward);
            if (tangent) {
                EXPECT_GT(normal.dot(outward), 1.0 - 1e-9);
            } else {
                EXPECT_GT(std::abs(normal.dot(outward)), 1.0 - 1e-9);
            }
        }
        EXPECT_TRUE(BRepCheck_Analyzer(made.face()).IsValid());
    });
}

/// Moves the surface of a plane patch along its normal.
void shift(FillResult& fill, double distance) {
    auto& plane = std::get<Plane>(fill.patches.front().surface);
    plane.frame.origin += distance * plane.frame.z;
}

TEST(MakeFaces, GrowsTolerancesAsFarAsTheGapAndNoOthers) {
    constexpr double kGap = 1e-3;
    const TopoDS_Shape box = test::box_without({0});
    const auto before = test::tolerances_of(box);
    OpenHole open = test::holes_of(box).front();
    shift(open.fill, kGap);
    const auto made = make_faces(open.loops, open.hole, open.fill);
    ASSERT_TRUE(made);
    EXPECT_NEAR(made->max_gap, kGap, 1e-12);
    int grown = 0;
    for (const TopoDS_Edge& edge : occ::edges_of(box)) {
        const auto& sides = open.loops.front().edges;
        const bool side = std::any_of(sides.begin(), sides.end(),
                                      [&](const auto& s) { return s.edge.IsSame(edge); });
        const double tolerance = BRep_Tool::Tolerance(edge);
        EXPECT_NEAR(tolerance, side ? 1.01 * kGap : before.front(), 1e-12);
        grown += side ? 1 : 0;
    }
    EXPECT_EQ(grown, 4);
    EXPECT_EQ(made->grown_edges, 4);
    EXPECT_NEAR(made->grown_tolerance, 1.01 * kGap, 1e-12);
}

TEST(MakeFaces, CoversTheGapBetweenItsOwnSamples) {
    OpenHole open = test::holes_of(test::box_without({0})).front();
    Patch& patch = open.fill.patches.front();
    const Frame frame = std::get<Plane>(patch.surface).frame;
    // A rippled sheet over the plane's own parameters: one peak per span.
    constexpr int kSpans = 37;
    constexpr double kReach = 8.0;
    SplineSurface ripples;
    ripples.degree_u = ripples.degree_v = 2;
    for (int i = -2; i <= kSpans + 2; ++i) {
        ripples.knots_u.push_back(kReach * (2.0 * std::clamp(i, 0, kSpans) / kSpans - 1.0));
    }
    ripples.knots_v = ripples.knots_u;
    const int count = kSpans + 2;
    ripples.poles.resize(3, static_cast<Eigen::Index>(count) * count);
    for (int j = 0; j < count; ++j) {
        for (int i = 0; i < count; ++i) {
            const auto greville = [&](int k) {
                const auto first = static_cast<std::size_t>(k) + 1;
                return 0.5 * (ripples.knots_u[first] + ripples.knots_u[first + 1]);
            };
            const double height = 1e-3 * std::sin(2.1 * i + 0.3 * j * j);
            ripples.poles.col(static_cast<Eigen::Index>(j) * count + i) =
                frame.origin + greville(i) * frame.x + greville(j) * frame.y + height * frame.z;
        }
    }
    patch.surface = ripples;
    const auto made = make_faces(open.loops, open.hole, open.fill);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_GT(made->max_gap, 1e-4);
    for (const BoundaryEdge& side : open.loops.front().edges) {
        const double largest = EdgeOnFace(side.edge, made->faces.front()).largest_distance(20000);
        EXPECT_LE(largest, 1.21 * made->max_gap);  // where the pcurve marks it
        EXPECT_LE(largest, BRep_Tool::Tolerance(side.edge));
        EXPECT_GE(1.02 * largest, BRep_Tool::Tolerance(side.edge));
    }
}

TEST(MakeFaces, StandsAtTheFeetOfEdgesThatTheLayoutMisses) {
    OpenHole open = test::holes_of(test::box_without({0})).front();
    Patch& patch = open.fill.patches.front();
    // A sheet a little above the plane, so that it needs pcurves; its layout slides along the sides
    // and past the corners by a hundredth.
    const Frame frame = std::get<Plane>(patch.surface).frame;
    constexpr double kReach = 8.0;
    constexpr double kHeight = 1e-4;
    SplineSurface sheet;
    sheet.degree_u = sheet.degree_v = 1;
    sheet.knots_u = sheet.knots_v = {-kReach, -kReach, kReach, kReach};
    sheet.poles.resize(3, 4);
    for (int k = 0; k < 4; ++k) {
        sheet.poles.col(k) = frame.origin + (k % 2 == 0 ? -kReach : kReach) * frame.x +
                             (k < 2 ? -kReach : kReach) * frame.y + kHeight * frame.z;
    }
    patch.surface = sheet;
    for (EdgeUse& use : patch.wires.front()) {
        use.at = [exact = use.at](double s) -> Eigen::Vector2d {
            return exact(s) + 0.01 * Eigen::Vector2d(std::cos(7.0 * s), std::sin(7.0 * s));
        };
    }
    const auto made = make_faces(open.loops, open.hole, open.fill);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_NEAR(made->max_gap, kHeight, 1e-3 * kHeight);
    EXPECT_LE(made->grown_tolerance, 1.5 * kHeight);
    EXPECT_TRUE(BRepCheck_Analyzer(made->faces.front()).IsValid());
    // Neighbouring curves meet in their corners.
    const auto& sides = open.loops.front().edges;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto end_of = [&](const BoundaryEdge& side, bool start) {
            const EdgeOnFace on(side.edge, made->faces.front());
            const bool first = start == (side.edge.Orientation() != TopAbs_REVERSED);
            return on.pcurve->Value(first ? on.first : on.last);
        };
        EXPECT_LT(end_of(sides[i], false).Distance(end_of(sides[(i + 1) % sides.size()], true)),
                  1e-12);
    }
}

/// Where the layout has the sides, a little off in every direction: not the same twice.
void shake(FillResult& fill, double by) {
    for (EdgeUse& use : fill.patches.front().wires.front()) {
        use.at = [exact = use.at, by](double s) -> Eigen::Vector2d {
            return exact(s) + by * Eigen::Vector2d(std::cos(7.0 * s), std::sin(7.0 * s));
        };
    }
}

TEST(PlaceFaces, TakesWhatIsKnownOfTheSameEdges) {
    for (const auto& [name, shape, scale] : test::open_shells()) {
        SCOPED_TRACE(name);
        for (OpenHole& open : test::holes_of(shape)) {
            const auto first = make_faces(open.loops, open.hole, open.fill);
            ASSERT_TRUE(first) << first.error().message;
            ASSERT_EQ(first->placements.size(), open.loops.front().edges.size());
            // Another layout would give other curves, if it were asked.
            shake(open.fill, 0.01);
            auto placed = place_faces(open.loops, open.hole, open.fill, first->placements);
            ASSERT_TRUE(placed) << placed.error().message;
            const auto again = placed->make();
            ASSERT_TRUE(again) << again.error().message;
            EXPECT_EQ(again->max_gap, first->max_gap);
            for (std::size_t i = 0; i < first->placements.size(); ++i) {
                EXPECT_EQ(again->placements[i].pcurve, first->placements[i].pcurve);
            }
        }
    }
}

TEST(PlaceFaces, LooksAnewWhereAVertexHasMoved) {
    constexpr double kHeight = 1e-4;
    OpenHole open = test::holes_of(test::box_without({0})).front();
    const auto first = make_faces(open.loops, open.hole, open.fill);
    ASSERT_TRUE(first) << first.error().message;
    shift(open.fill, kHeight);
    const TopoDS_Vertex moved = TopExp::FirstVertex(open.loops.front().edges.front().edge);
    BRep_Builder().UpdateVertex(moved, BRep_Tool::Pnt(moved).Translated(gp_Vec(0.0, 0.0, 1e-9)),
                                BRep_Tool::Tolerance(moved));
    auto placed = place_faces(open.loops, open.hole, open.fill, first->placements);
    ASSERT_TRUE(placed) << placed.error().message;
    const auto made = placed->make();
    ASSERT_TRUE(made) << made.error().message;
    int anew = 0;
    for (const Placement& placement : made->placements) {
        anew += placement.gap > 0.5 * kHeight ? 1 : 0;
    }
    EXPECT_EQ(anew, 2);
    EXPECT_NEAR(made->max_gap, kHeight, 1e-9);
}

TEST(MakeFaces, RefusesASurfaceBeyondOcctsHighestDegree) {
    OpenHole open = test::holes_of(test::box_without({0})).front();
    SplineSurface steep;
    steep.degree_u = 26;
    steep.degree_v = 1;
    steep.knots_u.assign(27, 0.0);
    steep.knots_u.insert(steep.knots_u.end(), 27, 1.0);
    steep.knots_v = {0.0, 0.0, 1.0, 1.0};
    steep.poles = Eigen::Matrix3Xd::Zero(3, 54);
    open.fill.patches.front().surface = steep;
    EXPECT_FALSE(make_faces(open.loops, open.hole, open.fill));
}

}  // namespace
}  // namespace suture

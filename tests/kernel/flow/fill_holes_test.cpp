#include "suture/fill_holes.h"

#include "support/grids.h"
#include "support/properties.h"
#include "suture/choose/smoothest.h"
#include "suture/detect/find_loops.h"
#include "suture/occ/convert.h"
#include "suture/occ/handle.h"
#include "suture/ribbon/extract.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>

#include <cmath>
#include <sstream>
#include <stop_token>

namespace suture {
namespace {

using occ::Handle;
using test::area;
using test::volume;

Result<FillOutcome> fill(const TopoDS_Shape& shape, const FillRequest& request = {}) {
    return fill_holes(shape, occ::Numbering(shape), request);
}

void expect_closed_solid(const FillOutcome& outcome) {
    EXPECT_EQ(outcome.shape.ShapeType(), TopAbs_SOLID);
    EXPECT_TRUE(BRepCheck_Analyzer(outcome.shape).IsValid());
    for (TopExp_Explorer it(outcome.shape, TopAbs_SHELL); it.More(); it.Next()) {
        EXPECT_TRUE(BRep_Tool::IsClosed(it.Current()));
    }
}

/// Every face of the input is in the output, as the same object.
void expect_untouched(const TopoDS_Shape& before, const TopoDS_Shape& after) {
    TopTools_MapOfShape kept;
    for (TopExp_Explorer it(after, TopAbs_FACE); it.More(); it.Next()) {
        kept.Add(it.Current());
    }
    for (TopExp_Explorer it(before, TopAbs_FACE); it.More(); it.Next()) {
        EXPECT_TRUE(kept.Contains(it.Current()));
    }
}

double largest_tolerance(const TopoDS_Shape& shape) {
    double largest = 0.0;
    for (const TopoDS_Edge& edge : occ::edges_of(shape)) {
        largest = std::max(largest, BRep_Tool::Tolerance(edge));
    }
    return largest;
}

TEST(FillHoles, ClosesABoxWithoutALidByAPlane) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Shape();
    for (int lid = 0; lid < 6; ++lid) {
        const TopoDS_Shape open = grids::without_faces(box, {lid});
        const auto outcome = fill(open);
        ASSERT_TRUE(outcome) << outcome.error().message;
        expect_closed_solid(*outcome);
        expect_untouched(open, outcome->shape);
        ASSERT_EQ(outcome->holes.size(), 1U);
        EXPECT_EQ(outcome->holes[0].status, FillStatus::Filled);
        EXPECT_EQ(outcome->holes[0].method_used, "plane");
        EXPECT_TRUE(outcome->holes[0].verdict.within());
        EXPECT_NEAR(volume(outcome->shape), 24.0, 1e-9);
    }
}

struct Body {
    std::string name;
    Handle<Geom_Surface> surface;
    std::vector<double> us, vs;
};

/// Closed bodies of one surface, in cells.
std::vector<Body> bodies() {
    const gp_Ax3 axes(gp_Pnt(1, -2, 3), gp_Dir(1, 2, -1));
    const std::vector<double> turn = {0.0, 1.3, 2.9, 4.4, 2.0 * kPi};
    std::vector<Body> result;
    result.push_back({"torus",
                      occ::make<Geom_ToroidalSurface>(axes, 5.0, 1.5),
                      turn,
                      {0.0, 1.7, 3.6, 2.0 * kPi}});
    result.push_back({"sphere",
                      occ::make<Geom_SphericalSurface>(axes, 4.0),
                      turn,
                      {-kPi / 2, -0.4, 0.7, kPi / 2}});
    const Handle<Geom_Surface> torus = occ::make<Geom_ToroidalSurface>(axes, 5.0, 1.5);
    const auto spline = GeomConvert::SurfaceToBSplineSurface(torus);
    spline->SetUNotPeriodic();
    spline->SetVNotPeriodic();
    result.push_back({"B-spline torus", spline, turn, {0.0, 1.7, 3.6, 2.0 * kPi}});
    return result;
}

TEST(FillHoles, ExtendsTheSurfaceAllNeighboursShareInEveryCell) {
    for (const Body& body : bodies()) {
        const TopoDS_Shape whole = grids::shell_of(body.surface, body.us, body.vs, {});
        const double truth = area(whole);
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 3; ++j) {
                SCOPED_TRACE(testing::Message() << body.name << " cell " << i << ", " << j);
                const TopoDS_Shape open = grids::shell_of(body.surface, body.us, body.vs, {{i, j}});
                const double tolerance = largest_tolerance(open);
                const auto outcome = fill(open);
                ASSERT_TRUE(outcome) << outcome.error().message;
                expect_closed_solid(*outcome);
                expect_untouched(open, outcome->shape);
                const HoleReport& hole = outcome->holes.front();
                EXPECT_EQ(hole.method_used, "extend") << hole.reason;
                EXPECT_LT(hole.max_gap, 1e-9);
                EXPECT_LT(hole.max_angle, 1e-7);
                EXPECT_EQ(hole.continuity_reached, Continuity::G2);
                EXPECT_NEAR(area(outcome->shape), truth, 1e-4 * truth);
                EXPECT_GT(volume(outcome->shape), 0.0);
                EXPECT_EQ(largest_tolerance(outcome->shape), tolerance);
            }
        }
    }
}

TEST(FillHoles, FillsSeveralHolesInOneRunAlsoTouchingOnes) {
    const Body body = bodies().front();
    for (const std::set<std::pair<int, int>>& missing :
         {std::set<std::pair<int, int>>{{0, 0}, {2, 1}},
          std::set<std::pair<int, int>>{{1, 0}, {2, 1}}}) {  // these share a vertex
        SCOPED_TRACE(missing.begin()->first);
        const TopoDS_Shape open = grids::shell_of(body.surface, body.us, body.vs, missing);
        const auto outcome = fill(open);
        ASSERT_TRUE(outcome) << outcome.error().message;
        EXPECT_EQ(outcome->holes.size(), 2U);
        EXPECT_EQ(outcome->new_faces.size(), 2U);
        expect_closed_solid(*outcome);
        EXPECT_NEAR(volume(outcome->shape), 2.0 * kPi * kPi * 5.0 * 1.5 * 1.5, 1e-4);
    }
}

/// The shell with one face standing on a vertex of its own in a place, if it stands there.
TopoDS_Shape torn_at(const TopoDS_Shape& shell, int face_number, const gp_Pnt& where) {
    const BRep_Builder builder;
    TopoDS_Shell torn;
    builder.MakeShell(torn);
    int number = 0;
    for (TopExp_Explorer it(shell, TopAbs_FACE); it.More(); it.Next(), ++number) {
        TopoDS_Shape face = it.Current();
        for (TopExp_Explorer v(face, TopAbs_VERTEX); number == face_number && v.More(); v.Next()) {
            const TopoDS_Vertex vertex = TopoDS::Vertex(v.Current());
            if (BRep_Tool::Pnt(vertex).Distance(where) < 1e-6) {
                TopoDS_Vertex own;
                builder.MakeVertex(own, BRep_Tool::Pnt(vertex), BRep_Tool::Tolerance(vertex));
                BRepTools_ReShape change;
                change.Replace(vertex, own.Oriented(vertex.Orientation()));
                face = change.Apply(face);
                break;
            }
        }
        builder.Add(torn, face);
    }
    return torn;
}

TEST(FillHoles, FillsHolesThatTouchInAPlaceWithTwoVertices) {
    const Body body = bodies().front();
    const std::set<std::pair<int, int>> missing = {{1, 0}, {2, 1}};
    const gp_Pnt place = body.surface->Value(body.us[2], body.vs[1]);
    const auto places = [&](const TopoDS_Shape& shape) {
        TopTools_MapOfShape found;
        for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next()) {
            if (BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).Distance(place) < 1e-6) {
                found.Add(it.Current());
            }
        }
        return found.Extent();
    };
    int torn_apart = 0;
    for (int face = 0; face < 4 * 3 - 2; ++face) {
        SCOPED_TRACE(face);
        const TopoDS_Shape torn =
            torn_at(grids::shell_of(body.surface, body.us, body.vs, missing), face, place);
        torn_apart += places(torn) == 2 ? 1 : 0;
        const auto outcome = fill(torn);
        ASSERT_TRUE(outcome) << outcome.error().message;
        EXPECT_EQ(outcome->holes.size(), 2U);
        EXPECT_EQ(outcome->new_faces.size(), 2U);
        expect_closed_solid(*outcome);
        EXPECT_NEAR(volume(outcome->shape), 2.0 * kPi * kPi * 5.0 * 1.5 * 1.5, 1e-4);
        EXPECT_EQ(places(outcome->shape), 1);
        expect_untouched(torn, outcome->shape);
    }
    EXPECT_EQ(torn_apart, 2);  // both faces that stand between the holes
}

TEST(FillHoles, FillsOnlyTheHolesAskedForAndReportsTheOthersAsSkipped) {
    const Body body = bodies().front();
    const TopoDS_Shape open = grids::shell_of(body.surface, body.us, body.vs, {{0, 0}, {2, 1}});
    FillRequest request;
    request.holes = {{2}};
    const auto outcome = fill(open, request);
    ASSERT_TRUE(outcome) << outcome.error().message;
    ASSERT_EQ(outcome->holes.size(), 2U);
    EXPECT_EQ(outcome->holes[0].ids, std::vector<int>{2});
    EXPECT_EQ(outcome->holes[0].status, FillStatus::Filled);
    EXPECT_EQ(outcome->holes[1].ids, std::vector<int>{1});
    EXPECT_EQ(outcome->holes[1].status, FillStatus::Skipped);
    EXPECT_EQ(outcome->new_faces.size(), 1U);
}

TEST(FillHoles, FindsTheHoleOfAnEdge) {
    const Body body = bodies().front();
    const TopoDS_Shape open = grids::shell_of(body.surface, body.us, body.vs, {{0, 0}, {2, 1}});
    const auto all = fill(open);
    ASSERT_TRUE(all) << all.error().message;
    ASSERT_EQ(all->holes.size(), 2U);
    ASSERT_EQ(all->holes[1].sides.size(), 4U);
    FillRequest request;
    request.edges = {all->holes[1].sides[2].edge};
    const auto one =
        fill(grids::shell_of(body.surface, body.us, body.vs, {{0, 0}, {2, 1}}), request);
    ASSERT_TRUE(one) << one.error().message;
    EXPECT_EQ(one->holes[0].ids, all->holes[1].ids);
    EXPECT_EQ(one->new_faces.size(), 1U);
}

TEST(FillHoles, IsTheSameInEveryOrientationAndScale) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 12.0, 14.0).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (const TopoDS_Edge& edge : occ::edges_of(box)) {
        fillet.Add(2.0, edge);
    }
    const TopoDS_Shape rounded = fillet.Shape();
    int corner = -1;
    int number = 0;
    for (TopExp_Explorer it(rounded, TopAbs_FACE); it.More(); it.Next(), ++number) {
        if (BRepAdaptor_Surface(TopoDS::Face(it.Current())).GetType() == GeomAbs_Sphere) {
            corner = number;
        }
    }
    ASSERT_GE(corner, 0);
    const double truth = volume(rounded);
    for (const double scale : {1e-3, 1.0, 1e3}) {
        gp_Trsf size;
        size.SetScale(gp_Pnt(0, 0, 0), scale);
        gp_Trsf turn;
        turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -1, 2)), 0.9);
        const TopoDS_Shape moved =
            BRepBuilderAPI_Transform(rounded, size * turn, Standard_True).Shape();
        for (const bool reversed : {false, true}) {
            SCOPED_TRACE(testing::Message() << "scale " << scale << " reversed " << reversed);
            TopoDS_Shape open = grids::without_faces(moved, {corner});
            open = reversed ? open.Reversed() : open;
            FillRequest request;
            request.tolerance.linear = 1e-3 * scale;
            request.tolerance.angular = radians(2.0);
            const auto outcome = fill(open, request);
            ASSERT_TRUE(outcome) << outcome.error().message;
            EXPECT_EQ(outcome->shape.ShapeType(), TopAbs_SOLID);
            EXPECT_TRUE(outcome->holes[0].verdict.within()) << outcome->holes[0].reason;
            // A corner holds an octant of a ball of radius 2: 0.26 % of the body.
            EXPECT_NEAR(volume(outcome->shape) / std::pow(scale, 3), truth, 1e-4 * truth);
        }
    }
    // Placed in a mirror, the body is turned inside out.
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, -1, 2)));
    FillRequest request;
    request.tolerance.angular = radians(2.0);
    const auto outcome = fill(grids::without_faces(rounded, {corner})
                                  .Moved(TopLoc_Location(mirror), /*theRaiseExc=*/false),
                              request);
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_TRUE(outcome->holes[0].verdict.within()) << outcome->holes[0].reason;
    EXPECT_NEAR(std::abs(volume(outcome->shape)), truth, 1e-4 * truth);
}

TEST(FillHoles, RefusesHolesAndEdgesThatDoNotExist) {
    const TopoDS_Shape open = grids::without_faces(BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Shape(), {5});
    FillRequest request;
    request.holes = {{99}};
    const auto hole = fill(open, request);
    ASSERT_FALSE(hole);
    EXPECT_EQ(hole.error().code, ErrorCode::Usage);
    EXPECT_NE(hole.error().message.find("99"), std::string::npos);
    request.holes.clear();
    request.edges = {77};
    const auto edge = fill(open, request);
    ASSERT_FALSE(edge);
    EXPECT_EQ(edge.error().code, ErrorCode::Usage);
    request.edges.clear();
    request.method = "magic";
    const auto method = fill(open, request);
    ASSERT_FALSE(method);
    EXPECT_NE(method.error().message.find("extend"), std::string::npos);
}

TEST(FillHoles, HasNothingToDoOnAClosedSolid) {
    const auto outcome = fill(BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Shape());
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::NothingToDo);
}

TEST(FillHoles, ReportsARefusedHoleAndLeavesTheModelAsItWas) {
    const Body body = bodies().front();
    const TopoDS_Shape open = grids::shell_of(body.surface, body.us, body.vs, {{0, 0}});
    FillRequest request;
    request.method = "plane";
    const auto outcome = fill(open, request);
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_EQ(outcome->holes[0].status, FillStatus::Refused);
    EXPECT_NE(outcome->holes[0].reason.find("not planar"), std::string::npos);
    EXPECT_TRUE(outcome->shape.IsSame(open));
}

TEST(FillHoles, StopsWhenCancelled) {
    const Body body = bodies().front();
    const TopoDS_Shape open = grids::shell_of(body.surface, body.us, body.vs, {{0, 0}});
    std::stop_source source;
    source.request_stop();
    FillRequest request;
    request.progress.cancel = source.get_token();
    const auto outcome = fill(open, request);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::Cancelled);
}

/// `mvs` on a window in a torus across whose edges the curvature changes its sign.
HoleReport fill_tube_by_mvs(double curvature_tolerance, FillOutcome& outcome) {
    const Handle<Geom_Surface> tube = occ::make<Geom_ToroidalSurface>(gp_Ax3(), 5.0, 1.5);
    const TopoDS_Shape open = grids::shell_of(tube, {0.0, 0.5, 1.1, 3.5, 2.0 * kPi},
                                              {0.0, 1.2, 2.0, 3.0, 2.0 * kPi}, {{1, 1}});
    FillRequest request;
    request.method = "mvs";
    request.tolerance.curvature = curvature_tolerance;
    outcome = fill(open, request).value();
    return outcome.holes.front();
}

TEST(FillHoles, JoinsWithContinuousCurvatureWhereTheNeighboursAgree) {
    FillOutcome outcome;
    const HoleReport hole = fill_tube_by_mvs(0.02, outcome);
    ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
    expect_closed_solid(outcome);
    EXPECT_TRUE(hole.verdict.within());
    EXPECT_EQ(hole.continuity_reached, Continuity::G2);
    for (const SideReport& side : hole.sides) {
        EXPECT_EQ(side.requested, Continuity::G2) << side.reason;
        EXPECT_LT(side.curvature_mismatch, 0.02);
    }
}

TEST(FillHoles, IsContentWithTangencyWhereCurvatureIsNotReached) {
    FillOutcome outcome;
    const HoleReport hole = fill_tube_by_mvs(1e-9, outcome);
    ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
    expect_closed_solid(outcome);
    EXPECT_TRUE(hole.verdict.within());
    EXPECT_GE(hole.continuity_reached, Continuity::G1);
    for (const SideReport& side : hole.sides) {
        EXPECT_EQ(side.requested, Continuity::G1);
        EXPECT_GT(side.curvature_mismatch, 1e-9);
        EXPECT_NE(side.reason.find("was tried"), std::string::npos) << side.reason;
    }
}

/// A box with a round top, without it: walls around an opening that is not planar.
TopoDS_Shape box_without_its_round_top() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(4.0, 3.0, 10.0).Shape();
    const TopoDS_Shape rod =
        BRepPrimAPI_MakeCylinder(gp_Ax2({-1.0, 1.5, 3.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}), 5.0,
                                 6.0)
            .Shape();
    const TopoDS_Shape body = BRepAlgoAPI_Common(box, rod).Shape();
    int number = 0;
    for (TopExp_Explorer it(body, TopAbs_FACE); it.More(); it.Next(), ++number) {
        if (BRepAdaptor_Surface(TopoDS::Face(it.Current())).GetType() == GeomAbs_Cylinder) {
            return grids::without_faces(body, {number});
        }
    }
    return {};
}

TEST(FillHoles, ClosesABoxWithoutItsRoundTopInPosition) {
    const TopoDS_Shape open = box_without_its_round_top();
    const auto outcome = fill(open);
    ASSERT_TRUE(outcome) << outcome.error().message;
    expect_closed_solid(*outcome);
    const HoleReport& hole = outcome->holes.front();
    ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
    EXPECT_TRUE(hole.verdict.within()) << hole.reason;
    for (const SideReport& side : hole.sides) {
        EXPECT_EQ(side.requested, Continuity::G0);
        EXPECT_NE(side.reason.find("as walls do"), std::string::npos) << side.reason;
        EXPECT_GT(side.angle, radians(45.0));
    }
    // 4 times the area below an arc of radius 5 about (1.5, 3).
    const double arc = 1.5 * std::sqrt(25.0 - 2.25) + 25.0 * std::asin(0.3);
    const double truth = 4.0 * (3.0 * 3.0 + arc);
    EXPECT_NEAR(volume(outcome->shape), truth, 1e-3 * truth);

    FillRequest tangent;
    tangent.continuity = Continuity::G1;
    const auto asked = fill(open, tangent);
    ASSERT_TRUE(asked) << asked.error().message;
    for (const SideReport& side : asked->holes.front().sides) {
        EXPECT_EQ(side.requested, Continuity::G1);
    }
}

// Whose sides are asked for tangency by our own choice all the same.
TEST(ChooseSmoothest, GivesUpTangencyWhereWallsLeaveNone) {
    const TopoDS_Shape open = box_without_its_round_top();
    const auto loops = find_loops(open, occ::Numbering(open));
    ASSERT_TRUE(loops) << loops.error().message;
    for (const bool own : {true, false}) {
        auto hole = extract_hole(*loops);
        ASSERT_TRUE(hole) << hole.error().message;
        for (Ribbon& ribbon : hole->loops.front().ribbons) {
            ribbon.continuity = Continuity::G1;
        }
        std::vector<Wish> wishes(4, {Continuity::G1, "tangent", /*hoped=*/false, own});
        FillRequest request;
        request.method = "mvs";
        const auto choice =
            choose_smoothest({open, *loops}, *hole, wishes, request, request.tolerance);
        if (own) {
            ASSERT_TRUE(choice) << choice.error().message;
            EXPECT_TRUE(choice->near());
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const Continuity expected = own ? Continuity::G0 : Continuity::G1;
            EXPECT_EQ(wishes[i].continuity, expected);
            EXPECT_EQ(hole->loops.front().ribbons[i].continuity, expected);
            EXPECT_EQ(wishes[i].reason.find("tangency was tried") != std::string::npos, own)
                << wishes[i].reason;
        }
    }
}

TEST(FillHoles, GivesOcctsFillingAsItIs) {
    const Body body = bodies().front();
    for (const PlateSetting setting : {PlateSetting::Default, PlateSetting::Tuned}) {
        const TopoDS_Shape open = grids::shell_of(body.surface, body.us, body.vs, {{1, 1}});
        FillRequest request;
        request.method = "occt";
        request.plate_setting = setting;
        const auto outcome = fill(open, request);
        ASSERT_TRUE(outcome) << outcome.error().message;
        const HoleReport& hole = outcome->holes.front();
        ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
        EXPECT_EQ(outcome->shape.ShapeType(), TopAbs_SOLID);
        EXPECT_GT(hole.patches.front().poles_u, 8);
        EXPECT_LT(hole.max_angle, radians(2.0));
        EXPECT_GT(hole.max_angle, radians(1e-5));  // it is no exact continuation
    }
}

/// `occt` on a window that takes this much of the tube's turn.
HoleReport fill_window_by_occt(double turn, bool keep_bad, FillOutcome& outcome) {
    const Handle<Geom_Surface> tube = occ::make<Geom_ToroidalSurface>(gp_Ax3(), 5.0, 1.5);
    const TopoDS_Shape open = grids::shell_of(tube, {0.0, 0.9, 2.0, 3.5, 5.0, 2.0 * kPi},
                                              {0.0, turn, 5.4, 2.0 * kPi}, {{1, 0}});
    FillRequest request;
    request.method = "occt";
    request.keep_bad = keep_bad;
    outcome = fill(open, request).value();
    return outcome.holes.front();
}

TEST(FillHoles, TriesOcctAgainWhereItsSurfaceFolds) {
    FillOutcome outcome;
    const HoleReport hole = fill_window_by_occt(3.5, /*keep_bad=*/true, outcome);
    ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
    expect_closed_solid(outcome);
    EXPECT_EQ(hole.verdict.severity, Severity::Bad);
    EXPECT_NE(hole.reason.find("occt: "), std::string::npos) << hole.reason;
    EXPECT_NE(hole.reason.find("occt (position only): "), std::string::npos) << hole.reason;
}

std::string bytes_of(const TopoDS_Shape& shape) {
    std::ostringstream bytes;
    BRepTools::Write(shape, bytes);
    return bytes.str();
}

TEST(FillHoles, LeavesAHoleOpenWhoseBestFillIsBad) {
    FillOutcome outcome;
    const HoleReport hole = fill_window_by_occt(4.6, /*keep_bad=*/false, outcome);
    EXPECT_EQ(hole.status, FillStatus::Refused);
    EXPECT_TRUE(hole.tried);
    EXPECT_EQ(hole.verdict.severity, Severity::Bad);
    EXPECT_GT(hole.max_angle, radians(5.0));
    EXPECT_NE(hole.reason.find("--keep-bad"), std::string::npos) << hole.reason;
    EXPECT_TRUE(outcome.new_faces.empty());
}

/// A box of 20 without its lid, and in it a post that stands out of it.
TopoDS_Shape box_with_a_post() {
    const BRep_Builder builder;
    TopoDS_Compound model;
    builder.MakeCompound(model);
    builder.Add(model, grids::without_faces(BRepPrimAPI_MakeBox(20.0, 20.0, 10.0).Shape(), {5}));
    builder.Add(model,
                BRepPrimAPI_MakeBox(gp_Pnt(8.0, 7.0, 2.0), gp_Pnt(12.0, 14.0, 15.0)).Shape());
    return model;
}

TEST(FillHoles, PutsNoLidThroughAPost) {
    const TopoDS_Shape model = box_with_a_post();
    FillRequest request;
    request.method = "plane";
    const std::string before = bytes_of(model);
    const auto outcome = fill(model, request);
    ASSERT_TRUE(outcome) << outcome.error().message;
    const HoleReport& hole = outcome->holes.front();
    EXPECT_EQ(hole.status, FillStatus::Refused);
    ASSERT_FALSE(hole.verdict.findings.empty());
    EXPECT_EQ(hole.verdict.findings.front().kind, FindingKind::Clash);
    EXPECT_EQ(bytes_of(model), before);
    request.keep_bad = true;
    EXPECT_EQ(fill(model, request).value().holes.front().status, FillStatus::Filled);
}

TEST(FillHoles, LeavesNoTraceOfACancelledRun) {
    const Body body = bodies().front();
    const TopoDS_Shape open = grids::shell_of(body.surface, body.us, body.vs, {{0, 0}, {2, 1}});
    const std::string before = bytes_of(open);
    std::stop_source source;
    FillRequest request;
    request.method = "mvs";
    request.progress.cancel = source.get_token();
    // Stops as soon as the first hole is computed.
    request.progress.report = [&](double fraction, std::string_view /*stage*/) {
        if (fraction > 0.0) {
            source.request_stop();
        }
    };
    const auto outcome = fill(open, request);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(bytes_of(open), before);
}

TEST(FillHoles, GivesTheSameBytesOnAnyNumberOfThreads) {
    const Body body = bodies().front();
    std::vector<std::string> results;
    for (const std::size_t threads : {1U, 2U, 5U}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        FillRequest request;
        request.method = "mvs";
        const TopoDS_Shape open =
            grids::shell_of(body.surface, body.us, body.vs, {{0, 0}, {2, 1}, {1, 2}});
        results.push_back(bytes_of(fill(open, request).value().shape));
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
}

}  // namespace
}  // namespace suture

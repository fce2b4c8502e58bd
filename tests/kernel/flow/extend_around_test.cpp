#include "support/grids.h"
#include "support/read_for_test.h"
#include "suture/detect/find_loops.h"
#include "suture/fill_holes.h"
#include "suture/occ/handle.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <STEPControl_Writer.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace suture {
namespace {

using grids::without_faces;
using occ::Handle;

constexpr double kTurn = 2.0 * kPi;

double volume(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties, 1e-10);
    return properties.Mass();
}

/// A surface cut into cells, in its own frame and with plane discs on some of its lines v = const.
struct Body {
    std::string name;
    Handle<Geom_Surface> surface;
    std::vector<double> us, vs;
    std::vector<double> discs;
    std::set<std::pair<int, int>> missing;
};

gp_Ax3 axes() {
    return {gp_Pnt(1, -2, 3), gp_Dir(1, 2, -1), gp_Dir(1, 1, 3)};
}

/// All cells but the missing ones, sewn before any is taken out.
TopoDS_Shape shell_of(const Body& body, bool with_missing) {
    constexpr double kTolerance = 1e-7;
    BRepBuilderAPI_Sewing sewing(kTolerance);
    std::vector<TopoDS_Face> taken;
    for (int i = 0; i + 1 < static_cast<int>(body.us.size()); ++i) {
        for (int j = 0; j + 1 < static_cast<int>(body.vs.size()); ++j) {
            const auto a = static_cast<std::size_t>(i);
            const auto b = static_cast<std::size_t>(j);
            const TopoDS_Face face = BRepBuilderAPI_MakeFace(
                body.surface, body.us[a], body.us[a + 1], body.vs[b], body.vs[b + 1], kTolerance);
            sewing.Add(face);
            if (!with_missing && body.missing.contains({i, j})) {
                taken.push_back(face);
            }
        }
    }
    for (const double v : body.discs) {
        BRepBuilderAPI_MakeWire wire;
        for (std::size_t i = 0; i + 1 < body.us.size(); ++i) {
            wire.Add(BRepBuilderAPI_MakeEdge(body.surface->VIso(v), body.us[i], body.us[i + 1]));
        }
        sewing.Add(BRepBuilderAPI_MakeFace(wire, /*OnlyPlane=*/Standard_True));
    }
    sewing.Perform();
    const BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (TopExp_Explorer it(sewing.SewedShape(), TopAbs_FACE); it.More(); it.Next()) {
        if (std::none_of(taken.begin(), taken.end(), [&](const TopoDS_Face& face) {
                return sewing.ModifiedSubShape(face).IsSame(it.Current());
            })) {
            builder.Add(shell, it.Current());
        }
    }
    return shell;
}

/// The missing cells of whole rows and columns.
std::set<std::pair<int, int>> row(int j, int columns) {
    std::set<std::pair<int, int>> cells;
    for (int i = 0; i < columns; ++i) {
        cells.insert({i, j});
    }
    return cells;
}
std::set<std::pair<int, int>> column(int i, int rows) {
    std::set<std::pair<int, int>> cells;
    for (int j = 0; j < rows; ++j) {
        cells.insert({i, j});
    }
    return cells;
}

Handle<Geom_Surface> spline_of(const Handle<Geom_Surface>& surface) {
    const auto spline = GeomConvert::SurfaceToBSplineSurface(surface);
    spline->SetUNotPeriodic();
    spline->SetVNotPeriodic();
    return spline;
}

std::vector<Body> bodies() {
    const Handle<Geom_Surface> cylinder = occ::make<Geom_CylindricalSurface>(axes(), 2.0);
    const Handle<Geom_Surface> cone = occ::make<Geom_ConicalSurface>(axes(), 0.4, 1.0);
    const Handle<Geom_Surface> blunt = occ::make<Geom_ConicalSurface>(axes(), -1.1, 1.5);
    const Handle<Geom_Surface> sphere = occ::make<Geom_SphericalSurface>(axes(), 4.0);
    const Handle<Geom_Surface> torus = occ::make<Geom_ToroidalSurface>(axes(), 5.0, 1.5);
    const double tip = -1.0 / std::sin(0.4);
    const double blunt_tip = 1.5 / std::sin(1.1);
    const std::vector<double> one = {0.0, kTurn};
    const std::vector<double> four = {0.0, 1.3, 2.9, 4.4, kTurn};
    std::vector<Body> result;
    for (const auto& us : {one, four}) {
        const int n = static_cast<int>(us.size()) - 1;
        const std::string cells = n == 1 ? ", whole" : ", in cells";
        result.push_back({"cylinder band" + cells, cylinder, us, {0, 1, 3, 4}, {0, 4}, row(1, n)});
        result.push_back({"cone band" + cells, cone, us, {0, 1, 3, 4}, {0, 4}, row(1, n)});
        result.push_back({"cone tip" + cells, cone, us, {tip, 0.2, 3}, {3}, row(0, n)});
        result.push_back(
            {"blunt cone tip" + cells, blunt, us, {-2, 0.1, blunt_tip}, {-2}, row(1, n)});
        for (const double v : {-0.7, -0.1, 0.0, 0.6, 1.3}) {
            result.push_back({fmt::format("sphere above {}{}", v, cells),
                              sphere,
                              us,
                              {-kPi / 2, v, kPi / 2},
                              {},
                              row(1, n)});
        }
        result.push_back(
            {"sphere band" + cells, sphere, us, {-kPi / 2, -0.4, 0.7, kPi / 2}, {}, row(1, n)});
        result.push_back({"torus band" + cells, torus, us, {0, 1.7, 3.6, kTurn}, {}, row(1, n)});
        result.push_back(
            {"torus outer band" + cells, torus, us, {0.8, 3.6, 4.1, kTurn + 0.8}, {}, row(0, n)});
        result.push_back(
            {"torus elbow" + cells, torus, {0, 1.3, 2.9, kTurn}, us, {}, column(1, n)});
        result.push_back(
            {"torus first elbow" + cells, torus, {0, 1.3, 2.9, kTurn}, us, {}, column(0, n)});
        const auto pieces = [&](const Handle<Geom_Surface>& s, double v0, double v1) {
            return spline_of(occ::make<Geom_RectangularTrimmedSurface>(s, 0, kTurn, v0, v1));
        };
        result.push_back({"B-spline cylinder band" + cells,
                          pieces(cylinder, 0, 4),
                          us,
                          {0, 1, 3, 4},
                          {0, 4},
                          row(1, n)});
        result.push_back({"B-spline sphere cap" + cells,
                          spline_of(sphere),
                          us,
                          {-kPi / 2, 0.6, kPi / 2},
                          {},
                          row(1, n)});
        result.push_back({"B-spline torus band" + cells,
                          spline_of(torus),
                          us,
                          {0, 1.7, 3.6, kTurn},
                          {},
                          row(1, n)});
        result.push_back({"B-spline torus elbow" + cells,
                          spline_of(torus),
                          {0, 1.3, 2.9, kTurn},
                          us,
                          {},
                          column(0, n)});
    }
    // Windows that lie across the neighbours' own seams.
    const std::set<std::pair<int, int>> beside = {{0, 1}, {3, 1}};
    result.push_back({"cylinder window", cylinder, four, {0, 1, 3, 4}, {0, 4}, beside});
    for (const auto& ring : {torus, spline_of(torus)}) {
        const std::string kind = ring == torus ? "torus" : "B-spline torus";
        result.push_back({kind + " window", ring, four, {0, 1.7, 3.6, kTurn}, {}, beside});
        result.push_back({kind + " window across both seams",
                          ring,
                          four,
                          {0, 1.7, 3.6, kTurn},
                          {},
                          {{0, 0}, {3, 0}, {0, 2}, {3, 2}}});
        result.push_back({kind + " band across a seam",
                          ring,
                          four,
                          {0, 0.8, 5.2, kTurn},
                          {},
                          {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 2}, {1, 2}, {2, 2}, {3, 2}}});
    }
    for (const int i : {0, 1, 3}) {
        result.push_back({fmt::format("part {} of a cone's tip", i),
                          cone,
                          {0.0, 1.3, 2.9, 3.2, kTurn},
                          {tip, 0.2, 3},
                          {3},
                          {{i, 0}}});
        result.push_back({fmt::format("part {} of a B-spline sphere's end", i),
                          spline_of(sphere),
                          {0.0, 1.3, 2.9, 3.2, kTurn},
                          {-kPi / 2, 0.6, kPi / 2},
                          {},
                          {{i, 1}}});
    }
    result.push_back(
        {"most of a cone's tip", cone, four, {tip, 0.2, 3}, {3}, {{0, 0}, {1, 0}, {3, 0}}});
    return result;
}

Result<FillOutcome> fill(const TopoDS_Shape& shape, const FillRequest& request = {}) {
    return fill_holes(shape, occ::Numbering(shape), request);
}

/// Written to a STEP file and read again.
TopoDS_Shape through_step(const TopoDS_Shape& shape) {
    const std::string path =
        (std::filesystem::temp_directory_path() /
         fmt::format("suture_extend_{}.step", testing::UnitTest::GetInstance()->random_seed()))
            .string();
    STEPControl_Writer writer;
    writer.Transfer(shape, STEPControl_AsIs);
    writer.Write(path.c_str());
    TopoDS_Shape read = test::read_for_test(path);
    std::filesystem::remove(path);
    return read;
}

void expect_closed_solid(const TopoDS_Shape& shape, double truth) {
    ASSERT_EQ(shape.ShapeType(), TopAbs_SOLID);
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
    for (TopExp_Explorer it(shape, TopAbs_SHELL); it.More(); it.Next()) {
        EXPECT_TRUE(BRep_Tool::IsClosed(it.Current()));
    }
    EXPECT_NEAR(volume(shape), truth, 1e-7 * truth);
}

/// The outcome as made and as read back from a STEP file.
void expect_closed_solid_also_in_step(const FillOutcome& outcome, double truth) {
    ASSERT_EQ(outcome.holes.front().status, FillStatus::Filled) << outcome.holes.front().reason;
    EXPECT_EQ(outcome.holes.front().method_used, "extend") << outcome.holes.front().reason;
    EXPECT_EQ(outcome.new_faces.size(), 1U);
    {
        SCOPED_TRACE("as made");
        expect_closed_solid(outcome.shape, truth);
    }
    SCOPED_TRACE("through STEP");
    expect_closed_solid(through_step(outcome.shape), truth);
}

/// The largest distance of a face's vertices, edges and inner points from a surface.
double distance(const TopoDS_Face& face, const Handle<Geom_Surface>& truth) {
    double u0 = 0.0;
    double u1 = 0.0;
    double v0 = 0.0;
    double v1 = 0.0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const Handle<Geom_Surface> surface = BRep_Tool::Surface(face);
    double largest = 0.0;
    for (int i = 0; i <= 8; ++i) {
        for (int j = 0; j <= 8; ++j) {
            const gp_Pnt p =
                surface->Value(u0 + (u1 - u0) * (i + 0.1) / 8.2, v0 + (v1 - v0) * (j + 0.1) / 8.2);
            largest = std::max(largest, GeomAPI_ProjectPointOnSurf(p, truth).LowerDistance());
        }
    }
    return largest;
}

TEST(ExtendAround, RestoresWhatIsMissingAllTheWayAround) {
    for (const Body& body : bodies()) {
        SCOPED_TRACE(body.name);
        const TopoDS_Shape open = shell_of(body, false);
        const double truth = std::abs(volume(shell_of(body, true)));
        const auto loops = find_loops(open, occ::Numbering(open));
        ASSERT_TRUE(loops);
        FillRequest request;
        request.method = "extend";
        request.holes = {loops->size() == 1 ? std::vector{1} : std::vector{1, 2}};
        const auto outcome = fill(open, request);
        ASSERT_TRUE(outcome) << outcome.error().message;
        EXPECT_LT(outcome->holes.front().max_gap, 1e-9);
        EXPECT_LT(outcome->holes.front().max_angle, 1e-7);
        expect_closed_solid_also_in_step(*outcome, truth);
        EXPECT_LT(distance(outcome->new_faces.front(), body.surface), 1e-9);
    }
}

TEST(ExtendAround, TakesTheLoopsOfABandTogetherUnasked) {
    for (const Body& body : bodies()) {
        const TopoDS_Shape open = shell_of(body, false);
        const auto loops = find_loops(open, occ::Numbering(open));
        ASSERT_TRUE(loops);
        if (loops->size() == 1) {
            continue;
        }
        SCOPED_TRACE(body.name);
        if (body.name.starts_with("B-spline torus") && loops->front().islands_with.empty()) {
            continue;  // no closed form says that they belong together
        }
        const auto outcome = fill(open);
        ASSERT_TRUE(outcome) << outcome.error().message;
        ASSERT_EQ(outcome->holes.size(), 1U);
        EXPECT_EQ(outcome->holes.front().ids.size(), 2U);
        EXPECT_EQ(outcome->holes.front().method_used, "extend");
        EXPECT_EQ(outcome->shape.ShapeType(), TopAbs_SOLID);
    }
}

/// Two parts of one body whose rows of edges begin in different places.
TopoDS_Shape turned_apart(const Handle<Geom_Surface>& lower, const Handle<Geom_Surface>& upper,
                          const std::vector<double>& us) {
    const BRep_Builder builder;
    TopoDS_Compound both;
    builder.MakeCompound(both);
    builder.Add(both, shell_of({"", lower, us, {0, 1}, {0}, {}}, true));
    builder.Add(both, shell_of({"", upper, us, {3, 4}, {4}, {}}, true));
    return both;
}

TEST(ExtendAround, FindsASeamBetweenCornersThatDoNotFaceEachOther) {
    const auto turned = [](double angle) {
        gp_Ax3 frame = axes();
        frame.Rotate(gp_Ax1(frame.Location(), frame.Direction()), angle);
        return frame;
    };
    for (const double angle : {1e-9, 1e-3, 0.9, 2.0, 3.1, -2.5}) {
        for (const auto& us : {std::vector{0.0, kTurn}, std::vector{0.0, 2.0, kTurn}}) {
            for (const bool reversed : {false, true}) {
                SCOPED_TRACE(testing::Message() << angle << " " << us.size() << " " << reversed);
                TopoDS_Shape open =
                    turned_apart(occ::make<Geom_CylindricalSurface>(axes(), 2.0),
                                 occ::make<Geom_CylindricalSurface>(turned(angle), 2.0), us);
                open = reversed ? open.Reversed() : open;
                const auto cylinder = fill(open);
                ASSERT_TRUE(cylinder) << cylinder.error().message;
                TopoDS_Shape made = cylinder->shape;
                ASSERT_EQ(made.ShapeType(), TopAbs_COMPOUND);
                TopExp_Explorer it(made, TopAbs_SOLID);
                ASSERT_TRUE(it.More());
                EXPECT_EQ(cylinder->holes.front().method_used, "extend");
                expect_closed_solid(it.Current(), 16.0 * kPi);
                TopExp_Explorer read(through_step(it.Current()), TopAbs_SOLID);
                ASSERT_TRUE(read.More());
                expect_closed_solid(read.Current(), 16.0 * kPi);
            }
        }
    }
}

TEST(ExtendAround, LeavesAnIslandInTheBand) {
    const Handle<Geom_Surface> cone = occ::make<Geom_ConicalSurface>(axes(), 0.4, 1.0);
    for (const int kept : {0, 1, 3}) {
        SCOPED_TRACE(kept);
        Body with_island{"", cone, {0.0, 1.3, 2.9, 4.4, kTurn}, {0, 1, 1.5, 2, 2.5, 4}, {0, 4}, {}};
        for (int i = 0; i < 4; ++i) {
            for (const int j : {1, 2, 3}) {
                if (i != kept || j != 2) {
                    with_island.missing.insert({i, j});
                }
            }
        }
        const TopoDS_Shape open = shell_of(with_island, false);
        FillRequest request;
        request.method = "extend";
        request.holes = {{1, 2, 3}};
        const auto outcome = fill(open, request);
        ASSERT_TRUE(outcome) << outcome.error().message;
        expect_closed_solid_also_in_step(*outcome, std::abs(volume(shell_of(with_island, true))));
    }
}

TEST(ExtendAround, IsTheSameReversedMovedAndScaled) {
    const std::vector<Body> all = bodies();
    for (const double scale : {1e-3, 1e3}) {
        for (const bool reversed : {false, true}) {
            for (std::size_t k = 0; k < all.size(); k += 5) {
                const Body& body = all[k];
                SCOPED_TRACE(testing::Message() << body.name << " " << scale << " " << reversed);
                gp_Trsf size;
                size.SetScale(gp_Pnt(1, 2, 3), scale);
                gp_Trsf turn;
                turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -1, 2)), 0.9);
                TopoDS_Shape open =
                    BRepBuilderAPI_Transform(shell_of(body, false), size * turn, true).Shape();
                open = reversed ? open.Reversed() : open;
                const auto loops = find_loops(open, occ::Numbering(open));
                ASSERT_TRUE(loops);
                FillRequest request;
                request.method = "extend";
                request.tolerance.linear *= std::min(scale, 1.0);
                request.holes = {loops->size() == 1 ? std::vector{1} : std::vector{1, 2}};
                const auto outcome = fill(open, request);
                ASSERT_TRUE(outcome) << outcome.error().message;
                EXPECT_LT(outcome->holes.front().max_gap, 1e-9 * scale + 1e-12);
                const double truth = std::abs(volume(shell_of(body, true))) * std::pow(scale, 3.0);
                expect_closed_solid_also_in_step(*outcome, truth);
            }
        }
    }
}

TEST(ExtendAround, LeavesASteepOpeningToALidUnlessTangencyIsAskedFor) {
    for (const Body& body : bodies()) {
        const bool steep = body.name == "cone tip, whole" || body.name == "sphere above 0.0, whole";
        if (!steep && body.name != "blunt cone tip, whole" &&
            body.name != "sphere above 1.3, whole") {
            continue;
        }
        SCOPED_TRACE(body.name);
        const TopoDS_Shape open = shell_of(body, false);
        const auto unasked = fill(open);
        ASSERT_TRUE(unasked) << unasked.error().message;
        EXPECT_EQ(unasked->holes.front().method_used, steep ? "plane" : "extend");
        FillRequest request;
        request.continuity = Continuity::G1;
        const auto tangent = fill(open, request);
        ASSERT_TRUE(tangent) << tangent.error().message;
        EXPECT_EQ(tangent->holes.front().method_used, "extend");
    }
}

/// A cylinder that two slanting planes cut in three, without the middle part's round face.
TEST(ExtendAround, FillsBetweenSlantingCuts) {
    const TopoDS_Shape rod =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 2, -1)), 2.0, 20.0).Shape();
    const auto half_space = [](double height, double slope, bool above) {
        gp_Pln plane(gp_Ax3(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 2, -1))));
        plane.Translate(height * gp_Vec(plane.Axis().Direction()));
        plane.Rotate(gp_Ax1(plane.Location(), plane.XAxis().Direction()), slope);
        const gp_Pnt side =
            plane.Location().Translated((above ? 1.0 : -1.0) * gp_Vec(plane.Axis().Direction()));
        return BRepPrimAPI_MakeHalfSpace(
                   BRepBuilderAPI_MakeFace(plane, -50.0, 50.0, -50.0, 50.0).Face(), side)
            .Solid();
    };
    const auto part = [&](double height, double slope, bool above) {
        const TopoDS_Shape cut = BRepAlgoAPI_Common(rod, half_space(height, slope, above));
        std::set<int> slanting;
        int number = 0;
        for (TopExp_Explorer it(cut, TopAbs_FACE); it.More(); it.Next(), ++number) {
            const BRepAdaptor_Surface surface(TopoDS::Face(it.Current()));
            if (surface.GetType() == GeomAbs_Plane &&
                !surface.Plane().Axis().IsParallel(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 2, -1)),
                                                   1e-6)) {
                slanting.insert(number);
            }
        }
        return without_faces(cut, slanting);
    };
    for (const double slope : {0.3, -0.5}) {
        const BRep_Builder builder;
        TopoDS_Compound both;
        builder.MakeCompound(both);
        builder.Add(both, part(6.0, slope, false));
        builder.Add(both, part(13.0, -0.2, true));
        const auto outcome = fill(both);
        ASSERT_TRUE(outcome) << outcome.error().message;
        ASSERT_EQ(outcome->holes.size(), 1U);
        EXPECT_EQ(outcome->holes.front().method_used, "extend") << outcome->holes.front().reason;
        TopExp_Explorer it(outcome->shape, TopAbs_SOLID);
        ASSERT_TRUE(it.More());
        expect_closed_solid(it.Current(), 80.0 * kPi);
        expect_closed_solid(through_step(it.Current()), 80.0 * kPi);
    }
}

}  // namespace
}  // namespace suture

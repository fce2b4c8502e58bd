#include "support/grids.h"
#include "support/properties.h"
#include "suture/fill_holes.h"
#include "suture/occ/topology.h"

#include "kernel/flow/rounded_models.h"
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Poly_Triangulation.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Lin.hxx>

#include <cmath>

namespace suture {
namespace {

using rounded::middle;
using rounded::Model;
using test::area;

struct Placement {
    std::string name;
    gp_Trsf transformation;
    double scale = 1.0;
    bool reversed = false;  ///< inside out
};

std::vector<Placement> placements() {
    std::vector<Placement> result(1);
    gp_Trsf turned;
    turned.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -2, 0.7)), 1.1);
    result.push_back({"turned", turned});
    gp_Trsf small;
    small.SetScale(gp_Pnt(0, 0, 0), 1e-1);
    result.push_back({"small", turned * small, 1e-1});
    gp_Trsf large;
    large.SetScale(gp_Pnt(0, 0, 0), 1e3);
    result.push_back({"large", turned * large, 1e3});
    gp_Trsf far;
    far.SetTranslation(gp_Vec(1e6, -2e6, 5e5));
    result.push_back({"far", far * turned});
    result.push_back({"reversed", turned, 1.0, true});
    return result;
}

TopoDS_Shape placed(const TopoDS_Shape& shape, const Placement& placement) {
    const TopoDS_Shape body =
        BRepBuilderAPI_Transform(shape, placement.transformation, /*Copy=*/true).Shape();
    BRepLib::EncodeRegularity(body, 1e-6);
    return placement.reversed ? body.Reversed() : body;
}

/// Kind, sizes and place of a closed form, to be compared.
void expect_same(const BRepAdaptor_Surface& found, const BRepAdaptor_Surface& truth, double size) {
    ASSERT_EQ(found.GetType(), truth.GetType());
    const double limit = 1e-9 * size;
    const auto same_axis = [&](const gp_Ax1& a, const gp_Ax1& b) {
        EXPECT_LT(gp_Vec(a.Direction()).Crossed(gp_Vec(b.Direction())).Magnitude(), 1e-9);
        EXPECT_LT(gp_Lin(b).Distance(a.Location()), limit);
    };
    switch (truth.GetType()) {
        case GeomAbs_Sphere:
            EXPECT_NEAR(found.Sphere().Radius(), truth.Sphere().Radius(), limit);
            EXPECT_LT(found.Sphere().Location().Distance(truth.Sphere().Location()), limit);
            break;
        case GeomAbs_Cylinder:
            EXPECT_NEAR(found.Cylinder().Radius(), truth.Cylinder().Radius(), limit);
            same_axis(found.Cylinder().Axis(), truth.Cylinder().Axis());
            break;
        case GeomAbs_Cone:
            EXPECT_NEAR(std::abs(found.Cone().SemiAngle()), std::abs(truth.Cone().SemiAngle()),
                        1e-9);
            EXPECT_LT(found.Cone().Apex().Distance(truth.Cone().Apex()), limit);
            same_axis(found.Cone().Axis(), truth.Cone().Axis());
            break;
        case GeomAbs_Torus:
            EXPECT_NEAR(found.Torus().MajorRadius(), truth.Torus().MajorRadius(), limit);
            EXPECT_NEAR(found.Torus().MinorRadius(), truth.Torus().MinorRadius(), limit);
            EXPECT_LT(found.Torus().Location().Distance(truth.Torus().Location()), limit);
            same_axis(found.Torus().Axis(), truth.Torus().Axis());
            break;
        default:
            FAIL() << "no closed form";
    }
}

/// Whether a face's border tells it: half of its sides are tangent to their neighbours, or it is
/// the wall of a bore, between two rims.
bool tells(const TopoDS_Shape& body, const TopoDS_Face& face) {
    TopTools_IndexedDataMapOfShapeListOfShape faces;
    TopExp::MapShapesAndAncestors(body, TopAbs_EDGE, TopAbs_FACE, faces);
    int smooth = 0;
    int all = 0;
    for (const TopoDS_Edge& edge : occ::edges_of(face)) {
        if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) {
            continue;
        }
        const auto& pair = faces.FindFromKey(edge);
        ++all;
        smooth +=
            pair.Extent() == 2 && BRep_Tool::Continuity(edge, TopoDS::Face(pair.First()),
                                                        TopoDS::Face(pair.Last())) >= GeomAbs_G1;
    }
    int wires = 0;
    for (TopExp_Explorer at(face, TopAbs_WIRE); at.More(); at.Next()) {
        ++wires;
    }
    const BRepAdaptor_Surface surface(face);
    const bool ruled = surface.GetType() == GeomAbs_Cylinder || surface.GetType() == GeomAbs_Cone;
    return 2 * smooth >= all || (ruled && surface.IsUClosed() && wires == 1);
}

/// Takes one face out and asks for it back.
void expect_given_back(const TopoDS_Shape& body, int face, double size) {
    const BRepAdaptor_Surface truth(occ::faces_of(body)[static_cast<std::size_t>(face)]);
    const TopoDS_Shape open = grids::without_faces(body, {face});
    FillRequest request;
    request.method = "recognise";
    if (truth.IsUClosed() && truth.GetType() != GeomAbs_Sphere) {
        request.holes = {{1, 2}};
    }
    const auto outcome = fill_holes(open, occ::Numbering(open), request);
    ASSERT_TRUE(outcome) << outcome.error().message;
    const HoleReport& hole = outcome->holes.front();
    ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
    ASSERT_TRUE(hole.recognised);
    EXPECT_TRUE(BRepCheck_Analyzer(outcome->shape).IsValid());
    expect_same(BRepAdaptor_Surface(outcome->new_faces.front()), truth, size);
    // As exact as OCCT's own curves where two cylinders meet.
    EXPECT_NEAR(area(outcome->shape), area(body), 5e-6 * area(body));
}

TEST(Recognise, GivesBackTheExactFaceOfEveryRoundedBody) {
    int count = 0;
    const std::vector<Placement> places = placements();
    const std::vector<Model> models = rounded::models();
    EXPECT_GE(models.size(), 60U);
    for (std::size_t m = 0; m < models.size(); ++m) {
        const Model& model = models[m];
        ASSERT_TRUE(BRepCheck_Analyzer(model.shape).IsValid()) << model.name;
        // As it is, and in one of the other places.
        for (const std::size_t k : {std::size_t(0), 1 + m % (places.size() - 1)}) {
            const Placement& placement = places[k];
            const TopoDS_Shape body = placed(model.shape, placement);
            const auto faces = occ::faces_of(body);
            for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
                const TopoDS_Face& face = faces[static_cast<std::size_t>(i)];
                const BRepAdaptor_Surface truth(face);
                if (model.kinds.contains(truth.GetType()) && tells(body, face)) {
                    SCOPED_TRACE(testing::Message()
                                 << model.name << ", " << placement.name << ", face " << i);
                    ++count;
                    expect_given_back(body, i, 30.0 * placement.scale);
                }
            }
        }
    }
    EXPECT_GE(count, 400);
}

/// A sheet swept along a B-spline profile: turned about the z axis, or pushed along it.
TopoDS_Face swept(bool turned) {
    TColgp_Array1OfPnt points(1, 5);
    const double x[] = {10.0, 13.0, 9.0, 12.0, 11.0};
    for (int i = 1; i <= 5; ++i) {
        points.SetValue(i, turned ? gp_Pnt(x[i - 1], 0, 4.0 * i) : gp_Pnt(x[i - 1], 4.0 * i, 0));
    }
    const TopoDS_Edge profile = BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve());
    const TopoDS_Shape sheet =
        turned ? BRepPrimAPI_MakeRevol(profile, gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ()), 1.5).Shape()
               : BRepPrimAPI_MakePrism(profile, gp_Vec(0, 0, 14)).Shape();
    return TopoDS::Face(sheet);
}

TEST(Recognise, GivesBackWindowsOfRevolvedAndExtrudedFaces) {
    for (const Placement& placement : placements()) {
        for (const bool turned : {true, false}) {
            SCOPED_TRACE(placement.name + (turned ? ", revolved" : ", extruded"));
            // A drill marks the window; behind a revolved sheet's half-way angle, or across the
            // other.
            const gp_Ax2 axis = turned ? gp_Ax2(gp_Pnt(0, 0, 12), gp_Dir(1, 1, 0.1))
                                       : gp_Ax2(gp_Pnt(0, 12, 7), gp_Dir(1, 0.1, 0.2));
            const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(axis, 3.0, 40.0).Shape();
            const TopoDS_Face sheet = swept(turned);
            const TopoDS_Shape window = placed(BRepAlgoAPI_Common(sheet, drill).Shape(), placement);
            const TopoDS_Shape open = placed(BRepAlgoAPI_Cut(sheet, drill).Shape(), placement);
            ASSERT_GT(area(window), 20.0 * placement.scale * placement.scale);
            FillRequest request;
            request.method = "recognise";
            const auto outcome = fill_holes(open, occ::Numbering(open), request);
            ASSERT_TRUE(outcome) << outcome.error().message;
            const HoleReport& hole = outcome->holes.front();
            ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
            EXPECT_NE(hole.recognised->from.find("the surface of face"), std::string::npos);
            ASSERT_EQ(outcome->new_faces.size(), 1U);
            EXPECT_NEAR(area(outcome->new_faces.front()), area(window), 2e-6 * area(window));
            // Every point of the new face lies on the lost one's surface, the border as near as
            // OCCT has cut it.
            const auto surface = BRep_Tool::Surface(occ::faces_of(window).front());
            BRepMesh_IncrementalMesh(outcome->new_faces.front(), 0.05 * placement.scale);
            TopLoc_Location place;
            const auto mesh = BRep_Tool::Triangulation(outcome->new_faces.front(), place);
            ASSERT_FALSE(mesh.IsNull());
            for (int i = 1; i <= mesh->NbNodes(); i += 7) {
                const GeomAPI_ProjectPointOnSurf foot(mesh->Node(i).Transformed(place), surface);
                ASSERT_GT(foot.NbPoints(), 0);
                EXPECT_LT(foot.LowerDistance(), 2e-7 * placement.scale);
            }
        }
    }
}

/// A box with two edges rounded by a radius that grows along them, one the other's mirror image.
TopoDS_Shape growing_fillets() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30.0, 25.0, 20.0).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (const TopoDS_Edge& edge : occ::edges_of(box)) {
        const gp_Pnt p = middle(edge);
        if (std::abs(p.Z() - 20.0) < 1e-6 && std::abs(p.Y() - 12.5) < 1e-6) {
            const bool upwards = BRepAdaptor_Curve(edge).Value(0.0).Y() < 12.5;
            fillet.Add(upwards ? 2.0 : 4.0, upwards ? 4.0 : 2.0, edge);
        }
    }
    fillet.Build();
    return fillet.Shape();
}

TEST(Recognise, GivesBackTheMirroredTwinOfAFace) {
    const TopoDS_Shape body = growing_fillets();
    const auto faces = occ::faces_of(body);
    int found = 0;
    for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
        if (BRepAdaptor_Surface(faces[static_cast<std::size_t>(i)]).GetType() == GeomAbs_Plane) {
            continue;
        }
        ++found;
        const TopoDS_Shape open = grids::without_faces(body, {i});
        FillRequest request;
        request.method = "recognise";
        const auto outcome = fill_holes(open, occ::Numbering(open), request);
        ASSERT_TRUE(outcome) << outcome.error().message;
        const HoleReport& hole = outcome->holes.front();
        ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
        EXPECT_NE(hole.recognised->from.find("mirrored twin of face"), std::string::npos)
            << hole.recognised->from;
        EXPECT_NEAR(area(outcome->shape), area(body), 1e-7 * area(body));
        // Around the hole alone there is none.
        request.recognise = Scope::Neighbours;
        const auto without = fill_holes(open, occ::Numbering(open), request);
        ASSERT_TRUE(without) << without.error().message;
        EXPECT_EQ(without->holes.front().status, FillStatus::Refused);
    }
    EXPECT_EQ(found, 2);
}

TEST(Recognise, IsLeftOutOfAutoWhereItIsNotWanted) {
    const TopoDS_Shape body = growing_fillets();
    FillRequest request;
    request.recognise.reset();
    for (int i = 0; i < 2; ++i) {
        const TopoDS_Shape open = grids::without_faces(body, {i});
        const auto outcome = fill_holes(open, occ::Numbering(open), request);
        ASSERT_TRUE(outcome) << outcome.error().message;
        EXPECT_FALSE(outcome->holes.front().recognised);
    }
}

}  // namespace
}  // namespace suture

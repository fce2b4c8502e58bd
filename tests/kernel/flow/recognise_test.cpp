#include "support/grids.h"
#include "support/properties.h"
#include "suture/fill_holes.h"
#include "suture/occ/topology.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Lin.hxx>

#include <cmath>
#include <functional>
#include <set>

namespace suture {
namespace {

using test::area;

/// A body, and the faces of it that are taken out one at a time: those of these kinds.
struct Model {
    std::string name;
    TopoDS_Shape shape;
    std::set<GeomAbs_SurfaceType> kinds;
};

TopoDS_Shape filleted(const TopoDS_Shape& shape, double radius,
                      const std::function<bool(const TopoDS_Edge&)>& chosen) {
    BRepFilletAPI_MakeFillet fillet(shape);
    for (const TopoDS_Edge& edge : occ::edges_of(shape)) {
        if (chosen(edge)) {
            fillet.Add(radius, edge);
        }
    }
    fillet.Build();
    return fillet.Shape();
}

gp_Pnt middle(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    return curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
}

/// A prism over a polygon, its top edges and those upright rounded with one radius.
TopoDS_Shape rounded_prism(const std::vector<gp_Pnt>& base, double height, double radius) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& p : base) {
        polygon.Add(p);
    }
    polygon.Close();
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(polygon.Wire());
    const TopoDS_Shape prism = BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, height)).Shape();
    return filleted(prism, radius,
                    [&](const TopoDS_Edge& edge) { return middle(edge).Z() > 0.1 * height; });
}

bool is_circle(const TopoDS_Edge& edge) {
    return BRepAdaptor_Curve(edge).GetType() == GeomAbs_Circle;
}

/// A plate with a boss whose foot, or rim, is rounded.
TopoDS_Shape boss(double r, double h, double fillet, bool foot) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -5), gp_Pnt(20, 20, 0)).Shape();
    const TopoDS_Shape post =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1, 2, 0), gp::DZ()), r, h).Shape();
    const TopoDS_Shape whole = BRepAlgoAPI_Fuse(plate, post).Shape();
    const double z = foot ? 0.0 : h;
    return filleted(whole, fillet, [&](const TopoDS_Edge& edge) {
        return is_circle(edge) && std::abs(middle(edge).Z() - z) < 1e-6;
    });
}

/// A box with one upright edge rounded with R and then the rim above with r: a torus corner.
TopoDS_Shape torus_corner(double R, double r) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30.0, 25.0, 20.0).Shape();
    const TopoDS_Shape upright = filleted(box, R, [](const TopoDS_Edge& edge) {
        const gp_Pnt p = middle(edge);
        return p.X() < 1e-6 && p.Y() < 1e-6;
    });
    return filleted(upright, r, [](const TopoDS_Edge& edge) {
        const gp_Pnt p = middle(edge);
        return std::abs(p.Z() - 20.0) < 1e-6 && p.X() + p.Y() < 28.0;
    });
}

/// A box with a slot whose ends are half round and whose bottom edge is rounded.
TopoDS_Shape slot(double width, double depth, double fillet) {
    const double r = 0.5 * width;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-30, -15, -12), gp_Pnt(30, 15, 0)).Shape();
    const gp_Pnt low(-12, 0, -depth);
    TopoDS_Shape tool = BRepPrimAPI_MakeBox(gp_Pnt(-12, -r, -depth), gp_Pnt(12, r, 1)).Shape();
    for (const double x : {-12.0, 12.0}) {
        const gp_Ax2 axis(gp_Pnt(x, 0, -depth), gp::DZ());
        tool = BRepAlgoAPI_Fuse(tool, BRepPrimAPI_MakeCylinder(axis, r, depth + 1).Shape()).Shape();
    }
    const TopoDS_Shape cut = BRepAlgoAPI_Cut(box, tool).Shape();
    return filleted(cut, fillet, [&](const TopoDS_Edge& edge) {
        return std::abs(middle(edge).Z() + depth) < 1e-6 && std::abs(middle(edge).Y()) < r + 1e-6 &&
               std::abs(middle(edge).X()) < 12.0 + r + 1e-6;
    });
}

std::vector<Model> models() {
    const std::set<GeomAbs_SurfaceType> all = {GeomAbs_Sphere, GeomAbs_Torus, GeomAbs_Cylinder,
                                               GeomAbs_Cone};
    std::vector<Model> result;
    const std::vector<gp_Pnt> square = {{0, 0, 0}, {30, 0, 0}, {30, 25, 0}, {0, 25, 0}};
    const std::vector<gp_Pnt> skew = {{0, 0, 0}, {30, 0, 0}, {40, 25, 0}, {8, 22, 0}};
    const std::vector<gp_Pnt> three = {{0, 0, 0}, {40, 5, 0}, {10, 35, 0}};
    for (const double r : {1.5, 3.0, 4.7}) {
        result.push_back({"box", rounded_prism(square, 20, r), all});
        result.push_back({"skew prism", rounded_prism(skew, 20, r), all});
    }
    result.push_back({"three-sided prism", rounded_prism(three, 15, 2.5), all});
    for (const double fillet : {1.0, 2.2}) {
        result.push_back({"boss, foot", boss(6, 10, fillet, true), {GeomAbs_Torus}});
        result.push_back({"boss, rim", boss(6, 10, fillet, false), {GeomAbs_Torus}});
    }
    result.push_back({"torus corner", torus_corner(8, 2), all});
    result.push_back({"torus corner", torus_corner(5, 3), all});
    result.push_back({"slot", slot(8, 5, 1), all});
    return result;
}

struct Placement {
    std::string name;
    gp_Trsf transformation;
    double scale = 1.0;
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
    return result;
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

/// How many sides of a face are tangent to their neighbours is what its border tells.
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
    return smooth >= 0.6 * all;
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
    EXPECT_NEAR(area(outcome->shape), area(body), 1e-6 * area(body));
}

TEST(Recognise, GivesBackTheExactFaceOfEveryRoundedBody) {
    int count = 0;
    for (const Model& model : models()) {
        ASSERT_TRUE(BRepCheck_Analyzer(model.shape).IsValid()) << model.name;
        for (const Placement& placement : placements()) {
            const TopoDS_Shape body =
                BRepBuilderAPI_Transform(model.shape, placement.transformation, true).Shape();
            BRepLib::EncodeRegularity(body, 1e-6);
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

#include "support/grids.h"
#include "support/properties.h"
#include "suture/fill_holes.h"
#include "suture/occ/topology.h"

#include "kernel/flow/placements.h"
#include "kernel/flow/rounded_models.h"
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Lin.hxx>

#include <cmath>
#include <cstdlib>

namespace suture {
namespace {

using placements::placed;
using placements::Placement;
using rounded::Model;
using test::area;

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
    const bool everywhere = std::getenv("SUTURE_EVERY_PLACE") != nullptr;
    const std::vector<Placement> places = placements::all();
    const std::vector<Model> models = rounded::models();
    EXPECT_GE(models.size(), 60U);
    for (std::size_t m = 0; m < models.size(); ++m) {
        const Model& model = models[m];
        ASSERT_TRUE(BRepCheck_Analyzer(model.shape).IsValid()) << model.name;
        // As it is, and in one of the other places; SUTURE_EVERY_PLACE=1: in all of them.
        for (std::size_t k = 0; k < places.size(); ++k) {
            if (!everywhere && k != 0 && k != 1 + m % (places.size() - 1)) {
                continue;
            }
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

}  // namespace
}  // namespace suture

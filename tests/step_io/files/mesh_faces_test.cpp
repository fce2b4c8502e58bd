#include "files/mesh_faces.h"

#include "files/mesh.h"
#include "files/write.h"
#include "suture/occ/topology.h"

#include "step_io/files/assembly.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Pln.hxx>

#include <cmath>

namespace suture::io::test {

namespace {

double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto at = [&](std::uint32_t i) {
            return gp_Pnt(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]);
        };
        sum += 0.5 * gp_Vec(at(a), at(b)).CrossMagnitude(gp_Vec(at(a), at(c)));
    }
    return sum;
}

/// A plane face whose boundary crosses itself in the middle.
TopoDS_Face crossed() {
    const TopoDS_Wire wire = BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 0), gp_Pnt(10, 10, 0),
                                                        gp_Pnt(10, 0, 0), gp_Pnt(0, 10, 0), true);
    return BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), wire);
}

/// FaceN 1 to 6 are the box, with an area of 2200.
TopoDS_Shape box_and(const TopoDS_Shape& other) {
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(50, 50, 50), 30, 20, 10).Shape());
    builder.Add(both, other);
    return both;
}

}  // namespace

TEST(MeshOfFaces, OneThatOcctCannotMeshIsNamedAndTheRestIsThere) {
    const Result<Mesh> mesh = make_mesh(box_and(crossed()), {0.1, 0.35});
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_NEAR(area(*mesh), 2200.0, 1e-9);
    EXPECT_EQ(mesh->facts.open_edges, 0U);
    ASSERT_EQ(mesh->facts.left_out.size(), 1U);
    EXPECT_TRUE(mesh->facts.left_out[0].area);
    EXPECT_EQ(text_of(mesh->facts.left_out[0]),
              "face 7 could not be meshed: its boundary crosses itself");
}

TEST(MeshOfFaces, WhoeverIsNotToldOfThemGetsNoMeshWithoutThem) {
    const Folder folder;
    const auto done = write_model(model_of(box_and(crossed()), "both"), folder / "a.stl",
                                  Format::Stl, {0.1, 0.35});
    ASSERT_FALSE(done);
    EXPECT_NE(done.error().message.find("face 7 could not be meshed"), std::string::npos);
    const auto nothing =
        write_mesh(model_of(crossed(), "crossed"), folder / "a.stl", Format::Stl, {0.1, 0.35});
    ASSERT_FALSE(nothing);
    EXPECT_FALSE(exists(folder / "a.stl"));
}

TEST(MeshOfFaces, ThoseThatHaveCollapsedToALineAreNoLoss) {
    SUTURE_NEEDS_CAD_FILES();
    const TopoDS_Shape shape = read(cad("simple_wing.stp")).shape();
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    const Result<Mesh> mesh = make_mesh(shape, {5.0, 0.35});
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_NEAR(area(*mesh), properties.Mass(), 1e-3 * properties.Mass());
    std::vector<int> faces;
    for (const UnmeshedFace& face : mesh->facts.left_out) {
        faces.push_back(face.face);
        EXPECT_FALSE(face.area);
    }
    EXPECT_EQ(faces, (std::vector{1, 4, 5, 8, 9, 12}));
}

TEST(MeshOfFaces, OneThatFailsIsMeshedFinerAndTheOthersAsWanted) {
    SUTURE_NEEDS_CAD_FILES();
    const TopoDS_Shape shape = read(cad("lower_leg_structure_base.STEP")).shape();
    const double wanted = 1e-3 * occ::diagonal(shape);  // face 98 fails with it
    const Result<Mesh> mesh = make_mesh(shape, {wanted, 0.35});
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->facts.deflection, wanted);
    EXPECT_TRUE(mesh->facts.left_out.empty());
    EXPECT_EQ(mesh->facts.open_edges, 0U);
    EXPECT_LT(mesh->triangles.size(), 20000U);  // ten times finer all over: 38508
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    EXPECT_NEAR(area(*mesh), properties.Mass(), 2e-3 * properties.Mass());
}

}  // namespace suture::io::test

#include "files/mesh.h"

#include "files/mesh_repair.h"
#include "suture/occ/topology.h"

#include "step_io/files/assembly.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS.hxx>

#include <cstdlib>
#include <map>

namespace suture::io::test {

namespace {

/// Directed edges that do not have their opposite exactly once.
int open_edges(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            ++count[{triangle[i], triangle[(i + 1) % 3]}];
        }
    }
    int open = 0;
    for (const auto& [edge, times] : count) {
        const auto opposite = count.find({edge.second, edge.first});
        open += times == 1 && opposite != count.end() && opposite->second == 1 ? 0 : 1;
    }
    return open;
}

double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& [p, q, r] = std::tie(mesh.points[a], mesh.points[b], mesh.points[c]);
        sum += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
               p[2] * (q[0] * r[1] - q[1] * r[0]);
    }
    return sum / 6.0;
}

GProp_GProps volume_of(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties;
}

double area(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    return properties.Mass();
}

Mesh mesh_of(const TopoDS_Shape& shape, double deflection) {
    Result<Mesh> mesh = make_mesh(shape, {deflection, 0.35});
    if (!mesh) {
        throw std::runtime_error(mesh.error().message);
    }
    return *std::move(mesh);
}

/// Closed, outward, and no further from the body than the deflection allows.
void expect_good_mesh(const TopoDS_Shape& shape, double deflection, const std::string& what) {
    const Mesh mesh = mesh_of(shape, deflection);
    EXPECT_EQ(open_edges(mesh), 0) << what;
    EXPECT_NEAR(volume(mesh), volume_of(shape).Mass(), area(shape) * deflection) << what;
    EXPECT_GT(volume(mesh), 0.0) << what;
}

TopoDS_Shape filleted_box() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 10).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next()) {
        fillet.Add(2.0, TopoDS::Edge(edge.Current()));
    }
    return fillet.Shape();
}

std::vector<std::pair<std::string, TopoDS_Shape>> bodies() {
    return {{"box", BRepPrimAPI_MakeBox(30, 20, 5).Shape()},
            {"sphere", BRepPrimAPI_MakeSphere(10).Shape()},
            {"torus", BRepPrimAPI_MakeTorus(10, 3).Shape()},
            {"cone to a tip", BRepPrimAPI_MakeCone(5, 0, 12).Shape()},
            {"cylinder", BRepPrimAPI_MakeCylinder(5, 12).Shape()},
            {"filleted box", filleted_box()}};
}

bool has_openscad() {
    return std::system("command -v openscad >/dev/null 2>&1") == 0;
}

/// What OpenSCAD makes of a mesh, as the volume of the body it exports; it refuses open ones.
double volume_through_openscad(const Folder& folder, const std::string& name) {
    save(folder / "in.scad",
         fmt::format("intersection() {{ import(\"{}\"); cube(1e4, center=true); }}", name));
    const std::string out = (folder / "out.off").string();
    std::filesystem::remove(out);
    const std::string command =
        fmt::format("openscad -o '{}' '{}' >'{}' 2>&1", out, (folder / "in.scad").string(),
                    (folder / "log").string());
    if (std::system(command.c_str()) != 0) {
        return 0.0;
    }
    std::ifstream stream(out);
    std::string head;
    std::size_t points = 0;
    std::size_t triangles = 0;
    std::size_t edges = 0;
    stream >> head >> points >> triangles >> edges;
    Mesh mesh;
    mesh.points.resize(points);
    for (auto& [x, y, z] : mesh.points) {
        stream >> x >> y >> z;
    }
    for (std::size_t i = 0; i < triangles; ++i) {
        std::size_t corners = 0;
        std::uint32_t first = 0;
        std::uint32_t second = 0;
        stream >> corners >> first >> second;
        for (std::size_t k = 2; k < corners; ++k) {
            std::uint32_t third = 0;
            stream >> third;
            mesh.triangles.push_back({first, second, third});
            second = third;
        }
    }
    return volume(mesh);
}

}  // namespace

TEST(Mesh, IsWatertightAndWithinItsDeflection) {
    for (const auto& [name, shape] : bodies()) {
        for (const double deflection : {0.5, 0.05, 0.005}) {
            expect_good_mesh(shape, deflection, name);
        }
    }
}

TEST(Mesh, IsWatertightForBodiesMovedTurnedAndScaled) {
    for (const auto& [name, shape] : bodies()) {
        expect_good_mesh(shape.Moved(moved(1e4, -2e4, 3e4, 0.8)), 0.05, name);
        for (const double scale : {1e-3, 1e3}) {
            gp_Trsf scaling;
            scaling.SetScale(gp_Pnt(1, 2, 3), scale);
            const Mesh mesh = mesh_of(BRepBuilderAPI_Transform(shape, scaling, true).Shape(), 0.0);
            EXPECT_EQ(open_edges(mesh), 0) << name << scale;
        }
    }
}

TEST(Mesh, TurnsASolidThatIsInsideOut) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 5).Shape().Reversed();
    EXPECT_NEAR(volume(mesh_of(box, 0.1)), 3000.0, 1e-9);
}

TEST(Mesh, OfABoxHasTwelveTrianglesOverEightPoints) {
    const Mesh mesh = mesh_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), 0.1);
    EXPECT_EQ(mesh.points.size(), 8U);
    EXPECT_EQ(mesh.triangles.size(), 12U);
}

TEST(Mesh, OfAnAssemblyIsThatOfItsInstances) {
    const ModelFile model = two_level_assembly();
    const Mesh mesh = mesh_of(model.shape(), 0.01);
    EXPECT_EQ(open_edges(mesh), 0);
    EXPECT_NEAR(volume(mesh), volume_of(model.shape()).Mass(), 0.01 * area(model.shape()));
}

TEST(Mesh, LeavesNoTrianglesInTheModel) {
    const Folder folder;
    const ModelFile model = two_level_assembly();
    write(model, folder / "a.stl", Format::Stl);
    for (TopExp_Explorer face(model.shape(), TopAbs_FACE); face.More(); face.Next()) {
        TopLoc_Location location;
        EXPECT_TRUE(BRep_Tool::Triangulation(TopoDS::Face(face.Current()), location).IsNull());
    }
}

TEST(Mesh, OfRealSolidsIsWatertight) {
    SUTURE_NEEDS_CAD_FILES();
    for (const char* name :
         {"0044_bb_boxblend_03_colored.stp", "Handle_SO101.step", "hip_aa_support.STEP"}) {
        const TopoDS_Shape shape = read(cad(name)).shape();
        expect_good_mesh(shape, 0.05, name);
    }
}

namespace {

double least_height(const Mesh& mesh) {
    double least = std::numeric_limits<double>::max();
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto edge = [&](std::uint32_t p, std::uint32_t q) {
            return gp_Vec(mesh.points[q][0] - mesh.points[p][0],
                          mesh.points[q][1] - mesh.points[p][1],
                          mesh.points[q][2] - mesh.points[p][2]);
        };
        const double longest =
            std::max({edge(a, b).Magnitude(), edge(b, c).Magnitude(), edge(c, a).Magnitude()});
        least = std::min(least, edge(a, b).Crossed(edge(a, c)).Magnitude() / longest);
    }
    return least;
}

}  // namespace

TEST(Mesh, ATinyEdgeIsDrawnTogether) {
    // A tetrahedron whose top is two points.
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0, 0, 2 + 1e-12}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 4}, {2, 0, 4}, {1, 4, 3}, {0, 3, 4}};
    const double before = volume(mesh);
    ASSERT_EQ(open_edges(mesh), 0);
    EXPECT_EQ(remove_needles(mesh, 1e-6), 2);
    EXPECT_EQ(open_edges(mesh), 0);
    EXPECT_EQ(mesh.triangles.size(), 4U);
    EXPECT_EQ(mesh.points.size(), 4U);
    EXPECT_NEAR(volume(mesh), before, 1e-9);
}

TEST(Mesh, ACornerOnTheOppositeEdgeIsTakenOutByTurningTheDiagonal) {
    // A tetrahedron; a point stands on the middle of an edge for one of the two faces only, and a
    // triangle without height closes the mesh.
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 1e-13}};
    mesh.triangles = {{0, 4, 3}, {4, 1, 3}, {0, 1, 4}, {0, 2, 1}, {1, 2, 3}, {0, 3, 2}};
    const double before = volume(mesh);
    ASSERT_EQ(open_edges(mesh), 0);
    EXPECT_EQ(remove_needles(mesh, 1e-6), 1);
    EXPECT_EQ(open_edges(mesh), 0);
    EXPECT_EQ(mesh.triangles.size(), 6U);
    EXPECT_GT(least_height(mesh), 0.1);
    EXPECT_NEAR(volume(mesh), before, 1e-12);
}

TEST(Mesh, TrianglesOfTwoFacesThatLieBackToBackAreTakenOut) {
    // A tetrahedron, and on one of its edges two triangles of faces that meet in a sharp corner.
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, -1, -1}};
    mesh.triangles = {{0, 1, 3}, {4, 1, 0}, {0, 2, 1}, {1, 2, 3}, {0, 3, 2}, {1, 4, 0}};
    mesh.faces = {1, 2, 3, 4, 5, 6};
    const double before = volume(mesh);
    Mesh wall = mesh;
    wall.faces[5] = 2;  // one face between two bodies stays
    EXPECT_EQ(remove_back_to_back(wall), 0);
    EXPECT_EQ(remove_back_to_back(mesh), 2);
    EXPECT_EQ(open_edges(mesh), 0);
    EXPECT_EQ(mesh.triangles.size(), 4U);
    EXPECT_EQ(mesh.points.size(), 4U);
    EXPECT_EQ(mesh.faces, (std::vector<std::uint32_t>{1, 3, 4, 5}));
    EXPECT_NEAR(volume(mesh), before, 1e-12);
}

TEST(Mesh, OfAnOpenShellSaysHowManyEdgesAreOpen) {
    TopoDS_Shell shell;
    BRep_Builder builder;
    builder.MakeShell(shell);
    TopExp_Explorer face(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), TopAbs_FACE);
    for (face.Next(); face.More(); face.Next()) {
        builder.Add(shell, face.Current());
    }
    EXPECT_EQ(mesh_of(shell, 0.1).facts.open_edges, 4U);
    EXPECT_EQ(mesh_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), 0.1).facts.open_edges, 0U);
}

TEST(MeshFiles, OpenScadTakesThemAsTheSameBody) {
    if (!has_openscad()) {
        GTEST_SKIP() << "openscad is not installed";
    }
    const Folder folder;
    const TopoDS_Shape shape = filleted_box();
    const double expected = volume(mesh_of(shape, 0.1));
    for (const auto& [name, format] :
         {std::pair{"a.stl", Format::Stl}, std::pair{"a.off", Format::Off},
          std::pair{"a.3mf", Format::ThreeMf}}) {
        const auto done = write_model(model_of(shape, "box"), folder / name, format, {0.1, 0.35});
        ASSERT_TRUE(done) << done.error().message;
        EXPECT_NEAR(volume_through_openscad(folder, name), expected, 1e-4 * expected)
            << name << content(folder / "log");
    }
}

TEST(MeshFiles, ObjHoldsTheMeshWithNumbersFromOne) {
    const Folder folder;
    write(model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box"), folder / "a.obj", Format::Obj);
    std::ifstream stream(folder / "a.obj");
    Mesh mesh;
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        char kind = 0;
        words >> kind;
        if (kind == 'v') {
            auto& [x, y, z] = mesh.points.emplace_back();
            words >> x >> y >> z;
        } else if (kind == 'f') {
            auto& triangle = mesh.triangles.emplace_back();
            for (std::uint32_t& corner : triangle) {
                words >> corner;
                --corner;
            }
        }
    }
    EXPECT_EQ(open_edges(mesh), 0);
    EXPECT_NEAR(volume(mesh), 3000.0, 1e-9);
}

}  // namespace suture::io::test

#include "step_io/files/assembly.h"
#include "step_io/files/describe.h"

#include <cstdlib>

namespace suture::io::test {

namespace {

constexpr const char* kPython = "/usr/bin/python3";

/// Runs lines of Python with FreeCAD's Part module; false if they raise.
bool freecad(const Folder& folder, const std::string& lines) {
    save(folder / "script.py",
         fmt::format("import sys\nsys.path.insert(0, '/usr/lib/freecad-python3/lib')\n"
                     "import FreeCAD, Part\n{}",
                     lines));
    return std::system(
               fmt::format("{} '{}' >/dev/null 2>&1", kPython, (folder / "script.py").string())
                   .c_str()) == 0;
}

/// Length of each edge and area of each face, in FreeCAD's order.
const std::string kMeasure =
    "def measure(shape, file):\n"
    "    with open(file, 'w') as out:\n"
    "        for e in shape.Edges:\n"
    "            out.write('%.9g\\n' % e.Length)\n"
    "        for f in shape.Faces:\n"
    "            out.write('%.9g\\n' % f.Area)\n";

std::vector<double> numbers_in(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istream_iterator<double>(stream), {}};
}

std::vector<double> measure(const TopoDS_Shape& shape) {
    std::vector<double> result;
    for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_FACE}) {
        TopTools_IndexedMapOfShape shapes;
        TopExp::MapShapes(shape, kind, shapes);
        for (int i = 1; i <= shapes.Extent(); ++i) {
            GProp_GProps properties;
            kind == TopAbs_EDGE ? BRepGProp::LinearProperties(shapes(i), properties)
                                : BRepGProp::SurfaceProperties(shapes(i), properties);
            result.push_back(properties.Mass());
        }
    }
    return result;
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i], b[i], 1e-6 * (1.0 + b[i])) << i;
    }
}

}  // namespace

TEST(FreeCad, BinaryIsReadWithItsEdgeAndFaceNumbers) {
    const Folder folder;
    if (!freecad(folder, "")) {
        GTEST_SKIP() << "FreeCAD's Python modules are not installed";
    }
    ASSERT_TRUE(freecad(
        folder,
        kMeasure + fmt::format("s = Part.makeBox(30, 20, 5)\n"
                               "s = s.makeFillet(2, s.Edges[:5])\n"
                               "s = s.cut(Part.makeCylinder(3, 9))\n"
                               "s.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), "
                               "FreeCAD.Rotation(10, 20, 30))\n"
                               "s.exportBinary('{0}')\nmeasure(s, '{1}')\n",
                               (folder / "in.bin").string(), (folder / "numbers").string())));
    const ModelFile model = read(folder / "in.bin");
    EXPECT_EQ(model.format, Format::BrepFreecad);
    expect_same(measure(model.shape()), numbers_in(folder / "numbers"));
}

TEST(FreeCad, ReadsOurBinaryWithOurEdgeAndFaceNumbers) {
    const Folder folder;
    if (!freecad(folder, "")) {
        GTEST_SKIP() << "FreeCAD's Python modules are not installed";
    }
    const TopoDS_Shape shape = two_level_assembly().shape().Moved(moved(1, 2, 3, 0.5)).Reversed();
    write(model_of(shape, "all"), folder / "out.bin", Format::BrepFreecad);
    ASSERT_TRUE(freecad(folder, kMeasure + fmt::format("s = Part.Shape()\ns.importBinary('{0}')\n"
                                                       "assert s.Orientation == 'Reversed'\n"
                                                       "measure(s, '{1}')\n",
                                                       (folder / "out.bin").string(),
                                                       (folder / "numbers").string())));
    expect_same(measure(shape), numbers_in(folder / "numbers"));
}

}  // namespace suture::io::test

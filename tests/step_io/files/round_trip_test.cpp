#include "support/properties.h"
#include "suture/occ/topology.h"

#include "step_io/files/assembly.h"
#include "step_io/files/describe.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>

namespace suture::io::test {

namespace {

using suture::test::volume;

class RoundTripOfSchema : public ::testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(RoundTripOfSchema, KeepsTreeNamesColoursAndLayers) {
    const Folder folder;
    ModelFile model = two_level_assembly();
    model.schema = GetParam();
    write(model, folder / "a.step", Format::Step);
    const ModelFile first = read(folder / "a.step");
    EXPECT_EQ(first.schema, GetParam());
    EXPECT_EQ(describe(first), describe(model));
    write(first, folder / "b.step", Format::Step);
    EXPECT_EQ(describe(read(folder / "b.step")), describe(model));
}

INSTANTIATE_TEST_SUITE_P(Step, RoundTripOfSchema, ::testing::Values("AP203", "AP214", "AP242"));

TEST(RoundTrip, KeepsTheColourOfOneInstance) {
    const Folder folder;
    const ModelFile model = two_level_assembly();
    TDF_Label left;
    for (const TDF_Label& root : roots_of(model.document)) {
        for (const TDF_Label& component : components_of(root)) {
            for (const TDF_Label& inner : components_of(referred(component))) {
                left = name_of(inner) == "left bolt" ? inner : left;
            }
        }
    }
    ASSERT_FALSE(left.IsNull());
    const std::string plain = describe(model);
    colours_of(model.document)
        ->SetColor(left, Quantity_Color(1, 0, 1, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    ASSERT_NE(describe(model), plain);
    write(model, folder / "a.step", Format::Step);
    EXPECT_EQ(describe(read(folder / "a.step")), describe(model));
}

TEST(RoundTrip, CountsInstancesOverTheWholeTree) {
    const std::vector<Part> parts = two_level_assembly().parts();
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].name, "Träger 板");
    EXPECT_EQ(parts[0].instances, 1);
    EXPECT_EQ(parts[1].name, "bolt M4 'short'");
    EXPECT_EQ(parts[1].instances, 3);
}

TEST(RoundTrip, KeepsUnitSizeAndAccuracyOfEachStepUnit) {
    const Folder folder;
    for (const char* unit : {"MM", "CM", "M", "KM", "UM", "INCH", "FT", "MI", "MIL", "UIN"}) {
        ModelFile model = model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box");
        model.unit = unit;
        model.precision = 2e-4;
        for (const Format format : {Format::Step, Format::Iges}) {
            write(model, folder / "box", format);
            const ModelFile again = read(folder / "box");
            EXPECT_EQ(again.unit, unit) << to_string(format);
            EXPECT_NEAR(volume(again.shape()), 3000.0, 1e-4) << unit << to_string(format);
            EXPECT_NEAR(again.precision, 2e-4, 1e-9) << unit << to_string(format);
        }
    }
}

TEST(RoundTrip, KeepsSolidsOfIgesSewn) {
    const Folder folder;
    write(model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box"), folder / "box.igs",
          Format::Iges);
    const TopoDS_Shape shape = read(folder / "box.igs").shape();
    EXPECT_TRUE(TopExp_Explorer(shape, TopAbs_SOLID).More());
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
}

TEST(RoundTrip, KeepsBrepInOrderInAllThreeKinds) {
    const Folder folder;
    TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(2, 15).Shape().Moved(moved(1, 2, 3, 0.4));
    shape.Reverse();
    for (const Format format : {Format::BrepText, Format::BrepBinary, Format::BrepFreecad}) {
        write(model_of(shape, "pin"), folder / "pin", format);
        const ModelFile again = read(folder / "pin");
        EXPECT_EQ(again.format, format);
        EXPECT_EQ(again.shape().Orientation(), TopAbs_REVERSED) << to_string(format);
        TopTools_IndexedMapOfShape before;
        TopTools_IndexedMapOfShape after;
        TopExp::MapShapes(shape, before);
        TopExp::MapShapes(again.shape(), after);
        ASSERT_EQ(before.Extent(), after.Extent());
        for (int i = 1; i <= before.Extent(); ++i) {
            EXPECT_EQ(place(before(i)), place(after(i))) << to_string(format) << " " << i;
        }
    }
}

TEST(RoundTrip, WorksMirroringAndScalingPlacementsOfBrepIn) {
    const Folder folder;
    const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(2, 15).Shape();
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(10, 0, 0), gp_Dir(1, 0, 0)));
    gp_Trsf twice;
    twice.SetScale(gp_Pnt(0, -10, 0), 2.0);
    for (const auto& [placement, scale] : {std::pair(mirror, 1.0), std::pair(twice, 8.0)}) {
        const TopoDS_Shape placed = pin.Located(TopLoc_Location(placement), false);
        TopoDS_Compound both;
        BRep_Builder().MakeCompound(both);
        BRep_Builder().Add(both, pin);
        BRep_Builder().Add(both, placed);
        for (const TopoDS_Shape& shape : {placed, TopoDS_Shape(both)}) {
            BRepTools::Write(shape, (folder / "pin.brep").c_str());
            const ModelFile model = read(folder / "pin.brep");
            double expected = 0.0;
            double found = 0.0;
            for (TopExp_Explorer it(model.shape(), TopAbs_SOLID); it.More(); it.Next()) {
                expected += 60.0 * M_PI * (expected == 0.0 && shape.IsSame(both) ? 1.0 : scale);
                EXPECT_GT(volume(it.Current()), 0.0);
                found += volume(it.Current());
            }
            EXPECT_NEAR(found, expected, 1e-9 * expected);
            EXPECT_TRUE(BRepCheck_Analyzer(model.shape()).IsValid());
            write(model, folder / "pin.step", Format::Step);
            EXPECT_NEAR(volume(read(folder / "pin.step").shape()), expected, 1e-9 * expected);
        }
    }
}

// What a reader leaves of a body none of whose faces it knows.
TEST(RoundTrip, WritesModelsWithEmptyShells) {
    const Folder folder;
    TopoDS_Shell empty;
    TopoDS_Solid solid;
    TopoDS_Compound both;
    BRep_Builder().MakeShell(empty);
    BRep_Builder().MakeSolid(solid);
    BRep_Builder().Add(solid, empty);
    BRep_Builder().MakeCompound(both);
    BRep_Builder().Add(both, solid);
    BRep_Builder().Add(both, BRepPrimAPI_MakeBox(30, 20, 5).Shape());
    BRepTools::Write(both, (folder / "both.brep").c_str());
    const ModelFile model = read(folder / "both.brep");
    EXPECT_EQ(occ::faces_of(model.shape()).size(), 6U);
    for (const auto& [name, format] :
         {std::pair("both.igs", Format::Iges), std::pair("both.step", Format::Step)}) {
        write(model, folder / name, format);
        EXPECT_NEAR(volume(read(folder / name).shape()), 3000.0, 1e-6) << name;
    }
}

TEST(RoundTrip, SaysWhoWroteTheFileAndKeepsItsAuthor) {
    const Folder folder;
    ModelFile model = model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box");
    model.origin = {{"a gear box"}, {"Ada"}, {"Works"}, "chief"};
    write(model, folder / "box.step", Format::Step);
    const std::string text = content(folder / "box.step");
    EXPECT_NE(text.find("'Suture "), text.npos);
    EXPECT_EQ(text.find("translator"), text.npos);
    const Origin origin = read(folder / "box.step").origin;
    EXPECT_EQ(origin.description, model.origin.description);
    EXPECT_EQ(origin.authors, model.origin.authors);
    EXPECT_EQ(origin.organizations, model.origin.organizations);
    EXPECT_EQ(origin.authorisation, model.origin.authorisation);
}

TEST(RoundTrip, KeepsNamesInAnyScriptInAsciiFiles) {
    const Folder folder;
    std::string long_name;
    for (int i = 0; i < 60; ++i) {
        long_name += "ä板'b\\";
    }
    for (const std::string& name : {std::string("Träger 板"), std::string("C:\\X2\\parts\\a"),
                                    std::string("it's 100% \\"), long_name}) {
        ModelFile model = model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), name);
        model.origin.authors = {"Jürgen"};
        write(model, folder / "named.step", Format::Step);
        const std::string text = content(folder / "named.step");
        EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c >= 0; })) << name;
        const ModelFile again = read(folder / "named.step");
        EXPECT_EQ(again.parts().front().name, name);
        EXPECT_EQ(again.origin.authors, model.origin.authors);
    }
}

TEST(RoundTrip, NamesAPartWithoutNameAfterTheFile) {
    const Folder folder;
    write(model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), ""), folder / "crate.brep",
          Format::BrepText);
    EXPECT_EQ(read(folder / "crate.brep").parts().front().name, "crate");
}

TEST(RoundTrip, KeepsWhatRealFilesSay) {
    SUTURE_NEEDS_CAD_FILES();
    const Folder folder;
    for (const char* name :
         {"0044_bb_boxblend_03_colored.stp", "0045_bb_boxblend_03_colored_mirrored.stp",
          "frame.step", "goteborg.step", "nist_ctc_04_asme1_rd.stp", "nist_ftc_08_asme1_rc.stp",
          "Handle_SO101.step", "wavy-cube.stp", "hammer.iges", "D150WithGuides_wing.igs"}) {
        const ModelFile model = read(cad(name));
        write(model, folder / name, model.format);
        const ModelFile again = read(folder / name);
        EXPECT_EQ(describe(again), describe(model)) << name;
        EXPECT_EQ(again.unit, model.unit) << name;
        EXPECT_EQ(again.schema, model.schema) << name;
        EXPECT_NEAR(again.precision, model.precision, 1e-5 * model.precision) << name;
    }
}

namespace {

std::vector<double> areas_of(const TopoDS_Shape& shape) {
    std::vector<double> areas;
    for (const TopoDS_Face& face : occ::faces_of(shape)) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face, properties);
        areas.push_back(properties.Mass());
    }
    return areas;
}

/// The changes of the faces' areas by writing and reading, relative.
std::vector<double> changes_by_round_trip(const ModelFile& model,
                                          const std::filesystem::path& file) {
    write(model, file, Format::Step);
    const auto before = areas_of(model.shape());
    const auto after = areas_of(read(file).shape());
    EXPECT_EQ(before.size(), after.size());
    std::vector<double> changes;
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
        changes.push_back(std::abs(after[i] - before[i]) / before[i]);
    }
    return changes;
}

}  // namespace

/// A known limit (docs/cli.md, "Output"). The file states an accuracy of 1e-3 mm, and one of its
/// edges lies 1.2e-3 mm off a face. OCCT's reader takes a curve on the surface that is off by more
/// than the file states for wrong and makes it anew, each time that it reads the file.
TEST(RoundTrip, MovesTheBorderOfOneFaceThatIsWorseThanItsFileStates) {
    SUTURE_NEEDS_CAD_FILES();
    const Folder folder;
    const ModelFile model = read(cad("../reopened/R02_bspl3_basemount.open.step"));
    const auto changes = changes_by_round_trip(model, folder / "once.step");
    EXPECT_EQ(std::ranges::count_if(changes, [](double change) { return change > 1e-7; }), 1);
    EXPECT_LT(std::ranges::max(changes), 2e-5);
    // What is written then stays.
    const ModelFile again = read(folder / "once.step");
    EXPECT_LT(std::ranges::max(changes_by_round_trip(again, folder / "twice.step")), 1e-10);
    // The same model, whose file states 1e-2 mm.
    const ModelFile original = read(cad("4040_base_mount.step"));
    EXPECT_LT(std::ranges::max(changes_by_round_trip(original, folder / "original.step")), 1e-10);
}

}  // namespace suture::io::test

#include "files/losses.h"

#include "step_io/files/assembly.h"

namespace suture::io::test {

TEST(LostIn, IgesIsTheTreeAndItsNames) {
    const auto lost = lost_in(two_level_assembly(), Format::Iges);
    ASSERT_EQ(lost.size(), 1U);
    EXPECT_EQ(lost.front(),
              "IGES has no assembly tree: all parts become one model, and 9 names of assemblies, "
              "parts and instances are lost");
}

TEST(LostIn, BrepIsTheLookAsWell) {
    const auto lost = lost_in(two_level_assembly(), Format::BrepText);
    ASSERT_EQ(lost.size(), 2U);
    EXPECT_EQ(lost.back(), "BREP has no colours and layers: they are lost");
}

TEST(LostIn, StepAndMeshesIsNothing) {
    for (const Format format : {Format::Step, Format::Stl, Format::ThreeMf}) {
        EXPECT_TRUE(lost_in(two_level_assembly(), format).empty());
    }
}

TEST(LostIn, IgesIsNothingOfAPlainPart) {
    const ModelFile box = model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box");
    EXPECT_TRUE(lost_in(box, Format::Iges).empty());
    EXPECT_TRUE(lost_in(box, Format::BrepBinary).empty());
}

/// What is said is true: the tree does not come back.
TEST(LostIn, IgesDoesNotComeBack) {
    const Folder folder;
    write(two_level_assembly(), folder / "machine.iges", Format::Iges);
    const ModelFile again = read(folder / "machine.iges");
    EXPECT_FALSE(lost_in(two_level_assembly(), Format::Iges).empty());
    for (const TDF_Label& root : roots_of(again.document)) {
        EXPECT_FALSE(XCAFDoc_ShapeTool::IsAssembly(root));
    }
}

}  // namespace suture::io::test

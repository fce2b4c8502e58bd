#include "step_io/files/assembly.h"

namespace suture::io::test {

TEST(Format, IsToldByContentWhateverTheName) {
    const Folder folder;
    const ModelFile model = two_level_assembly();
    for (const Format format :
         {Format::Step, Format::Iges, Format::BrepText, Format::BrepBinary, Format::BrepFreecad}) {
        write(model, folder / "file.stl", format);
        EXPECT_EQ(format_of_content(folder / "file.stl"), format) << to_string(format);
    }
    std::string text = "\xEF\xBB\xBF\r\n/* made by hand */\nISO-10303-21;\nHEADER;\n";
    save(folder / "text", text);
    EXPECT_EQ(format_of_content(folder / "text"), Format::Step);
}

TEST(Format, OfAnOutputIsToldByItsExtension) {
    EXPECT_EQ(format_of_extension("a.b/c.STEP"), Format::Step);
    EXPECT_EQ(format_of_extension("c.stp"), Format::Step);
    EXPECT_EQ(format_of_extension("c.Igs"), Format::Iges);
    EXPECT_EQ(format_of_extension("c.brep"), Format::BrepText);
    EXPECT_EQ(format_of_extension("c.bin"), Format::BrepFreecad);
    EXPECT_EQ(format_of_extension("c.3mf"), Format::ThreeMf);
    EXPECT_EQ(format_of_extension("c.GLB"), Format::Gltf);
    const Result<Format> unknown = format_of_extension("step");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::Usage);
    EXPECT_NE(unknown.error().message.find(".step, .stp"), std::string::npos);
}

}  // namespace suture::io::test

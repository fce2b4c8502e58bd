#include "step_io/files/assembly.h"
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <regex>

namespace suture::io::test {

namespace {

/// The one sentence with which a file is refused.
std::string refusal(const std::filesystem::path& file) {
    const Result<ModelFile> model = read_model(file, {});
    if (model) {
        return "was read";
    }
    EXPECT_EQ(model.error().code, ErrorCode::Unreadable) << model.error().message;
    EXPECT_EQ(model.error().message.find('\n'), std::string::npos) << model.error().message;
    EXPECT_EQ(model.error().message.rfind(file.string(), 0), 0U) << model.error().message;
    return model.error().message.substr(
        std::min(model.error().message.size(), file.string().size() + 1));
}

std::string box_step(const Folder& folder) {
    write(two_level_assembly(), folder / "whole.step", Format::Step);
    return content(folder / "whole.step");
}

}  // namespace

TEST(BadFiles, AreRefusedWithOneSentenceEach) {
    const Folder folder;
    EXPECT_EQ(refusal(folder / "missing.step"), "does not exist");
    EXPECT_EQ(refusal(folder / ""), "is a folder, not a file");
    save(folder / "empty.step", "");
    EXPECT_EQ(refusal(folder / "empty.step"), "is empty");
    save(folder / "text.step", "Dear reader,\nthis is no CAD file.\n");
    EXPECT_EQ(refusal(folder / "text.step"),
              "is of no known type: neither STEP, IGES, BREP nor FCStd");
    ::mkfifo((folder / "pipe.step").c_str(), 0600);
    EXPECT_EQ(refusal(folder / "pipe.step"), "is no ordinary file");
    save(folder / "bare.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nEND-ISO-10303-21;\n");
    EXPECT_EQ(refusal(folder / "bare.step"),
              "is damaged: it has no DATA section that ends in "
              "ENDSEC");
}

TEST(BadFiles, StepCutAnywhereIsRefused) {
    const Folder folder;
    const std::string whole = box_step(folder);
    constexpr std::size_t kCuts = 20;
    for (std::size_t i = 1; i <= kCuts; ++i) {
        save(folder / "cut.step", whole.substr(0, whole.size() * i / (kCuts + 1)));
        EXPECT_EQ(refusal(folder / "cut.step").rfind("is cut off: it ends", 0), 0U) << i;
    }
}

TEST(BadFiles, StepCutBetweenTwoEntitiesIsRefused) {
    const Folder folder;
    const std::string whole = box_step(folder);
    std::size_t at = whole.find("DATA;");
    for (int i = 0; i < 100; ++i) {  // the 100th entity begins
        at = whole.find(";\n#", at + 1);
    }
    save(folder / "cut.step", whole.substr(0, at + 2));
    EXPECT_EQ(refusal(folder / "cut.step"),
              "is cut off: it ends at entity #99, without its last line END-ISO-10303-21");
    save(folder / "closed.step", whole.substr(0, at + 2) + "ENDSEC;\nEND-ISO-10303-21;\n");
    EXPECT_TRUE(std::regex_match(
        refusal(folder / "closed.step"),
        std::regex("is damaged: entity #\\d+ refers to #\\d+, which the file does not hold")));
}

TEST(BadFiles, StepWithUnresolvedReferenceIsRefusedByNumber) {
    const Folder folder;
    std::string text = box_step(folder);
    std::smatch match;
    ASSERT_TRUE(std::regex_search(text, match, std::regex("#(\\d+) = ADVANCED_FACE\\('',\\(#")));
    const std::string face = match[1];
    text.insert(static_cast<std::size_t>(match.position() + match.length()), "99999");
    save(folder / "wrong.step", text);
    EXPECT_EQ(refusal(folder / "wrong.step")
                  .rfind("is damaged: entity #" + face + " refers to #99999", 0),
              0U)
        << refusal(folder / "wrong.step");
}

TEST(BadFiles, NumbersInStringsAndCommentsAreNoReferences) {
    const Folder folder;
    std::string text = box_step(folder);
    const std::size_t data = text.find("DATA;") + 5;
    text.insert(data, "\n/* see #987654, it''s ; END-ISO-10303-21; */");
    const std::size_t frame = text.find("'frame'");
    text.replace(frame, 7, "'#876543; it''s'");
    save(folder / "fine.step", text);
    EXPECT_EQ(refusal(folder / "fine.step"), "was read");
}

TEST(BadFiles, StepWithoutAnyShapeIsRefused) {
    const Folder folder;
    const std::string text = box_step(folder);
    save(folder / "none.step", text.substr(0, text.find("DATA;")) +
                                   "DATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\n"
                                   "END-ISO-10303-21;\n");
    EXPECT_EQ(refusal(folder / "none.step"), "holds no shape that OCCT can read");
}

TEST(BadFiles, IgesCutAnywhereIsRefused) {
    const Folder folder;
    write(model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box"), folder / "whole.igs",
          Format::Iges);
    const std::string whole = content(folder / "whole.igs");
    constexpr std::size_t kCuts = 20;
    for (std::size_t i = 1; i <= kCuts; ++i) {
        save(folder / "cut.igs", whole.substr(0, whole.size() * i / (kCuts + 1)));
        EXPECT_EQ(refusal(folder / "cut.igs").rfind("is cut off", 0), 0U) << i;
    }
    std::string missing_line = whole;
    missing_line.erase(whole.size() / 2 / 81 * 81, 81);
    save(folder / "cut.igs", missing_line);
    EXPECT_EQ(refusal(folder / "cut.igs").rfind("is damaged: section", 0), 0U)
        << refusal(folder / "cut.igs");
}

TEST(BadFiles, IgesWithIntegersForRealsIsReadOrRefused) {
    const Folder folder;
    write(model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box"), folder / "box.igs",
          Format::Iges);
    std::string text = content(folder / "box.igs");
    // 30. becomes 30: same width, one blank more
    for (std::size_t at = 0; (at = text.find("30.,", at)) != text.npos; ++at) {
        text.replace(at, 4, " 30,");
    }
    save(folder / "integers.igs", text);
    const std::string answer = refusal(folder / "integers.igs");
    EXPECT_TRUE(answer == "was read" || answer.rfind("holds no", 0) == 0) << answer;
}

TEST(BadFiles, BrepCutAnywhereIsRefused) {
    const Folder folder;
    for (const Format format : {Format::BrepText, Format::BrepBinary, Format::BrepFreecad}) {
        write(model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box"), folder / "whole", format);
        const std::string whole = content(folder / "whole");
        constexpr std::size_t kCuts = 20;
        for (std::size_t i = 1; i <= kCuts; ++i) {
            save(folder / "cut", whole.substr(0, whole.size() * i / (kCuts + 1)));
            EXPECT_EQ(refusal(folder / "cut").rfind("is cut off", 0), 0U)
                << to_string(format) << " " << i << " " << refusal(folder / "cut");
        }
    }
}

TEST(BadFiles, TextThatIsNotWhatBrepNeedsIsToldWithItsLineAtOnce) {
    const Folder folder;
    write(model_of(BRepPrimAPI_MakeBox(30, 20, 5).Shape(), "box"), folder / "box.brep",
          Format::BrepText);
    const std::string whole = content(folder / "box.brep");
    // A list of what an edge consists of: OCCT's reader never leaves one in which the stream fails.
    const std::size_t list = whole.find("\n1  ");
    ASSERT_NE(list, whole.npos);
    const auto line = 2 + std::count(whole.data(), whole.data() + list, '\n');
    for (const std::string wrong : {"nan", "-", "x", "99999999999999999999"}) {
        save(folder / "wrong.brep",
             whole.substr(0, list + 4) + wrong + " " + whole.substr(list + 4));
        EXPECT_EQ(
            refusal(folder / "wrong.brep"),
            fmt::format("is damaged: what stands in line {} is not what should be there", line))
            << wrong;
    }
}

TEST(BadFiles, AShapeWithoutFaceIsRefused) {
    const Folder folder;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 5).Shape();
    const ModelFile wire = model_of(TopExp_Explorer(box, TopAbs_WIRE).Current(), "wire");
    const auto any = [](const std::filesystem::path&, const std::vector<StepId>&) {
        return Result<void>();
    };
    ASSERT_TRUE(write_model(wire, folder / "wire.brep", Format::BrepText, {}, {}, any));
    const auto refused = write_model(wire, folder / "refused.brep", Format::BrepText, {});
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message,
                testing::HasSubstr("is not written: the new file holds no face"));
    EXPECT_FALSE(std::filesystem::exists(folder / "refused.brep"));
    EXPECT_EQ(refusal(folder / "wire.brep"), "holds no face");
}

TEST(BadFiles, AStoppedReadSaysSo) {
    const Folder folder;
    box_step(folder);
    std::stop_source source;
    source.request_stop();
    const Result<ModelFile> model =
        read_model(folder / "whole.step", Progress{{}, source.get_token()});
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().code, ErrorCode::Cancelled);
}

}  // namespace suture::io::test

#include "files/step_faces.h"

#include "suture/occ/topology.h"

#include "step_io/files/assembly.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS.hxx>

namespace suture::io::test {

namespace {

double area(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    return properties.Mass();
}

/// A plate and a bolt in an assembly; traced are two neighbours of the plate and one of the bolt.
struct Written {
    explicit Written(const Folder& folder) : file(folder / "machine.step") {
        const std::vector<Part> parts = model.parts();
        for (const auto& [part, number] : {std::pair(0, 1), {0, 3}, {1, 1}}) {
            faces.push_back(
                TopoDS::Face(face_of(parts[static_cast<std::size_t>(part)].shape, number)));
        }
        const auto numbers = write_model(model, file, Format::Step, {}, faces);
        EXPECT_TRUE(numbers) << numbers.error().message;
        groups = {{numbers->at(0), numbers->at(1)}, {numbers->at(2)}};
    }
    ModelFile model = two_level_assembly();
    std::filesystem::path file;
    std::vector<TopoDS_Face> faces;
    std::vector<std::vector<StepId>> groups;
};

constexpr std::size_t kAllFaces = 6 + 3;  // of the plate and of the bolt

}  // namespace

TEST(StepFaces, ComeBackInThePartsOwnCoordinatesWithTheirSharedEdge) {
    const Folder folder;
    Written written(folder);
    written.model.unit = "INCH";  // lengths are millimetres all the same
    const auto again = write_model(written.model, written.file, Format::Step, {}, written.faces);
    ASSERT_TRUE(again);
    const auto shapes =
        read_step_faces(written.file, {{again->at(0), again->at(1)}, {again->at(2)}}, kAllFaces);
    ASSERT_TRUE(shapes) << shapes.error().message;
    ASSERT_EQ(shapes->size(), 2U);
    EXPECT_EQ(occ::faces_of(shapes->at(0)).size(), 2U);
    EXPECT_EQ(occ::edges_of(shapes->at(0)).size(), 7U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(area(occ::faces_of(shapes->at(0))[i]), area(written.faces[i]), 1e-9);
    }
    EXPECT_EQ(occ::faces_of(shapes->at(1)).size(), 1U);
    EXPECT_NEAR(area(shapes->at(1)), area(written.faces[2]), 1e-9);
    EXPECT_NEAR(occ::diagonal(shapes->at(1)), occ::diagonal(written.faces[2]), 1e-9);
}

TEST(StepFaces, TextHoldsTheFilesOwnStatementsAndNoOtherFace) {
    const Folder folder;
    const Written written(folder);
    const std::string whole = content(written.file);
    const auto part = extract_step_faces(whole, written.groups, kAllFaces);
    ASSERT_TRUE(part) << part.error().message;
    std::size_t faces = 0;
    for (std::size_t at = part->find("ADVANCED_FACE"); at != part->npos;
         at = part->find("ADVANCED_FACE", at + 1)) {
        ++faces;
        const std::size_t begin = part->rfind('#', at);
        EXPECT_NE(whole.find(part->substr(begin, part->find(';', at) - begin)), whole.npos);
    }
    EXPECT_EQ(faces, 3U);
    EXPECT_EQ(part->find("PRODUCT"), part->npos);
}

TEST(StepFaces, RefuseAFileWithMoreOrFewerFacesAndAnEntityThatIsNone) {
    const Folder folder;
    const Written written(folder);
    const auto more = read_step_faces(written.file, written.groups, kAllFaces + 1);
    ASSERT_FALSE(more);
    EXPECT_NE(more.error().message.find("9 faces, the model 10"), std::string::npos)
        << more.error().message;
    const auto none = read_step_faces(written.file, {{1}}, kAllFaces);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("#1 is no face"), std::string::npos);
}

TEST(StepFaces, FaceThatIsNotInTheModelHasNoEntity) {
    const Folder folder;
    const Written written(folder);
    const std::vector<TopoDS_Face> stranger{
        TopoDS::Face(face_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), 1))};
    const auto numbers = write_model(written.model, written.file, Format::Step, {}, stranger);
    ASSERT_TRUE(numbers);
    EXPECT_EQ(*numbers, std::vector<StepId>{0});
}

}  // namespace suture::io::test

#pragma once

#include "cli/remeasure.h"
#include "files/model_file.h"
#include "files/step_scan.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <vector>

namespace suture::cli {

/// What is read again of an output: of every part with new faces these, and all that they meet.
class RereadFaces {
  public:
    explicit RereadFaces(const std::vector<FilledPart>& parts);

    /// The faces as they are in their parts, in the order in which `read` takes their numbers.
    [[nodiscard]] const std::vector<TopoDS_Face>& faces() const { return faces_; }

    /// Reads the faces from a STEP file, each part where it first stands in the model.
    ///
    /// Input    entities of the faces, as write_model has returned them.
    /// Refuses  if an entity is not known, or if the file has not as many faces as the model: then
    ///          the whole file must be read to know what is in it.
    [[nodiscard]] Result<TopoDS_Shape> read(const std::filesystem::path& file,
                                            const std::vector<io::StepId>& entities,
                                            const io::ModelFile& model) const;

  private:
    struct Group {
        std::size_t size;
        TopLoc_Location placement;
    };
    std::vector<TopoDS_Face> faces_;
    std::vector<Group> groups_;
};

}  // namespace suture::cli

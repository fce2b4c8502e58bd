#pragma once

#include "files/format.h"
#include "suture/occ/handle.h"

#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace suture::io {

/// One part of a model: a shape that stands in the assembly tree, perhaps several times.
struct Part {
    TDF_Label label;  ///< in the document
    std::string name;
    TopoDS_Shape shape;  ///< in the part's own coordinates
    int instances = 1;   ///< how often it stands in the whole model
};

/// Who made a file, as its header says; kept for writing.
struct Origin {
    std::vector<std::string> description;
    std::vector<std::string> authors;
    std::vector<std::string> organizations;
    std::string authorisation;
};

/// A model with all that a file says of it: shapes, assembly tree, names, colours, layers. Lengths
/// are millimetres, whatever the file's own unit is; the unit is kept for writing.
struct ModelFile {
    occ::Handle<TDocStd_Document> document;
    Format format = Format::Step;
    std::filesystem::path path;
    std::string schema;       ///< STEP: "AP203", "AP214", "AP242"; else empty
    std::string unit = "MM";  ///< of the file, as OCCT names it: MM, M, INCH, ...
    double precision = 0.0;   ///< the file's own accuracy in millimetres, 0 if it states none
    Origin origin;
    std::vector<std::string> notes;          ///< what reading had to leave out, a sentence each
    std::vector<std::string> missing_files;  ///< STEP: files of parts that are not read
    TDF_Label united;                        ///< the part that unite has made, if it has

    /// Every part that has a face, and the one that unite has made, each once, in the order of the
    /// assembly tree.
    [[nodiscard]] std::vector<Part> parts() const;

    /// The whole model as one shape: the free shapes, in a compound if there are several. EdgeN and
    /// FaceN in messages and reports are its TopExp::MapShapes numbers.
    [[nodiscard]] TopoDS_Shape shape() const;

    /// Puts another shape in the place of a part's. Names, colours and layers of its faces stay
    /// with the faces, also where `replaced` says that a face became another one; those of shells
    /// and solids that are not named there stay with the shell or solid of the same number, if
    /// there are as many as before. Assemblies are updated; the order of parts stays.
    void replace(const Part& part, const TopoDS_Shape& shape,
                 const TopTools_DataMapOfShapeShape& replaced);

    /// Gives the new faces of one hole the colours and layers on which their neighbours agree,
    /// whether these are the neighbours' own or those of their solid or part.
    ///
    /// Input    faces: of the part's shape.
    void adopt_looks(const Part& part, std::span<const TopoDS_Face> faces);

    /// Makes one part of all parts that hold only loose faces (no solid, no shell of two faces), so
    /// that they can be sewn: a compound of faces where they stand in the model. Their names,
    /// colours and layers become those of the faces. Does nothing if there are fewer than two. The
    /// read_model of an IGES file has done so already.
    void merge_loose();

    /// Makes one part of all occurrences that hold some of these edges, bodies and loose curves, so
    /// that a face can join them: a compound of them where they stand in the model. Their faces
    /// keep their looks. Does nothing where they all lie in one part with faces.
    ///
    /// Input    edges: of shape().
    void unite(const TopTools_IndexedMapOfShape& edges);
};

}  // namespace suture::io

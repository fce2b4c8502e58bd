#pragma once

#include "suture/base/result.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>

#include <vector>

namespace suture {

/// Faces after sewing, in the order in which they were given.
struct SewnFaces {
    std::vector<TopoDS_Face> faces;
};

/// Refuses  (Internal) when a face got lost on the way, with the number of such faces.
[[nodiscard]] Result<SewnFaces> sew_faces(const std::vector<TopoDS_Face>& faces, double tolerance);

/// Connected faces as one shell: turned to agree with each other, outwards where it is closed.
struct NewShell {
    TopoDS_Shell shell;
    bool bounds_solid = false;  ///< it is closed and has an inside
    std::vector<int> members;   ///< indices of its faces
};

/// Result  the connected shells of more than one face, or of one face that closes on itself.
[[nodiscard]] Result<std::vector<NewShell>> make_shells(const std::vector<TopoDS_Face>& faces);

}  // namespace suture

#pragma once

#include "suture/detect/shell_graph.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>

#include <vector>

namespace suture {

/// Connected faces as one shell: turned to agree with each other, outwards where it is closed.
struct NewShell {
    TopoDS_Shell shell;
    bool bounds_solid = false;  ///< it is closed and has an inside
    std::vector<int> members;   ///< indices of its faces
};

/// Input   shell: per face, the number of the shell that it lay in, -1: in none; the faces of one
///         follow each other. Those of one shell belong together first where several bodies have
///         an edge in common.
/// Result  the connected shells of more than one face, or of one face that closes on itself.
[[nodiscard]] std::vector<NewShell> make_shells(const std::vector<TopoDS_Face>& faces,
                                                const std::vector<int>& shell);

/// The shape with other faces, and with the shells that they make.
///
/// Input   graph: of the shape; now: what its faces have become; sewn: per face, whether it has a
///         new neighbour.
/// Result  a shell that was sewn within itself stands where it stood; what was sewn of several
///         shells or of loose faces stands at the end, as a solid where it closes.
[[nodiscard]] TopoDS_Shape with_new_bodies(const TopoDS_Shape& shape, const ShellGraph& graph,
                                           const std::vector<TopoDS_Face>& now,
                                           const std::vector<bool>& sewn);

}  // namespace suture

#pragma once

#include <Eigen/Core>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <string>
#include <string_view>
#include <vector>

namespace suture {

/// A free edge of a shell as the loop walks it, with the one face that uses it. Among chosen edges
/// there are also curves without any face.
struct BoundaryEdge {
    TopoDS_Edge edge;     ///< oriented so that walking it has the hole on the left, seen against
                          ///< the outward normal of `face`: opposite to its use in the face
    TopoDS_Face face;     ///< oriented as in its shell; null: a curve that no face uses
    int edge_number = 0;  ///< EdgeN of the model, 1-based; 0: a curve that was made
    int face_number = 0;  ///< FaceN of the model, 1-based
    /// What the new face is to be tangent to instead of `face`; null: nothing else.
    TopoDS_Face support;
    int support_number = 0;  ///< FaceN
};

/// What a boundary loop is.
enum class LoopKind {
    Hole,       ///< a face is missing here
    Rim,        ///< the outer rim of an open sheet
    Seam,       ///< lies on another loop or edge run within a gap: to be sewn, not filled
    Slit,       ///< folds back onto itself and encloses nothing
    Ambiguous,  ///< hole or rim: the geometry does not say
};

[[nodiscard]] std::string_view to_string(LoopKind kind);

/// An ordered, oriented run of free edges that closes.
struct BoundaryLoop {
    int id = 0;  ///< 1-based, in the order of the smallest edge number
    LoopKind kind = LoopKind::Ambiguous;
    std::vector<BoundaryEdge> edges;
    std::vector<int> islands_with;  ///< ids of the loops that bound the same missing face
    int shell_faces = 0;            ///< number of faces of the shell that it bounds
    double length = 0.0;            ///< model units
    double diameter = 0.0;          ///< diagonal of the bounding box, model units
    bool planar = false;            ///< all points within 1e-6 of the diameter of one plane
    double corner_reach = 0.0;      ///< corners whose ends are up to this far apart close as well
    double gap = 0.0;               ///< for seams: the largest distance to the other side
    std::string reason;             ///< one sentence: why it has this kind
};

}  // namespace suture

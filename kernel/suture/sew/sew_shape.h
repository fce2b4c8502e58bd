#pragma once

#include "suture/base/result.h"

#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace suture {

/// An edge that lies near others and was not sewn to them.
struct LeftOpen {
    double gap = 0.0;     ///< model units
    double length = 0.0;  ///< of the edge
    std::string reason;
};

/// What sewing made of a shape.
struct SewnShape {
    TopoDS_Shape shape;
    bool changed = false;    ///< false: there was nothing to sew and `shape` is the input
    double tolerance = 0.0;  ///< at which it was sewn, model units; 0: there was nothing to sew
    int loose_faces = 0;     ///< faces that shared no edge with another before
    int sewn_edges = 0;      ///< pairs of edges, or of parts of edges, that became one
    int walls = 0;           ///< faces between two bodies that were in one of them alone
    int free_edges_before = 0;
    int free_edges_after = 0;
    double largest_gap = 0.0;               ///< the widest gap that was closed
    std::vector<LeftOpen> left;             ///< what looks like a gap and was left
    TopTools_DataMapOfShapeShape replaced;  ///< input face -> face of `shape`, where they differ
};

/// Makes one edge of free edges that lie on each other: of loose faces (IGES, surface files), of
/// shells that touch, of the two sides of a crack. What is connected then is one shell, and a solid
/// where it closes. A wall between two bodies that only one of them has gets a second face.
///
/// Input    tolerance: 0 to take it from the model: the smallest that closes the model's gaps but
///          stays well below its real features (docs/holes.md); > 0 to use just that.
/// Promises shells without such edges stay untouched, down to the TShape; closed bodies that touch
///          stay apart.
[[nodiscard]] Result<SewnShape> sew_shape(const TopoDS_Shape& shape, double tolerance);

}  // namespace suture

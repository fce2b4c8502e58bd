#pragma once

#include "suture/base/result.h"

#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS_Shape.hxx>

namespace suture {

/// What sewing made of loose faces.
struct SewnShape {
    TopoDS_Shape shape;
    bool changed = false;    ///< false: there was nothing to sew and `shape` is the input
    double tolerance = 0.0;  ///< at which it was sewn, model units
    int loose_faces = 0;     ///< faces that lay alone before
    int free_edges_before = 0;
    int free_edges_after = 0;
    double largest_gap = 0.0;               ///< the widest gap that was closed
    TopTools_DataMapOfShapeShape replaced;  ///< input face -> face of `shape`, where they differ
};

/// Sews faces that do not share edges (IGES, surface files) into shells, and into solids where they
/// close.
///
/// Input    tolerance: 0 to take it from the model: the smallest that closes the model's gaps but
///          stays well below its real features (docs/holes.md); > 0 to use just that.
/// Promises shells that already share their edges stay untouched, down to the TShape.
[[nodiscard]] Result<SewnShape> sew_loose(const TopoDS_Shape& shape, double tolerance);

}  // namespace suture

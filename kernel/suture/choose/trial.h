#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"
#include "suture/base/tolerance.h"
#include "suture/check/fill_measures.h"
#include "suture/detect/boundary_loop.h"
#include "suture/faces/placement.h"
#include "suture/fill/fill.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"
#include "suture/occ/topology.h"

#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// Where a fill is to go.
struct Site {
    const TopoDS_Shape& shape;
    const std::vector<BoundaryLoop>& loops;  ///< the hole's, in the shape
    CandidateFinder candidates = {};         ///< surfaces of the model for it
    std::size_t guides = 0;                ///< so many of the hole's last points only guide a fill
    std::vector<std::string> spoilt = {};  ///< names of the fills that a file spoils
    /// Of the model that the shape is part of; null: it has no twins.
    const occ::Numbering* numbering = nullptr;
};

/// A fill in the model, for trial: its faces stand on copies of the hole's edges and of the faces
/// around, so that the model itself stays as it is. The numbers in the measures are of these
/// copies.
struct Trial {
    TopoDS_Compound model;
    FillPlace place;
    FillMeasures measures;              ///< all but the clashes
    std::vector<Placement> placements;  ///< of the edges on the new faces
};

/// Refuses  a face that OCCT's BRepCheck does not accept.
[[nodiscard]] Result<Trial> try_fill(const Site& site, const Hole& hole, const FillResult& fill,
                                     const Tolerance& tolerance, const Progress& progress);

/// Adds the clashes with all other faces of the shape to the measures.
[[nodiscard]] Result<void> add_clashes(const Site& site, const Hole& hole,
                                       const Tolerance& tolerance, const Progress& progress,
                                       Trial& trial);

}  // namespace suture

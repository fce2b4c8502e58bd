#pragma once

#include "suture/base/result.h"
#include "suture/choose/request.h"
#include "suture/flow/apply.h"
#include "suture/occ/topology.h"

#include <TopoDS_Shape.hxx>

namespace suture {

/// The whole flow from a shape to a shape: plan, compute, apply.
///
/// Input    shape with loose faces already sewn; numbering of the model that it is part of.
/// Changes  the shape, only where a hole is filled; a refused hole leaves no trace, a cancelled run
///          none at all.
/// Refuses  unknown methods, hole ids and edges that do not exist (Usage); a shape without a hole
///          (NothingToDo). A hole that cannot be filled is no error: its report says why.
[[nodiscard]] Result<FillOutcome> fill_holes(const TopoDS_Shape& shape,
                                             const occ::Numbering& numbering,
                                             const FillRequest& request);

}  // namespace suture

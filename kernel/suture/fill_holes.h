#pragma once

#include "suture/base/result.h"
#include "suture/choose/report.h"
#include "suture/choose/request.h"
#include "suture/occ/topology.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

struct FillOutcome {
    TopoDS_Shape shape;
    std::vector<HoleReport> holes;
    std::vector<TopoDS_Face> new_faces;
    double seconds_fill = 0.0;    ///< in the fill methods themselves
    double seconds_choose = 0.0;  ///< in these, and in making and measuring what each one gave
    double seconds_sew = 0.0;
};

/// The whole flow from a shape to a shape: find holes, ribbons, fill, faces, join, check.
///
/// Input    shape with loose faces already sewn; numbering of the model that it is part of.
/// Refuses  unknown methods, hole ids and edges that do not exist (Usage); a shape without a hole
///          (NothingToDo). A hole that cannot be filled is no error: its report says why.
[[nodiscard]] Result<FillOutcome> fill_holes(const TopoDS_Shape& shape,
                                             const occ::Numbering& numbering,
                                             const FillRequest& request);

}  // namespace suture

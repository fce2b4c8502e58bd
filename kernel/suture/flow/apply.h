#pragma once

#include "suture/base/result.h"
#include "suture/choose/report.h"
#include "suture/flow/compute.h"
#include "suture/model/implicit_form.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// The form that a hole's fill has beside its faces, in the part's own coordinates.
struct HoleForm {
    int hole = 0;  ///< the first of its ids
    ImplicitForm form;
};

struct FillOutcome {
    TopoDS_Shape shape;
    std::vector<HoleReport> holes;
    std::vector<TopoDS_Face> new_faces;
    std::vector<HoleForm> forms;  ///< of the fills whose method has one
    double seconds_fill = 0.0;    ///< in the fill methods themselves
    double seconds_choose = 0.0;  ///< in these, and in making and measuring what each one gave
    double seconds_sew = 0.0;
};

/// Puts the fills into the shape: corners united, faces made on its own edges, joined. The only
/// part of the flow that changes the shape: around the holes that are filled, and nowhere else.
[[nodiscard]] Result<FillOutcome> apply_fills(const TopoDS_Shape& shape,
                                              std::vector<ComputedFill> fills);

}  // namespace suture

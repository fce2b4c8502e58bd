#include "files/rigid.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Trsf.hxx>

#include <cmath>

namespace suture::io {
namespace {

bool is_motion(const gp_Trsf& placement) {
    return !placement.IsNegative() &&
           std::abs(placement.ScaleFactor() - 1.0) <= TopLoc_Location::ScalePrec();
}

TopoDS_Shape with_rigid_children(const TopoDS_Shape& compound) {
    const BRep_Builder builder;
    TopoDS_Compound result;
    builder.MakeCompound(result);
    bool changed = false;
    for (TopoDS_Iterator child(compound, false, false); child.More(); child.Next()) {
        const TopoDS_Shape rigid = with_rigid_placements(child.Value());
        changed = changed || !rigid.IsSame(child.Value());
        builder.Add(result, rigid);
    }
    if (!changed) {
        return compound;
    }
    result.Orientation(compound.Orientation());
    result.Location(compound.Location());
    return result;
}

}  // namespace

TopoDS_Shape with_rigid_placements(const TopoDS_Shape& shape) {
    const gp_Trsf placement = shape.Location().Transformation();
    if (!is_motion(placement)) {
        const TopoDS_Shape unplaced = with_rigid_placements(shape.Located(TopLoc_Location()));
        return BRepBuilderAPI_Transform(unplaced, placement, true).Shape();
    }
    return shape.ShapeType() == TopAbs_COMPOUND ? with_rigid_children(shape) : shape;
}

}  // namespace suture::io

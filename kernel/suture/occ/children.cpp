#include "suture/occ/children.h"

#include <TopoDS_Iterator.hxx>

namespace suture::occ {

std::optional<std::vector<TopoDS_Shape>> changed_children(
    const TopoDS_Shape& shape,
    const std::function<TopoDS_Shape(const TopoDS_Shape& child)>& new_form) {
    bool changed = false;
    std::vector<TopoDS_Shape> children;
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
        TopoDS_Shape child = new_form(it.Value());
        changed = changed || !child.IsSame(it.Value());
        if (!child.IsNull()) {
            children.push_back(std::move(child));
        }
    }
    if (!changed) {
        return std::nullopt;
    }
    return children;
}

}  // namespace suture::occ

#pragma once

#include <TopoDS_Shape.hxx>

#include <functional>
#include <optional>
#include <vector>

namespace suture::occ {

/// The children of a shape in a new form, those that became null left out; none where all are as
/// they were.
[[nodiscard]] std::optional<std::vector<TopoDS_Shape>> changed_children(
    const TopoDS_Shape& shape,
    const std::function<TopoDS_Shape(const TopoDS_Shape& child)>& new_form);

}  // namespace suture::occ

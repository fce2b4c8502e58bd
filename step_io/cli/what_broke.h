#pragma once

#include <TopoDS_Shape.hxx>

#include <string>

namespace suture::cli {

/// Why a shape is worse than it was before faces were taken away or made one: it is not valid,
/// open, or no solid any more. Empty if it is not.
[[nodiscard]] std::string what_broke(const TopoDS_Shape& before, const TopoDS_Shape& after);

}  // namespace suture::cli

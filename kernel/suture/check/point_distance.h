#pragma once

#include <Eigen/Core>

#include <TopoDS_Face.hxx>

#include <span>

namespace suture {

/// The distance of a point from the nearest of some faces.
[[nodiscard]] double measure_distance(const Eigen::Vector3d& point,
                                      std::span<const TopoDS_Face> faces);

}  // namespace suture

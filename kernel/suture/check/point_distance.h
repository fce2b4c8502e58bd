#pragma once

#include "suture/base/through_point.h"

#include <TopoDS_Face.hxx>

#include <span>

namespace suture {

/// How far faces are from what a point wants of them.
struct PointMiss {
    double distance = 0.0;  ///< of the point from the nearest of the faces, model units
    double angle = 0.0;     ///< between that one's normal there and the wanted one, at most pi/2
};

[[nodiscard]] PointMiss measure_miss(const ThroughPoint& wanted,
                                     std::span<const TopoDS_Face> faces);

}  // namespace suture

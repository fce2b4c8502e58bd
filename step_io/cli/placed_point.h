#pragma once

#include "suture/base/through_point.h"
#include "suture/occ/convert.h"

#include <gp_Trsf.hxx>

namespace suture::cli {

/// A point to be passed, taken along by a placement.
[[nodiscard]] inline ThroughPoint placed(const ThroughPoint& point, const gp_Trsf& placement) {
    ThroughPoint result;
    result.point = occ::from_occ(occ::to_point(point.point).Transformed(placement));
    if (point.normal) {
        const gp_Vec normal(point.normal->x(), point.normal->y(), point.normal->z());
        result.normal = occ::from_occ(normal.Transformed(placement)).normalized();
    }
    return result;
}

}  // namespace suture::cli

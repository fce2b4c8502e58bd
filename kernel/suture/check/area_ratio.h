#pragma once

#include "suture/base/result.h"

#include <TopoDS_Face.hxx>

#include <vector>

namespace suture {

/// The area of the faces that fill a hole, against that of a coarse surface that spans its border.
struct AreaRatio {
    double area = 0.0;      ///< of the faces, within a few percent
    double spanning = 0.0;  ///< of the coarse surface
    int loops = 0;          ///< of the border

    /// 1 for a flat fill, 2 for half of a ball on its rim, 1 / sin(a) for a cone's tip of
    /// half-angle a; 0 where the border spans nothing.
    [[nodiscard]] double ratio() const { return spanning > 0.0 ? area / spanning : 0.0; }
};

/// The border is what the faces' edges leave when those between two of them are taken away. Each of
/// its loops is spanned by a fan of triangles, relaxed until every point is the mean of those
/// around it; two loops or more also by strips from each to the next: the larger area counts.
///
/// Input    the faces of one hole.
/// Result   spanning 0 without a border: the faces close by themselves.
/// Refuses  no faces (Usage); what OCCT cannot evaluate.
[[nodiscard]] Result<AreaRatio> measure_area_ratio(const std::vector<TopoDS_Face>& faces);

}  // namespace suture

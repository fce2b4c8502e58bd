#pragma once

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace suture::io {

/// A face without triangles.
struct UnmeshedFace {
    int face = 0;       ///< FaceN of the shape
    std::string part;   ///< the part whose FaceN it is; empty: the whole shape
    bool area = false;  ///< false: it has collapsed to a curve or a point, nothing is missing
    std::string reason;
};

/// "face 17 of part 'wing' could not be meshed: its boundary crosses itself"
[[nodiscard]] std::string text_of(const UnmeshedFace& face);

/// Has OCCT mesh the shape itself, so that faces that share an edge share its points. A face that
/// it cannot mesh is meshed finer, alone; its neighbours take over the points of its edges. The
/// shape's old triangles are thrown away.
///
/// Input    deflection: model units; angle: radians between neighbouring facets
/// Result   the faces that have none
[[nodiscard]] std::vector<UnmeshedFace> triangulate(const TopoDS_Shape& shape, double deflection,
                                                    double angle);

}  // namespace suture::io

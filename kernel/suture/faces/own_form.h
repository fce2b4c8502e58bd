#pragma once

#include "suture/detect/boundary_loop.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"
#include "suture/occ/handle.h"

#include <Eigen/Core>

#include <Geom_Surface.hxx>

#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Where the sides of a hole run on a surface: by loop and side, at kTraced even parameters each,
/// without jumps across seams; islands in the period of the first loop.
inline constexpr int kTraced = 33;
using HoleTrace = std::vector<std::vector<std::vector<Eigen::Vector2d>>>;

/// An extruded, revolved or offset surface, which a fill method has as a B-spline only: a
/// neighbour's, a moved one, an offset.
struct OwnForm {
    std::string kind;  ///< "surface of extrusion", "surface of revolution", "offset surface"
    occ::Handle<Geom_Surface> surface;  ///< a copy: an edge keeps one curve for each surface
    HoleTrace trace;
};

/// The surface of which the patch is a copy as a B-spline: the one that it says itself, or that of
/// a face around the hole.
///
/// Input    loops: the hole's, whose edges have the faces.
/// Result   nothing where the patch is no B-spline, lies further off than 2e-7 of the hole's
///          diameter from each of these surfaces, or has a seam or a pole; and where the border
///          goes around the surface, or runs over a line where it ends or is closed without a
///          period.
[[nodiscard]] std::optional<OwnForm> own_form_of(const Patch& patch,
                                                 const std::vector<BoundaryLoop>& loops,
                                                 const Hole& hole);

}  // namespace suture

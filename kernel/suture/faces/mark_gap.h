#pragma once

#include "suture/occ/handle.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

namespace suture {

/// A pcurve from which a reader computes a tolerance that covers the edge's whole gap.
///
/// STEP and IGES store no tolerances. OCCT's readers compute that of an edge anew, as the largest
/// distance between the edge's curve and its pcurve's image at 23 even parameters
/// (BRepLib_ValidateEdge), and miss a peak between them: OCCT's own Boolean operations and
/// FreeCAD's check then find an edge that its tolerance does not cover (InvalidCurveOnSurface).
/// So the pcurve runs ahead of the edge by about the gap at one of these parameters, within a
/// stretch of 1/22 of the edge: where it lies on the surface is not changed by that, and the
/// largest distance is at that parameter.
///
/// Input    pcurve: by the curve's own parameter on [first, last]; gap: the largest distance
///          between the two at equal parameters.
/// Result   the largest distance is at most 1.21 times the gap; the pcurve as it was where the gap
///          is below OCCT's smallest tolerance, shows already, or cannot be made to show.
[[nodiscard]] occ::Handle<Geom2d_Curve> mark_gap(const occ::Handle<Geom_Curve>& curve, double first,
                                                 double last,
                                                 const occ::Handle<Geom_Surface>& surface,
                                                 const occ::Handle<Geom2d_Curve>& pcurve,
                                                 double gap);

}  // namespace suture

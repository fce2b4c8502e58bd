#include "suture/fill_holes.h"

#include "support/grids.h"
#include "support/read_for_test.h"
#include "suture/occ/convert.h"
#include "suture/occ/handle.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <STEPControl_Writer.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace suture {
namespace {

using occ::Handle;
using grids::without_faces;

constexpr double kTurn = 2.0 * kPi;

double volume(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties, 1e-11);
    return properties.Mass();
}

/// A piece of a surface, for one face.
struct Cell {
    Handle<Geom_Surface> surface;
    double u0, u1, v0, v1;
};

/// The sewn shell of faces on cells, with a plane disc in each opening if asked.
TopoDS_Shape body_of(const std::vector<Cell>& cells, bool with_ends) {
    constexpr double kTolerance = 1e-7;
    BRepBuilderAPI_Sewing sewing(kTolerance);
    for (const Cell& c : cells) {
        sewing.Add(BRepBuilderAPI_MakeFace(c.surface, c.u0, c.u1, c.v0, c.v1, kTolerance));
    }
    sewing.Perform();
    if (!with_ends) {
        return sewing.SewedShape();
    }
    BRepBuilderAPI_Sewing closing(kTolerance);
    closing.Add(sewing.SewedShape());
    for (int i = 1; i <= sewing.NbFreeEdges(); ++i) {
        BRepBuilderAPI_MakeWire wire(sewing.FreeEdge(i));
        closing.Add(BRepBuilderAPI_MakeFace(wire, /*OnlyPlane=*/Standard_True));
    }
    closing.Perform();
    return closing.SewedShape();
}

}  // namespace
}  // namespace suture

#pragma once

#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

/// Sheets whose surfaces are no B-splines.
namespace suture::swept_sheets {

/// How a sheet is made of a B-spline profile: turned about the z axis, pushed along it, or turned
/// and moved along its normals.
enum class Sweep { Turned, Pushed, Offset };

inline TopoDS_Face swept(Sweep sweep) {
    const bool turned = sweep != Sweep::Pushed;
    TColgp_Array1OfPnt points(1, 5);
    const double x[] = {10.0, 13.0, 9.0, 12.0, 11.0};
    for (int i = 1; i <= 5; ++i) {
        points.SetValue(i, turned ? gp_Pnt(x[i - 1], 0, 4.0 * i) : gp_Pnt(x[i - 1], 4.0 * i, 0));
    }
    const TopoDS_Edge profile = BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve());
    const TopoDS_Shape sheet =
        turned ? BRepPrimAPI_MakeRevol(profile, gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ()), 1.5).Shape()
               : BRepPrimAPI_MakePrism(profile, gp_Vec(0, 0, 14)).Shape();
    if (sweep != Sweep::Offset) {
        return occ::faces_of(sheet).front();
    }
    const auto spline =
        BRep_Tool::Surface(TopoDS::Face(BRepBuilderAPI_NurbsConvert(sheet, /*Copy=*/true).Shape()));
    return BRepBuilderAPI_MakeFace(occ::make<Geom_OffsetSurface>(spline, 0.7), 1e-7);
}

}  // namespace suture::swept_sheets

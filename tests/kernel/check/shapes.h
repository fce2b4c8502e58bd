#pragma once

#include "suture/base/tolerance.h"
#include "suture/occ/handle.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

/// Small shapes whose gaps, angles and curvatures are known in closed form.
namespace suture::shapes {

inline TopoDS_Compound compound(const std::vector<TopoDS_Shape>& parts) {
    TopoDS_Compound result;
    const BRep_Builder builder;
    builder.MakeCompound(result);
    for (const auto& part : parts) {
        builder.Add(result, part);
    }
    return result;
}

inline TopoDS_Shape sewn(const std::vector<TopoDS_Shape>& faces, double tolerance = 1e-6) {
    BRepBuilderAPI_Sewing sewing(tolerance);
    for (const auto& face : faces) {
        sewing.Add(face);
    }
    sewing.Perform();
    return sewing.SewedShape();
}

inline TopoDS_Face face_on(const occ::Handle<Geom_Surface>& surface) {
    return BRepBuilderAPI_MakeFace(surface, Precision::Confusion()).Face();
}

inline TopoDS_Edge edge_between(const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
    return BRepBuilderAPI_MakeEdge(a, b).Edge();
}

/// Two rectangles, 1x2 and 3x2, sharing the edge on the y axis; outward normals apart by `angle`.
/// The first lies in z = 0 at x < 0, normal +z.
inline TopoDS_Shape folded_planes(double angle) {
    const gp_Vec along(std::cos(angle), 0.0, -std::sin(angle));
    const auto vertex = [](const gp_Pnt& p) { return BRepBuilderAPI_MakeVertex(p).Vertex(); };
    const gp_Pnt p0(0, 0, 0);
    const gp_Pnt p1(0, 2, 0);
    const auto v0 = vertex(p0);
    const auto v1 = vertex(p1);
    const TopoDS_Edge shared = edge_between(v0, v1);
    const auto rectangle = [&](const TopoDS_Vertex& from, const TopoDS_Vertex& to,
                               const TopoDS_Edge& first, const gp_Vec& side, const gp_Dir& normal) {
        const auto c = vertex(BRep_Tool::Pnt(to).Translated(side));
        const auto d = vertex(BRep_Tool::Pnt(from).Translated(side));
        BRepBuilderAPI_MakeWire wire(first, edge_between(to, c), edge_between(c, d),
                                     edge_between(d, from));
        return BRepBuilderAPI_MakeFace(gp_Pln(p0, normal), wire.Wire()).Face();
    };
    const auto flat = rectangle(v0, v1, shared, gp_Vec(-1, 0, 0), gp_Dir(0, 0, 1));
    const auto folded = rectangle(v1, v0, TopoDS::Edge(shared.Reversed()), 3.0 * along,
                                  gp_Dir(std::sin(angle), 0.0, std::cos(angle)));
    return compound({flat, folded});
}

/// A wire turned about the z axis, `angle` of the whole way.
inline TopoDS_Shape revolved(const std::vector<TopoDS_Edge>& profile, double angle = 2.0 * kPi) {
    BRepBuilderAPI_MakeWire wire;
    for (const auto& edge : profile) {
        wire.Add(edge);
    }
    return BRepPrimAPI_MakeRevol(wire.Wire(), gp_Ax1(), angle).Shape();
}

inline TopoDS_Edge arc(const gp_Pnt& a, const gp_Pnt& middle, const gp_Pnt& b) {
    return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, middle, b).Value()).Edge();
}

/// A pipe of this radius closed by a hemisphere: cylinder below z = 0, sphere above.
inline TopoDS_Shape capsule(double radius) {
    const double h = radius * std::sqrt(0.5);
    const gp_Pnt rim(radius, 0, 0);
    return revolved({BRepBuilderAPI_MakeEdge(gp_Pnt(radius, 0, -3.0 * radius), rim).Edge(),
                     arc(rim, {h, 0, h}, {0, 0, radius})});
}

/// A plane that runs smoothly into the eighth of a cylinder, along an edge of length 7.
inline TopoDS_Shape plane_into_cylinder(double radius) {
    const auto on_arc = [radius](double angle) {
        return gp_Pnt(radius * std::sin(angle), 0, radius * std::cos(angle) - radius);
    };
    BRepBuilderAPI_MakeWire profile(
        BRepBuilderAPI_MakeEdge(gp_Pnt(-4, 0, 0), gp_Pnt(0, 0, 0)).Edge(),
        arc(on_arc(0.0), on_arc(kPi / 8), on_arc(kPi / 4)));
    return BRepPrimAPI_MakePrism(profile.Wire(), gp_Vec(0, 7, 0)).Shape();
}

/// A cylinder that runs smoothly into a torus: a rounded rim of radius `fillet`.
inline TopoDS_Shape rounded_rim(double radius, double fillet) {
    const double h = fillet * (1.0 - std::sqrt(0.5));
    const gp_Pnt rim(radius, 0, 0);
    return revolved(
        {BRepBuilderAPI_MakeEdge(gp_Pnt(radius, 0, -2.0), rim).Edge(),
         arc(rim, {radius - h, 0, fillet * std::sqrt(0.5)}, {radius - fillet, 0, fillet})});
}

using Net = std::vector<std::vector<gp_Pnt>>;  ///< [row of u][column of v]

inline TColgp_Array2OfPnt poles(const Net& net) {
    TColgp_Array2OfPnt result(1, static_cast<int>(net.size()), 1,
                              static_cast<int>(net.front().size()));
    for (int i = 0; i < result.ColLength(); ++i) {
        for (int j = 0; j < result.RowLength(); ++j) {
            result(i + 1, j + 1) =
                net.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j));
        }
    }
    return result;
}

inline occ::Handle<Geom_Surface> bezier(const Net& net) {
    return occ::make<Geom_BezierSurface>(poles(net));
}

/// A height field over [x0,x1]x[0,2] whose Bezier ordinates are z(i, j): x and y stay linear, so
/// that derivatives by x and y are those by the parameters, scaled.
inline occ::Handle<Geom_Surface> height_field(double x0, double x1, int degree_u, int degree_v,
                                              const std::function<double(int, int)>& z) {
    Net net;
    for (int i = 0; i <= degree_u; ++i) {
        net.emplace_back();
        for (int j = 0; j <= degree_v; ++j) {
            net.back().emplace_back(x0 + (x1 - x0) * i / degree_u, 2.0 * j / degree_v, z(i, j));
        }
    }
    return bezier(net);
}

/// Degree 2 by 1 over [-1, 1] x [0, 2] with a double knot at 0: z(x) = left for x < 0, right for
/// x > 0, given by the heights of the five poles.
inline occ::Handle<Geom_BSplineSurface> folded_spline(const std::array<double, 5>& z) {
    TColgp_Array2OfPnt net(1, 5, 1, 2);
    for (int i = 1; i <= 5; ++i) {
        net(i, 1) = gp_Pnt(-1.5 + 0.5 * i, 0, z.at(static_cast<std::size_t>(i - 1)));
        net(i, 2) = gp_Pnt(-1.5 + 0.5 * i, 2, z.at(static_cast<std::size_t>(i - 1)));
    }
    TColStd_Array1OfReal knots_u(1, 3), knots_v(1, 2);
    TColStd_Array1OfInteger mults_u(1, 3), mults_v(1, 2);
    for (int i = 1; i <= 3; ++i) {
        knots_u(i) = i - 2;
        mults_u(i) = i == 2 ? 2 : 3;
    }
    knots_v(1) = 0;
    knots_v(2) = 2;
    mults_v.Init(2);
    return occ::make<Geom_BSplineSurface>(net, knots_u, knots_v, mults_u, mults_v, 2, 1);
}

}  // namespace suture::shapes

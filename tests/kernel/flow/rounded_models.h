#pragma once

#include "suture/occ/topology.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomAbs_SurfaceType.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

/// Bodies whose faces are planes, cylinders, cones, spheres and tori of known sizes.
namespace suture::rounded {

/// A body, and the faces of it that are taken out one at a time: those of these kinds.
struct Model {
    std::string name;
    TopoDS_Shape shape;
    std::set<GeomAbs_SurfaceType> kinds;
};

inline TopoDS_Shape filleted(const TopoDS_Shape& shape, double radius,
                             const std::function<bool(const TopoDS_Edge&)>& chosen) {
    BRepFilletAPI_MakeFillet fillet(shape);
    for (const TopoDS_Edge& edge : occ::edges_of(shape)) {
        if (chosen(edge)) {
            fillet.Add(radius, edge);
        }
    }
    fillet.Build();
    return fillet.Shape();
}

inline gp_Pnt middle(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    return curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
}

/// A prism over a polygon, its top edges and those upright rounded with one radius.
inline TopoDS_Shape rounded_prism(const std::vector<gp_Pnt>& base, double height, double radius) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& p : base) {
        polygon.Add(p);
    }
    polygon.Close();
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(polygon.Wire());
    const TopoDS_Shape prism = BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, height)).Shape();
    return filleted(prism, radius,
                    [&](const TopoDS_Edge& edge) { return middle(edge).Z() > 0.1 * height; });
}

inline bool is_circle(const TopoDS_Edge& edge) {
    return BRepAdaptor_Curve(edge).GetType() == GeomAbs_Circle;
}

/// A plate with a boss whose foot, or rim, is rounded.
inline TopoDS_Shape boss(double r, double h, double fillet, bool foot) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -5), gp_Pnt(20, 20, 0)).Shape();
    const TopoDS_Shape post =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1, 2, 0), gp::DZ()), r, h).Shape();
    const TopoDS_Shape whole = BRepAlgoAPI_Fuse(plate, post).Shape();
    const double z = foot ? 0.0 : h;
    return filleted(whole, fillet, [&](const TopoDS_Edge& edge) {
        return is_circle(edge) && std::abs(middle(edge).Z() - z) < 1e-6;
    });
}

/// A box with one upright edge rounded with R and then the rim above with r: a torus corner.
inline TopoDS_Shape torus_corner(double R, double r) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30.0, 25.0, 20.0).Shape();
    const TopoDS_Shape upright = filleted(box, R, [](const TopoDS_Edge& edge) {
        const gp_Pnt p = middle(edge);
        return p.X() < 1e-6 && p.Y() < 1e-6;
    });
    return filleted(upright, r, [](const TopoDS_Edge& edge) {
        const gp_Pnt p = middle(edge);
        return std::abs(p.Z() - 20.0) < 1e-6 && p.X() + p.Y() < 28.0;
    });
}

/// A box with a slot whose ends are half round and whose bottom edge is rounded.
inline TopoDS_Shape slot(double width, double depth, double fillet) {
    const double r = 0.5 * width;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-30, -15, -12), gp_Pnt(30, 15, 0)).Shape();
    const gp_Pnt low(-12, 0, -depth);
    TopoDS_Shape tool = BRepPrimAPI_MakeBox(gp_Pnt(-12, -r, -depth), gp_Pnt(12, r, 1)).Shape();
    for (const double x : {-12.0, 12.0}) {
        const gp_Ax2 axis(gp_Pnt(x, 0, -depth), gp::DZ());
        tool = BRepAlgoAPI_Fuse(tool, BRepPrimAPI_MakeCylinder(axis, r, depth + 1).Shape()).Shape();
    }
    const TopoDS_Shape cut = BRepAlgoAPI_Cut(box, tool).Shape();
    return filleted(cut, fillet, [&](const TopoDS_Edge& edge) {
        return std::abs(middle(edge).Z() + depth) < 1e-6 && std::abs(middle(edge).Y()) < r + 1e-6 &&
               std::abs(middle(edge).X()) < 12.0 + r + 1e-6;
    });
}

/// A block with a bore along an axis.
inline TopoDS_Shape bored(double r, const gp_Dir& along) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), gp_Pnt(10, 10, 8)).Shape();
    const gp_Pnt start = gp_Pnt(1, 2, 4).Translated(gp_Vec(along) * -20.0);
    return BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(gp_Ax2(start, along), r, 40.0).Shape())
        .Shape();
}

/// A bore with a countersink.
inline TopoDS_Shape countersunk(double r, double rim) {
    const gp_Ax2 mouth(gp_Pnt(1, 2, 8), gp::DZ().Reversed());
    const TopoDS_Shape tip = BRepPrimAPI_MakeCone(mouth, rim, r, 3.0).Shape();
    return BRepAlgoAPI_Cut(bored(r, gp::DZ()), tip).Shape();
}

/// A shaft with a bore across it.
inline TopoDS_Shape cross_bored(double shaft, double bore) {
    const TopoDS_Shape body =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -15), gp::DZ()), shaft, 30.0).Shape();
    const gp_Ax2 across(gp_Pnt(-20, 0, 0), gp::DX());
    return BRepAlgoAPI_Cut(body, BRepPrimAPI_MakeCylinder(across, bore, 40.0).Shape()).Shape();
}

/// A post with half-round ends, or a box with one rounded edge.
inline TopoDS_Shape half_round(double width) {
    const double r = 0.5 * width;
    TopoDS_Shape post = BRepPrimAPI_MakeBox(gp_Pnt(-9, -r, 0), gp_Pnt(9, r, 12)).Shape();
    // Rounding both edges of an end by all of its width leaves no plane there: cut it instead.
    for (const double x : {-9.0, 9.0}) {
        const TopoDS_Shape round =
            BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 0, 0), gp::DZ()), r, 12.0).Shape();
        post = BRepAlgoAPI_Fuse(post, round).Shape();
    }
    return post;
}

inline TopoDS_Shape one_rounded_edge(double r) {
    return filleted(BRepPrimAPI_MakeBox(30.0, 25.0, 20.0).Shape(), r, [](const TopoDS_Edge& edge) {
        const gp_Pnt p = middle(edge);
        return p.X() < 1e-6 && p.Y() < 1e-6;
    });
}

/// A box on a plate, the inner edge between them rounded.
inline TopoDS_Shape one_rounded_notch(double r) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(30.0, 25.0, 10.0).Shape();
    const TopoDS_Shape upper = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(12, 25, 20)).Shape();
    return filleted(BRepAlgoAPI_Fuse(plate, upper).Shape(), r, [](const TopoDS_Edge& edge) {
        const gp_Pnt p = middle(edge);
        return std::abs(p.X() - 12.0) < 1e-6 && std::abs(p.Z() - 10.0) < 1e-6;
    });
}

inline std::vector<Model> models() {
    const std::set<GeomAbs_SurfaceType> all = {GeomAbs_Sphere, GeomAbs_Torus, GeomAbs_Cylinder,
                                               GeomAbs_Cone};
    std::vector<Model> result;
    const auto add = [&](const std::string& name, const TopoDS_Shape& shape) {
        result.push_back({name, shape, all});
    };
    const std::vector<gp_Pnt> square = {{0, 0, 0}, {30, 0, 0}, {30, 25, 0}, {0, 25, 0}};
    const std::vector<gp_Pnt> skew = {{0, 0, 0}, {30, 0, 0}, {40, 25, 0}, {8, 22, 0}};
    const std::vector<gp_Pnt> three = {{0, 0, 0}, {40, 5, 0}, {10, 35, 0}};
    for (const double r : {1.5, 3.0, 4.7}) {
        add("box", rounded_prism(square, 20, r));
        add("skew prism", rounded_prism(skew, 20, r));
    }
    add("three-sided prism", rounded_prism(three, 15, 2.5));
    for (const double angle : {50.0, 65.0, 80.0, 105.0, 120.0, 135.0}) {
        const double x = 25.0 * std::cos(angle * M_PI / 180.0);
        const double y = 25.0 * std::sin(angle * M_PI / 180.0);
        add(std::to_string(angle) + " deg",
            rounded_prism({{0, 0, 0}, {30, 0, 0}, {30 + x, y, 0}, {x, y, 0}}, 15, 2.0));
    }
    for (const double r : {4.0, 6.0, 7.5}) {
        for (const double fillet : {1.0, 2.2}) {
            result.push_back({"boss, foot", boss(r, 10, fillet, true), {GeomAbs_Torus}});
            result.push_back({"boss, rim", boss(r, 10, fillet, false), {GeomAbs_Torus}});
        }
    }
    const std::vector<std::pair<double, double>> corners = {{8, 2},   {5, 3},  {10, 1},
                                                            {6, 2.5}, {12, 4}, {7, 1.5}};
    for (const auto& [R, r] : corners) {
        add("torus corner", torus_corner(R, r));
    }
    add("slot", slot(8, 5, 1));
    add("slot", slot(10, 6, 1.5));
    add("slot", slot(6, 4, 0.8));
    for (const double r : {1.0, 2.5, 3.25, 6.0}) {
        add("bore", bored(r, gp::DZ()));
        add("tilted bore", bored(0.5 * r, gp_Dir(0.3, -0.2, 1.0)));
    }
    add("countersink", countersunk(2.0, 4.0));
    add("countersink", countersunk(3.0, 3.8));
    for (const double bore : {1.5, 3.0, 5.0, 7.0}) {
        add("cross-bore", cross_bored(10.0, bore));
        add("cross-bore", cross_bored(8.5, 0.9 * bore));
    }
    for (const double width : {6.0, 10.0, 14.0}) {
        add("half-round ends", half_round(width));
    }
    for (const double r : {1.0, 2.0, 5.0}) {
        add("one edge", one_rounded_edge(r));
        add("one notch", one_rounded_notch(r));
    }
    return result;
}

}  // namespace suture::rounded

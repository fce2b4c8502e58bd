#pragma once

#include "support/grids.h"
#include "suture/base/tolerance.h"
#include "suture/detect/find_loops.h"
#include "suture/fill/fill.h"
#include "suture/occ/handle.h"
#include "suture/ribbon/extract.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include <string>
#include <vector>

/// Open shells, their holes, and exact fills of these.
namespace suture::test {

struct OpenHole {
    std::vector<BoundaryLoop> loops;
    Hole hole;
    FillResult fill;
};

/// Each loop of a shape with what the first method makes of it that takes it.
inline std::vector<OpenHole> holes_of(const TopoDS_Shape& shape) {
    std::vector<OpenHole> result;
    const auto loops = find_loops(shape, occ::Numbering(shape));
    EXPECT_TRUE(loops) << loops.error().message;
    for (const BoundaryLoop& loop : loops.value()) {
        OpenHole& open = result.emplace_back();
        open.loops = {loop};
        open.hole = extract_hole(open.loops).value();
        for (const FillMethod& method : fill_methods()) {
            if (auto fill = method.fill(open.hole, {})) {
                open.fill = std::move(*fill);
                break;
            }
        }
        EXPECT_FALSE(open.fill.patches.empty());
    }
    return result;
}

inline gp_Trsf turned_and_moved() {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -2, 2)), 1.1);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(30, -20, 10));
    return move * turn;
}

inline gp_Trsf scaled(double factor) {
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(), factor);
    return scale;
}

struct Variant {
    std::string name;
    TopoDS_Shape shape;
    double scale = 1.0;
};

/// A shape, and what must make no difference to it.
inline std::vector<Variant> variants_of(const TopoDS_Shape& shape) {
    const auto copied = [&](const gp_Trsf& change) {
        return BRepBuilderAPI_Transform(shape, change, /*Copy=*/true).Shape();
    };
    return {{"as it is", shape},
            {"reversed", shape.Reversed()},
            {"located", shape.Moved(TopLoc_Location(turned_and_moved()))},
            {"turned", copied(turned_and_moved())},
            {"small", copied(scaled(1e-3)), 1e-3},
            {"large", copied(scaled(1e3)), 1e3}};
}

inline TopoDS_Shape box_without(const std::set<int>& missing) {
    return grids::without_faces(BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Shape(), missing);
}

/// A torus of twelve cells, one of them missing; as a B-spline surface if asked for.
inline TopoDS_Shape torus_without_a_cell(bool spline) {
    occ::Handle<Geom_Surface> surface =
        occ::make<Geom_ToroidalSurface>(gp_Ax3(gp_Pnt(1, -2, 3), gp_Dir(1, 2, -1)), 5.0, 1.5);
    if (spline) {
        const auto converted = GeomConvert::SurfaceToBSplineSurface(surface);
        converted->SetUNotPeriodic();
        converted->SetVNotPeriodic();
        surface = converted;
    }
    return grids::shell_of(surface, {0.0, 1.3, 2.9, 4.4, 2.0 * kPi}, {0.0, 1.7, 3.6, 2.0 * kPi},
                           {{1, 1}});
}

/// The open shells that every test of this folder goes through.
inline std::vector<Variant> open_shells() {
    std::vector<Variant> result;
    for (const auto& [name, shape] : std::vector<std::pair<std::string, TopoDS_Shape>>{
             {"box", box_without({0})},
             {"box with two openings", box_without({0, 1})},
             {"torus", torus_without_a_cell(false)},
             {"B-spline torus", torus_without_a_cell(true)}}) {
        for (Variant& variant : variants_of(shape)) {
            variant.name = name + ", " + variant.name;
            result.push_back(std::move(variant));
        }
    }
    return result;
}

/// The tolerances of the edges and vertices of a shape, in TopExp's order.
inline std::vector<double> tolerances_of(const TopoDS_Shape& shape) {
    std::vector<double> result;
    for (const TopoDS_Edge& edge : occ::edges_of(shape)) {
        result.push_back(BRep_Tool::Tolerance(edge));
        for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
            result.push_back(BRep_Tool::Tolerance(vertex));
        }
    }
    return result;
}

}  // namespace suture::test

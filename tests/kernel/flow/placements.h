#pragma once

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepLib.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include <string>
#include <vector>

/// Where models stand in tests: turned, small, large, far away, inside out.
namespace suture::placements {

struct Placement {
    std::string name;
    gp_Trsf transformation;
    double scale = 1.0;
    bool reversed = false;  ///< inside out
};

inline std::vector<Placement> all() {
    std::vector<Placement> result(1);
    gp_Trsf turned;
    turned.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -2, 0.7)), 1.1);
    result.push_back({"turned", turned});
    gp_Trsf small;
    small.SetScale(gp_Pnt(0, 0, 0), 1e-3);
    result.push_back({"small", turned * small, 1e-3});
    gp_Trsf large;
    large.SetScale(gp_Pnt(0, 0, 0), 1e3);
    result.push_back({"large", turned * large, 1e3});
    gp_Trsf far;
    far.SetTranslation(gp_Vec(1e6, -2e6, 5e5));
    result.push_back({"far", far * turned});
    result.push_back({"reversed", turned, 1.0, true});
    return result;
}

inline TopoDS_Shape placed(const TopoDS_Shape& shape, const Placement& placement) {
    const TopoDS_Shape body =
        BRepBuilderAPI_Transform(shape, placement.transformation, /*Copy=*/true).Shape();
    BRepLib::EncodeRegularity(body, 1e-6);
    return placement.reversed ? body.Reversed() : body;
}

}  // namespace suture::placements

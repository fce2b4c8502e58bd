#pragma once

#include <GeomAbs_Shape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

#include <string>
#include <vector>

namespace suture {

/// BRepOffsetAPI_MakeFilling's ten constructor arguments.
struct PlateArguments {
    int energy_degree = 3;
    int points_on_curve = 15;
    int iterations = 2;
    bool anisotropic = false;
    double tolerance_2d = 1e-5;
    double tolerance_3d = 1e-4;
    double tolerance_angular = 0.01;
    double tolerance_curvature = 0.1;
    int highest_degree = 8;
    int most_segments = 9;
};

struct PlateSide {
    TopoDS_Edge edge;
    TopoDS_Face face;  ///< null: there is none, and the constraint is the position alone
    GeomAbs_Shape constraint = GeomAbs_C0;
    std::string name;  ///< for messages
};

/// What the program `suture_occt_filling` is asked for: OCCT's filling, in a process of its own.
struct PlateRequest {
    PlateArguments arguments;
    std::vector<PlateSide> sides;
    std::vector<gp_Pnt> through;
};

[[nodiscard]] std::string packed(const PlateRequest& request);
[[nodiscard]] PlateRequest unpacked_request(const std::string& bytes);

/// The answer: OCCT's face, and after it the sides' edges as OCCT copied them, with their curves on
/// it.
[[nodiscard]] std::string packed(const TopoDS_Compound& made);
[[nodiscard]] TopoDS_Shape unpacked_shape(const std::string& bytes);

}  // namespace suture

#pragma once

#include <GeomAbs_Shape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

#include <cstddef>
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
    TopoDS_Face face;
    GeomAbs_Shape constraint = GeomAbs_C0;
};

struct MadePlate {
    enum class Outcome { Done, NoSurface, NoFace, LostEdge };
    Outcome outcome = Outcome::Done;
    std::size_t lost = 0;  ///< the side whose edge is lost
    /// OCCT's face, and after it the sides' edges as OCCT copied them, with their curves on it.
    TopoDS_Compound shape;
};

/// OCCT's filling, the only code that calls its libraries of offsets and fillets: a module of its
/// own, loaded only by runs that ask for it.
using MakePlate = MadePlate(const std::vector<PlateSide>& sides, const std::vector<gp_Pnt>& through,
                            const PlateArguments& arguments);

}  // namespace suture

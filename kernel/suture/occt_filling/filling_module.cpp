#include "suture/occt_filling/filling_module.h"

#include <BRepOffsetAPI_MakeFilling.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>

namespace suture {
namespace {

MadePlate make_plate(const std::vector<PlateSide>& sides, const std::vector<gp_Pnt>& through,
                     const PlateArguments& a) {
    using Outcome = MadePlate::Outcome;
    BRepOffsetAPI_MakeFilling filling(a.energy_degree, a.points_on_curve, a.iterations,
                                      a.anisotropic, a.tolerance_2d, a.tolerance_3d,
                                      a.tolerance_angular, a.tolerance_curvature, a.highest_degree,
                                      a.most_segments);
    for (const PlateSide& side : sides) {
        filling.Add(side.edge, side.face, side.constraint, /*IsBound=*/Standard_True);
    }
    for (const gp_Pnt& point : through) {
        filling.Add(point);
    }
    filling.Build();
    if (!filling.IsDone() || filling.Shape().IsNull()) {
        return {Outcome::NoSurface, 0, {}};
    }
    TopExp_Explorer it(filling.Shape(), TopAbs_FACE);
    if (!it.More()) {
        return {Outcome::NoFace, 0, {}};
    }
    const BRep_Builder builder;
    MadePlate made;
    builder.MakeCompound(made.shape);
    builder.Add(made.shape, it.Current());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto& copies = filling.Generated(sides[i].edge.Oriented(TopAbs_FORWARD));
        if (copies.IsEmpty()) {
            return {Outcome::LostEdge, i, {}};
        }
        builder.Add(made.shape, copies.First());
    }
    return made;
}

}  // namespace
}  // namespace suture

extern "C" {
/// What fill_with_plate looks for.
extern suture::MakePlate* const suture_make_plate;
suture::MakePlate* const suture_make_plate = suture::make_plate;
}

// OCCT's filling, the only code that calls its libraries of offsets and fillets: a program, because
// it can crash or hang, and is asked for by a process that has threads.
#include "suture/occ/isolate.h"
#include "suture/occt_filling/filling_request.h"

#include <BRepOffsetAPI_MakeFilling.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>

namespace suture {
namespace {

Result<std::string> make_plate(const PlateRequest& request) {
    const PlateArguments& a = request.arguments;
    BRepOffsetAPI_MakeFilling filling(a.energy_degree, a.points_on_curve, a.iterations,
                                      a.anisotropic, a.tolerance_2d, a.tolerance_3d,
                                      a.tolerance_angular, a.tolerance_curvature, a.highest_degree,
                                      a.most_segments);
    for (const PlateSide& side : request.sides) {
        if (side.face.IsNull()) {
            filling.Add(side.edge, GeomAbs_C0, /*IsBound=*/Standard_True);
        } else {
            filling.Add(side.edge, side.face, side.constraint, /*IsBound=*/Standard_True);
        }
    }
    for (const gp_Pnt& point : request.through) {
        filling.Add(point);
    }
    filling.Build();
    if (!filling.IsDone() || filling.Shape().IsNull()) {
        return fail(ErrorCode::Refused, "OCCT's filling found no surface");
    }
    TopExp_Explorer it(filling.Shape(), TopAbs_FACE);
    if (!it.More()) {
        return fail(ErrorCode::Refused, "OCCT's filling made no face");
    }
    const BRep_Builder builder;
    TopoDS_Compound made;
    builder.MakeCompound(made);
    builder.Add(made, it.Current());
    for (const PlateSide& side : request.sides) {
        const auto& copies = filling.Generated(side.edge.Oriented(TopAbs_FORWARD));
        if (copies.IsEmpty()) {
            return fail(ErrorCode::Refused, "OCCT's filling lost {}", side.name);
        }
        builder.Add(made, copies.First());
    }
    return packed(made);
}

}  // namespace
}  // namespace suture

int main() {
    return suture::occ::serve("OCCT's filling", [](const std::string& request) {
        return suture::make_plate(suture::unpacked_request(request));
    });
}

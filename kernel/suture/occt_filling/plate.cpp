#include "suture/occt_filling/plate.h"

#include "suture/occ/convert.h"
#include "suture/occ/guard.h"
#include "suture/occ/isolate.h"
#include "suture/occt_filling/filling_request.h"
#include "suture/occt_filling/invert.h"
#include "suture/platform/on_demand.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomConvert.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <memory>

namespace suture {
namespace {

PlateArguments arguments_of(PlateSetting setting) {
    PlateArguments arguments;
    if (setting == PlateSetting::Tuned) {
        arguments.energy_degree = 4;
        arguments.tolerance_3d = 1e-6;
        arguments.highest_degree = 14;
        arguments.most_segments = 40;
    }
    return arguments;
}

/// OCCT's constraint for a continuity. GeomAbs_C1 would silently mean C0 in Debian's 7.6.3, and
/// GeomAbs_G2 comes out worse than GeomAbs_G1 in position and angle, so G2 is asked for as G1.
GeomAbs_Shape constraint(Continuity continuity) {
    return continuity == Continuity::G0 ? GeomAbs_C0 : GeomAbs_G1;
}

PlateRequest request_of(const BoundaryLoop& loop, const RibbonLoop& ribbons,
                        const std::vector<ThroughPoint>& through, PlateSetting setting) {
    PlateRequest request;
    request.arguments = arguments_of(setting);
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
        const Ribbon& ribbon = ribbons.ribbons[i];
        // OCCT is tangent to faces that have the edge.
        const bool leans = !loop.edges[i].support.IsNull();
        request.sides.push_back({loop.edges[i].edge, loop.edges[i].face,
                                 leans ? GeomAbs_C0 : constraint(ribbon.continuity),
                                 name_of(ribbon)});
    }
    for (const ThroughPoint& point : through) {
        request.through.push_back(occ::to_point(point.point));
    }
    return request;
}

/// OCCT's surface, trimmed where its own curves run or, better, where it is nearest to the sides.
Result<Patch> patch_of(const TopoDS_Shape& made, const RibbonLoop& loop) {
    TopoDS_Iterator next(made);
    const TopoDS_Face face = TopoDS::Face(next.Value());
    const auto converted = GeomConvert::SurfaceToBSplineSurface(BRep_Tool::Surface(face));
    const auto closed = occ::from_occ(occ::Handle<Geom_Surface>(converted));
    const auto surface =
        std::make_shared<const SplineSurface>(std::get<SplineSurface>(closed.value().surface));
    std::vector<TrimCurve> guesses;
    for (const Ribbon& ribbon : loop.ribbons) {
        next.Next();
        double first = 0.0;
        double last = 0.0;
        const occ::Handle<Geom2d_Curve> curve =
            BRep_Tool::CurveOnSurface(TopoDS::Edge(next.Value()), face, first, last);
        if (curve.IsNull()) {
            return fail(ErrorCode::Refused, "OCCT's filling has no curve for {}", name_of(ribbon));
        }
        guesses.emplace_back([curve, start = ribbon.first, end = ribbon.last](double s) {
            return occ::from_occ(curve->Value(start + (end - start) * s));
        });
    }
    Patch patch;
    patch.surface = *surface;
    patch.exact = false;
    std::vector<TrimCurve> trims = invert_boundary(surface, loop, guesses);
    patch.reversed = signed_area(trims) < 0.0;
    patch.wires.push_back(wire_of_loop(0, std::move(trims)));
    return patch;
}

}  // namespace

Result<FillResult> fill_with_plate(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                                   PlateSetting setting, std::chrono::milliseconds limit,
                                   const Progress& progress) {
    if (loops.size() != 1) {
        return fail(ErrorCode::Refused,
                    "OCCT's filling takes one loop, and this hole has {}: it would close the wrong "
                    "one",
                    loops.size());
    }
    if (any_normal(hole.through)) {
        return fail(ErrorCode::Refused, "OCCT's filling takes points, but no normals at them");
    }
    static const std::string program = program_on_demand("suture_occt_filling");
    const auto bytes = occ::run_isolated(
        "OCCT's filling", program,
        packed(request_of(loops.front(), hole.loops.front(), hole.through, setting)), limit,
        progress);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    auto patch = occ::guarded("OCCT's filling",
                              [&] { return patch_of(unpacked_shape(*bytes), hole.loops.front()); });
    if (!patch) {
        return tl::unexpected(patch.error());
    }
    FillResult result;
    result.patches.push_back(std::move(*patch));
    for (const Ribbon& ribbon : hole.loops.front().ribbons) {
        if (ribbon.continuity == Continuity::G2) {
            result.notes.emplace_back(
                "OCCT's G2 constraints come out worse than its G1: G1 was asked for");
            break;
        }
    }
    return result;
}

}  // namespace suture

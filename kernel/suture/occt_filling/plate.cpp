#include "suture/occt_filling/plate.h"

#include "suture/base/on_demand.h"
#include "suture/occ/convert.h"
#include "suture/occ/guard.h"
#include "suture/occ/isolate.h"
#include "suture/occt_filling/filling_module.h"
#include "suture/occt_filling/invert.h"

#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomConvert.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>

#include <memory>
#include <sstream>

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

/// OCCT's face, and after it the loop's edges as OCCT copied them, with their curves on the face.
Result<TopoDS_Compound> run_filling(const BoundaryLoop& loop, const RibbonLoop& ribbons,
                                    const std::vector<Eigen::Vector3d>& through,
                                    const PlateArguments& arguments) {
    std::vector<PlateSide> sides;
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
        sides.push_back(
            {loop.edges[i].edge, loop.edges[i].face, constraint(ribbons.ribbons[i].continuity)});
    }
    std::vector<gp_Pnt> points;
    points.reserve(through.size());
    for (const Eigen::Vector3d& point : through) {
        points.push_back(occ::to_point(point));
    }
    static MakePlate* const make_plate = *static_cast<MakePlate* const*>(
        symbol_on_demand("suture_occt_filling.so", "suture_make_plate"));
    MadePlate made = make_plate(sides, points, arguments);
    switch (made.outcome) {
        case MadePlate::Outcome::NoSurface:
            return fail(ErrorCode::Refused, "OCCT's filling found no surface");
        case MadePlate::Outcome::NoFace:
            return fail(ErrorCode::Refused, "OCCT's filling made no face");
        case MadePlate::Outcome::LostEdge:
            return fail(ErrorCode::Refused, "OCCT's filling lost {}",
                        name_of(ribbons.ribbons[made.lost]));
        case MadePlate::Outcome::Done:
            break;
    }
    return std::move(made.shape);
}

std::string packed(const TopoDS_Shape& shape) {
    std::ostringstream bytes;
    BinTools::Write(shape, bytes);
    return bytes.str();
}

TopoDS_Shape unpacked(const std::string& bytes) {
    std::istringstream stream(bytes);
    TopoDS_Shape shape;
    BinTools::Read(shape, stream);
    return shape;
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
    patch.trims.push_back(invert_boundary(surface, loop, guesses));
    patch.reversed = signed_area(patch.trims.front()) < 0.0;
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
    const auto bytes = occ::run_isolated(
        "OCCT's filling",
        [&]() -> Result<std::string> {
            const auto made =
                run_filling(loops.front(), hole.loops.front(), hole.through, arguments_of(setting));
            return made ? Result<std::string>(packed(*made)) : tl::unexpected(made.error());
        },
        limit, progress);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    auto patch = occ::guarded("OCCT's filling",
                              [&] { return patch_of(unpacked(*bytes), hole.loops.front()); });
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

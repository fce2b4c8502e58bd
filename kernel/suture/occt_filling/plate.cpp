#include "suture/occt_filling/plate.h"

#include "suture/occ/convert.h"
#include "suture/occ/guard.h"
#include "suture/occ/isolate.h"
#include "suture/occt_filling/invert.h"

#include <Eigen/Geometry>

#include <BRepOffsetAPI_MakeFilling.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cstring>
#include <memory>

namespace suture {
namespace {

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

Result<TopoDS_Face> run_filling(const BoundaryLoop& loop, const RibbonLoop& ribbons,
                                const PlateArguments& a) {
    BRepOffsetAPI_MakeFilling filling(a.energy_degree, a.points_on_curve, a.iterations,
                                      a.anisotropic, a.tolerance_2d, a.tolerance_3d,
                                      a.tolerance_angular, a.tolerance_curvature, a.highest_degree,
                                      a.most_segments);
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
        filling.Add(loop.edges[i].edge, loop.edges[i].face,
                    constraint(ribbons.ribbons[i].continuity), /*IsBound=*/Standard_True);
    }
    filling.Build();
    if (!filling.IsDone() || filling.Shape().IsNull()) {
        return fail(ErrorCode::Refused, "OCCT's filling found no surface");
    }
    TopExp_Explorer it(filling.Shape(), TopAbs_FACE);
    if (!it.More()) {
        return fail(ErrorCode::Refused, "OCCT's filling made no face");
    }
    return TopoDS::Face(it.Current());
}

// The child's answer: degrees, counts, knots, poles and weights as raw numbers of this machine.

void append(std::string& bytes, const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
}

std::string packed(const SplineSurface& spline) {
    const std::int64_t head[] = {spline.degree_u, spline.degree_v, spline.count_u(),
                                 spline.count_v(), spline.weights.size()};
    std::string bytes;
    append(bytes, head, sizeof(head));
    append(bytes, spline.knots_u.data(), spline.knots_u.size() * sizeof(double));
    append(bytes, spline.knots_v.data(), spline.knots_v.size() * sizeof(double));
    const auto count = [](Eigen::Index n) { return static_cast<std::size_t>(n) * sizeof(double); };
    append(bytes, spline.poles.data(), count(spline.poles.size()));
    append(bytes, spline.weights.data(), count(spline.weights.size()));
    return bytes;
}

SplineSurface unpacked(const std::string& bytes) {
    const char* next = bytes.data();
    const auto take = [&](void* target, std::size_t size) {
        SUTURE_EXPECTS(next + size <= bytes.data() + bytes.size());
        std::memcpy(target, next, size);
        next += size;
    };
    std::int64_t head[5];
    take(head, sizeof(head));
    SplineSurface spline;
    spline.degree_u = static_cast<int>(head[0]);
    spline.degree_v = static_cast<int>(head[1]);
    spline.knots_u.resize(static_cast<std::size_t>(head[0] + head[2] + 1));
    spline.knots_v.resize(static_cast<std::size_t>(head[1] + head[3] + 1));
    spline.poles.resize(3, head[2] * head[3]);
    spline.weights.resize(head[4]);
    take(spline.knots_u.data(), spline.knots_u.size() * sizeof(double));
    take(spline.knots_v.data(), spline.knots_v.size() * sizeof(double));
    take(spline.poles.data(), static_cast<std::size_t>(spline.poles.size()) * sizeof(double));
    take(spline.weights.data(), static_cast<std::size_t>(spline.weights.size()) * sizeof(double));
    return spline;
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
            auto face = run_filling(loops.front(), hole.loops.front(), arguments_of(setting));
            if (!face) {
                return tl::unexpected(face.error());
            }
            const auto surface = GeomConvert::SurfaceToBSplineSurface(BRep_Tool::Surface(*face));
            const auto closed = occ::from_occ(occ::Handle<Geom_Surface>(surface));
            return packed(std::get<SplineSurface>(closed.value().surface));
        },
        limit, progress);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    Patch patch;
    const auto spline = std::make_shared<const SplineSurface>(unpacked(*bytes));
    patch.surface = *spline;
    patch.exact = false;
    patch.trims = invert_boundary(spline, hole);
    patch.reversed = signed_area(patch.trims.front()) < 0.0;
    FillResult result;
    result.patches.push_back(std::move(patch));
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

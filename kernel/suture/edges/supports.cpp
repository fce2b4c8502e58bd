#include "suture/edges/supports.h"

#include "suture/edges/walk.h"
#include "suture/occ/convert.h"

#include <Eigen/Geometry>

#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector3d;

/// Points of an edge to see how it lies on its support.
constexpr int kSamples = 16;

/// How far beside the edge it is seen whether the support is there, as a share of its length.
constexpr double kBeside = 1e-3;

/// A support that leans against the opening by less than this, as a cosine, stands across it.
constexpr double kAcross = 0.1;

/// Turns supports to the sides of one border.
class SupportFinder {
  public:
    SupportFinder(const Vector3d& opening, double reach)
        : opening_(opening.normalized()), reach_(reach) {}

    /// The support with the orientation in which the border is walked with the new face on the
    /// left: beyond the support's own end, or, inside of it, counterclockwise.
    [[nodiscard]] Result<TopoDS_Face> facing(const BoundaryEdge& side, const TopoDS_Face& support,
                                             int number) const {
        const occ::Handle<Geom_Surface> surface = BRep_Tool::Surface(support);
        BRepTopAdaptor_FClass2d inside(support, Precision::PConfusion());
        const auto is_there = [&](const Vector3d& point) {
            return inside.Perform(foot_of(point, surface).uv) == TopAbs_IN ? 1 : 0;
        };
        const double beside = std::max(kBeside * length_of(side), 2.0 * reach_);
        int left = 0;
        int right = 0;
        double agree = 0.0;
        for (int k = 0; k <= kSamples; ++k) {
            const auto [point, along] = walk_to(side.edge, static_cast<double>(k) / kSamples);
            const SurfaceFoot foot = foot_of(point, surface);
            if (foot.apart > reach_) {
                return fail(ErrorCode::Usage,
                            "edge {} does not lie on face {}: it is {:.3g} away, more than {:.3g}",
                            side.edge_number, number, foot.apart, reach_);
            }
            const Vector3d aside = beside * foot.normal.cross(along.normalized());
            left += is_there(point + aside);
            right += is_there(point - aside);
            agree += foot.normal.dot(opening_) / (kSamples + 1);
        }
        const int most = kSamples / 2;
        const bool ends_here = (left > most) != (right > most);
        if (!ends_here && std::abs(agree) < kAcross) {
            return fail(ErrorCode::Usage,
                        "edge {} runs inside face {}, which stands across the opening: on which "
                        "side of the edge the new face lies cannot be told",
                        side.edge_number, number);
        }
        const bool as_it_is = ends_here ? right > left : agree > 0.0;
        return TopoDS::Face(support.Oriented(as_it_is ? TopAbs_FORWARD : TopAbs_REVERSED));
    }

  private:
    static double length_of(const BoundaryEdge& side) {
        double length = 0.0;
        Vector3d before = walk_to(side.edge, 0.0).first;
        for (int k = 1; k <= kSamples; ++k) {
            const Vector3d here = walk_to(side.edge, static_cast<double>(k) / kSamples).first;
            length += (here - before).norm();
            before = here;
        }
        return length;
    }

    Vector3d opening_;
    double reach_;
};

}  // namespace

SurfaceFoot foot_of(const Vector3d& point, const occ::Handle<Geom_Surface>& surface) {
    SurfaceFoot foot;
    GeomAPI_ProjectPointOnSurf nearest(occ::to_point(point), surface);
    if (nearest.NbPoints() == 0) {
        return foot;
    }
    foot.apart = nearest.LowerDistance();
    double u = 0.0;
    double v = 0.0;
    nearest.LowerDistanceParameters(u, v);
    foot.uv = gp_Pnt2d(u, v);
    gp_Pnt p;
    gp_Vec along_u;
    gp_Vec along_v;
    surface->D1(u, v, p, along_u, along_v);
    foot.normal = occ::from_occ(along_u).cross(occ::from_occ(along_v)).normalized();
    return foot;
}

Result<void> lean_on_supports(const occ::Numbering& numbering, const std::map<int, int>& supports,
                              double reach, std::vector<BoundaryLoop>& loops) {
    if (supports.empty()) {
        return {};
    }
    const SupportFinder finder(area_of(loops.front()), reach);
    for (BoundaryLoop& loop : loops) {
        for (BoundaryEdge& side : loop.edges) {
            const auto wanted = supports.find(side.edge_number);
            if (wanted == supports.end()) {
                continue;
            }
            const int number = wanted->second;
            if (number > numbering.faces.Extent()) {
                return fail(ErrorCode::Usage, "there is no face {}: the model has {} faces", number,
                            numbering.faces.Extent());
            }
            auto support = finder.facing(side, TopoDS::Face(numbering.faces(number)), number);
            if (!support) {
                return tl::unexpected(support.error());
            }
            side.support = *support;
            side.support_number = number;
        }
    }
    return {};
}

}  // namespace suture

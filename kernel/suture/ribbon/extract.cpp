#include "suture/ribbon/extract.h"

#include "suture/base/tolerance.h"
#include "suture/occ/convert.h"
#include "suture/occ/guard.h"
#include "suture/ribbon/free_side.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomProjLib.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <cmath>
#include <memory>
namespace suture {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// |X_u x X_v| below this fraction of |X_u| |X_v|, or a derivative below this fraction of the
/// larger one times the parameter's size, is a singular parametrisation: a pole or an apex. The
/// normal is then taken a little way along the side.
constexpr double kSingular = 1e-9;

/// How far along the side, in s: far enough for a safe cross product, near enough for the normal's
/// limit to six digits on any surface that has one.
constexpr double kNudge = 1e-7;

/// Newton steps from the pcurve's point to the foot of the edge's point. Files keep the two within
/// the edge's tolerance, so two steps reach rounding error; more are for bad pcurves.
constexpr int kFootSteps = 4;

/// The neighbour's geometry along one edge. Plain Geom objects, not adaptors: those cache the last
/// span and could not be shared between threads.
struct Side {
    occ::Handle<Geom_Curve> curve;
    occ::Handle<Geom2d_Curve> pcurve;
    occ::Handle<Geom_Surface> surface;
    double t0 = 0.0, t1 = 1.0;  ///< curve's range in walking direction
    double p0 = 0.0, p1 = 1.0;  ///< pcurve's range in walking direction
    double normal_sign = 1.0;   ///< outward = sign * X_u x X_v

    [[nodiscard]] Vector2d uv(double s) const {
        return occ::from_occ(pcurve->Value(p0 + (p1 - p0) * s));
    }
};

SurfaceJet jet_at(const Geom_Surface& surface, const Vector2d& uv) {
    gp_Pnt p;
    gp_Vec u, v, uu, vv, mixed;
    surface.D2(uv.x(), uv.y(), p, u, v, uu, vv, mixed);
    return {occ::from_occ(p),  occ::from_occ(u),     occ::from_occ(v),
            occ::from_occ(uu), occ::from_occ(mixed), occ::from_occ(vv)};
}

bool singular(const SurfaceJet& jet, const Vector2d& extent) {
    const double a = jet.u.norm() * extent.x();
    const double b = jet.v.norm() * extent.y();
    return std::min(a, b) <= kSingular * std::max(a, b) ||
           jet.u.cross(jet.v).norm() <= kSingular * jet.u.norm() * jet.v.norm();
}

/// Newton for the point of the surface nearest to `target`, from uv; stays at uv where it would
/// move away.
Vector2d foot(const Geom_Surface& surface, const Vector3d& target, const Vector2d& start) {
    Vector2d best = start;
    Vector2d uv = start;
    double best_distance = INFINITY;
    for (int step = 0; step <= kFootSteps; ++step) {
        const SurfaceJet jet = jet_at(surface, uv);
        const Vector3d d = jet.point - target;
        if (d.norm() >= best_distance) {
            break;
        }
        best_distance = d.norm();
        best = uv;
        Matrix2d H;
        H << jet.u.dot(jet.u) + d.dot(jet.uu), jet.u.dot(jet.v) + d.dot(jet.uv),
            jet.u.dot(jet.v) + d.dot(jet.uv), jet.v.dot(jet.v) + d.dot(jet.vv);
        const double scale = H.diagonal().cwiseAbs().prod();
        if (std::abs(H.determinant()) <= kSingular * scale) {
            break;
        }
        uv -= H.inverse() * Vector2d(jet.u.dot(d), jet.v.dot(d));
    }
    return best;
}

/// The second fundamental form as a 3 x 3 matrix: J I^-1 II I^-1 J^T.
Matrix3d form_of(const SurfaceJet& jet, const Vector3d& normal) {
    Eigen::Matrix<double, 3, 2> J;
    J << jet.u, jet.v;
    Matrix2d II;
    II << normal.dot(jet.uu), normal.dot(jet.uv), normal.dot(jet.uv), normal.dot(jet.vv);
    const Eigen::Matrix<double, 3, 2> dual = J * (J.transpose() * J).inverse();
    return dual * II * dual.transpose();
}

/// A jet of the neighbour near s where its parametrisation is regular.
SurfaceJet regular_jet(const Side& side, double s, const Vector2d& extent, SurfaceJet jet) {
    for (double step = kNudge; singular(jet, extent) && step < 1e-2; step *= 10.0) {
        const Vector2d towards = side.uv(s < 0.5 ? s + step : s - step);
        jet = jet_at(*side.surface, towards);
    }
    return jet;
}

RibbonPoint evaluate(const Side& side, const Vector2d& extent, double s) {
    gp_Pnt p;
    gp_Vec d;
    side.curve->D1(side.t0 + (side.t1 - side.t0) * s, p, d);
    const Vector3d on_edge = occ::from_occ(p);
    const Vector2d uv = foot(*side.surface, on_edge, side.uv(s));
    const SurfaceJet here = jet_at(*side.surface, uv);
    const SurfaceJet jet = regular_jet(side, s, extent, here);
    RibbonPoint result;
    result.point = here.point;
    result.normal = side.normal_sign * jet.u.cross(jet.v).normalized();
    const Vector3d along = (side.t1 - side.t0) * occ::from_occ(d);
    result.tangent = along - result.normal * result.normal.dot(along);
    result.inward = result.normal.cross(result.tangent).normalized();
    result.curvature = form_of(jet, result.normal);
    return result;
}

Vector2d extent_of(const Side& side) {
    Vector2d low = side.uv(0.0);
    Vector2d high = low;
    constexpr int kSamples = 8;
    for (int i = 1; i <= kSamples; ++i) {
        const Vector2d uv = side.uv(static_cast<double>(i) / kSamples);
        low = low.cwiseMin(uv);
        high = high.cwiseMax(uv);
    }
    const double size = (high - low).maxCoeff();
    return Vector2d::Constant(size > 0.0 ? size : 1.0);
}

Result<Side> side_of(const BoundaryEdge& boundary) {
    Side side;
    double first = 0.0;
    double last = 0.0;
    side.curve = BRep_Tool::Curve(boundary.edge, first, last);
    if (side.curve.IsNull() || !(last > first)) {
        return fail(ErrorCode::Refused, "edge {} (face {}) has no 3D curve", boundary.edge_number,
                    boundary.face_number);
    }
    double pfirst = 0.0;
    double plast = 0.0;
    const bool leans = !boundary.support.IsNull();
    const TopoDS_Face face = leans ? boundary.support : boundary.face;
    const int face_number = leans ? boundary.support_number : boundary.face_number;
    side.surface = BRep_Tool::Surface(face);
    if (side.surface.IsNull()) {
        return fail(ErrorCode::Refused, "face {} has no surface", face_number);
    }
    if (leans) {
        pfirst = first;
        plast = last;
        side.pcurve = GeomProjLib::Curve2d(side.curve, first, last, side.surface);
    } else {
        // As the face uses the edge, since on a shared seam the two directions have two pcurves.
        const TopoDS_Edge used = TopoDS::Edge(boundary.edge.Reversed());
        side.pcurve = BRep_Tool::CurveOnSurface(used, face, pfirst, plast);
    }
    if (side.pcurve.IsNull()) {
        return fail(ErrorCode::Refused, "edge {} has no curve on the surface of face {}",
                    boundary.edge_number, face_number);
    }
    const bool backwards = boundary.edge.Orientation() == TopAbs_REVERSED;
    side.t0 = backwards ? last : first;
    side.t1 = backwards ? first : last;
    side.p0 = backwards ? plast : pfirst;
    side.p1 = backwards ? pfirst : plast;
    // Also under a location that mirrors: there the loops go the other way round as X_u x X_v does,
    // and the hole stays on their left.
    side.normal_sign = face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    return side;
}

std::optional<Support> support_of(const std::shared_ptr<const Side>& side) {
    const auto closed = occ::from_occ(side->surface);
    if (!closed) {
        return std::nullopt;
    }
    Support support;
    support.surface = closed->surface;
    const Vector2d sign = closed->sign;
    support.uv = [side, sign](double s) -> Vector2d { return side->uv(s).cwiseProduct(sign); };
    // A sign of -1 in one of u, v turns our X_u x X_v around against OCCT's.
    support.reversed = side->normal_sign * sign.prod() < 0.0;
    return support;
}

Result<Ribbon> ribbon_of(const BoundaryEdge& boundary) {
    auto extracted = side_of(boundary);
    if (!extracted) {
        return tl::unexpected(extracted.error());
    }
    const auto side = std::make_shared<const Side>(std::move(*extracted));
    const Vector2d extent = extent_of(*side);
    Ribbon ribbon;
    ribbon.at = [side, extent](double s) { return evaluate(*side, extent, s); };
    ribbon.support = support_of(side);
    ribbon.curve = occ::spline_of(side->curve, side->t0, side->t1);
    ribbon.edge = boundary.edge_number;
    ribbon.face = boundary.support.IsNull() ? boundary.face_number : boundary.support_number;
    ribbon.first = side->t0;
    ribbon.last = side->t1;
    return ribbon;
}

/// Samples per side for the size of a hole and for finding a side without length.
constexpr int kBoxSamples = 16;

struct Box {
    Vector3d low = Vector3d::Constant(INFINITY);
    Vector3d high = Vector3d::Constant(-INFINITY);
    void add(const Vector3d& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
};

Result<void> measure(const Ribbon& ribbon, Box& box) {
    double length = 0.0;
    Vector3d previous = ribbon.at(0.0).point;
    for (int i = 0; i <= kBoxSamples; ++i) {
        const RibbonPoint point = ribbon.at(static_cast<double>(i) / kBoxSamples);
        if (!point.point.allFinite() || !(point.normal.squaredNorm() > 0.5) ||
            !point.curvature.allFinite()) {
            return fail(ErrorCode::Refused, "{}: the neighbour has no normal at s = {:.3f}",
                        name_of(ribbon), static_cast<double>(i) / kBoxSamples);
        }
        box.add(point.point);
        length += (point.point - previous).norm();
        previous = point.point;
    }
    if (!(length > 0.0)) {
        return fail(ErrorCode::Refused, "{} has no length", name_of(ribbon));
    }
    return {};
}

/// Twice the area that a loop encloses, as a vector along its outward side.
Vector3d area_vector(const RibbonLoop& loop) {
    const Vector3d origin = loop.ribbons.front().at(0.0).point;
    Vector3d area = Vector3d::Zero();
    for (const Ribbon& ribbon : loop.ribbons) {
        for (int k = 0; k < kBoxSamples; ++k) {
            const Vector3d a = ribbon.at(static_cast<double>(k) / kBoxSamples).point - origin;
            const Vector3d b = ribbon.at(static_cast<double>(k + 1) / kBoxSamples).point - origin;
            area += a.cross(b);
        }
    }
    return area;
}

bool is_free(const BoundaryEdge& edge) {
    return edge.face.IsNull() && edge.support.IsNull();
}

/// The ribbons of a loop; those of curves without a face as yet without normals.
Result<RibbonLoop> ribbons_of(const BoundaryLoop& loop) {
    RibbonLoop ribbons;
    for (const BoundaryEdge& edge : loop.edges) {
        auto ribbon = is_free(edge) ? free_ribbon(edge) : ribbon_of(edge);
        if (!ribbon) {
            return tl::unexpected(ribbon.error());
        }
        ribbons.ribbons.push_back(std::move(*ribbon));
    }
    return ribbons;
}

void complete(const BoundaryLoop& loop, const Vector3d& opening, RibbonLoop& ribbons) {
    std::vector<bool> faceless;
    for (const BoundaryEdge& edge : loop.edges) {
        faceless.push_back(is_free(edge));
    }
    if (std::find(faceless.begin(), faceless.end(), true) != faceless.end()) {
        set_free_normals(faceless, opening, ribbons.ribbons);
    }
}

Result<Hole> extract(const std::vector<BoundaryLoop>& loops) {
    Hole hole;
    Box box;
    for (const BoundaryLoop& loop : loops) {
        auto ribbons = ribbons_of(loop);
        if (!ribbons) {
            return tl::unexpected(ribbons.error());
        }
        hole.loops.push_back(std::move(*ribbons));
        complete(loop, area_vector(hole.loops.front()), hole.loops.back());
        for (const Ribbon& ribbon : hole.loops.back().ribbons) {
            if (auto measured = measure(ribbon, box); !measured) {
                return tl::unexpected(measured.error());
            }
        }
        for (const BoundaryEdge& edge : loop.edges) {
            hole.tolerance = std::max(hole.tolerance, BRep_Tool::Tolerance(edge.edge));
        }
    }
    hole.diameter = (box.high - box.low).norm();
    return hole;
}

/// The angle by which the loop turns left at a corner, in (-pi, pi]. Left is seen against the
/// neighbours' mean normal, or, where these stand across the loop (the walls of a box), against the
/// side on which the whole loop is walked counterclockwise.
double turning(const RibbonPoint& a, const RibbonPoint& b, const Vector3d& overall) {
    const Vector3d axis = a.tangent.cross(b.tangent);
    const double angle = std::atan2(axis.norm(), a.tangent.dot(b.tangent));
    const double local = axis.dot((a.normal + b.normal).normalized());
    const double global = axis.dot(overall.normalized());
    const double left = std::abs(local) >= std::abs(global) ? local : global;
    return left < 0.0 ? -angle : angle;
}

}  // namespace

Result<Hole> extract_hole(const std::vector<BoundaryLoop>& loops) {
    return occ::guarded("reading the hole's neighbours", [&] { return extract(loops); });
}

std::vector<Corner> corners_of(const RibbonLoop& loop) {
    const Vector3d overall = area_vector(loop);
    std::vector<Corner> corners;
    const std::size_t n = loop.ribbons.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Ribbon& before = loop.ribbons[(i + n - 1) % n];
        const Ribbon& after = loop.ribbons[i];
        const RibbonPoint a = before.at(1.0);
        const RibbonPoint b = after.at(0.0);
        Corner corner;
        corner.point = 0.5 * (a.point + b.point);
        corner.angle = kPi - turning(a, b, overall);
        corner.normal_mismatch =
            std::atan2(a.normal.cross(b.normal).norm(), a.normal.dot(b.normal));
        corner.face_before = before.face;
        corner.face_after = after.face;
        corners.push_back(corner);
    }
    return corners;
}

}  // namespace suture

#include "suture/ribbon/free_side.h"

#include "suture/occ/convert.h"

#include <Eigen/Geometry>

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>

#include <algorithm>
#include <cmath>
#include <memory>

namespace suture {
namespace {

using Eigen::Vector3d;

/// Normals are carried along a side in so many steps; between them they are blended.
constexpr int kSteps = 64;

/// A normal that leans on the curve's direction by more than this (cosine) says nothing there.
constexpr double kAlong = 0.99;

/// The part of n at right angles to a direction.
Vector3d across(const Vector3d& n, const Vector3d& tangent) {
    const Vector3d t = tangent.normalized();
    return n - t * t.dot(n);
}

bool leans_along(const Vector3d& n, const Vector3d& tangent) {
    return std::abs(n.normalized().dot(tangent.normalized())) > kAlong;
}

/// A normal carried from one point of a curve to the next without turning about it (double
/// reflection: Wang, Juettler, Zheng, Liu, Computation of rotation minimizing frames, 2008).
Vector3d carried(const Vector3d& n, const RibbonPoint& from, const RibbonPoint& to) {
    const Vector3d step = to.point - from.point;
    if (!(step.squaredNorm() > 0.0)) {
        return across(n, to.tangent).normalized();
    }
    const auto reflected = [](const Vector3d& v, const Vector3d& axis) -> Vector3d {
        return axis.squaredNorm() > 0.0 ? v - 2.0 * axis.dot(v) / axis.squaredNorm() * axis : v;
    };
    const Vector3d tangent = reflected(from.tangent.normalized(), step);
    return across(reflected(reflected(n, step), to.tangent.normalized() - tangent), to.tangent)
        .normalized();
}

/// The normals along a run of sides without a face, kSteps + 1 for each.
struct FreeRun {
    std::vector<std::size_t> sides;
    std::vector<RibbonPoint> points;
    std::vector<Vector3d> normals;
};

FreeRun run_of(std::vector<std::size_t> sides, const std::vector<Ribbon>& ribbons) {
    FreeRun run{std::move(sides), {}, {}};
    for (const std::size_t i : run.sides) {
        for (int k = 0; k <= kSteps; ++k) {
            run.points.push_back(ribbons[i].at(static_cast<double>(k) / kSteps));
        }
    }
    return run;
}

/// Carries a normal along the whole run.
void carry(const Vector3d& start, FreeRun& run) {
    Vector3d n = across(start, run.points.front().tangent).normalized();
    run.normals.assign(1, n);
    for (std::size_t k = 1; k < run.points.size(); ++k) {
        n = carried(n, run.points[k - 1], run.points[k]);
        run.normals.push_back(n);
    }
}

/// Turns the normals evenly about the curve, so that the last one is that of the next neighbour.
void twist(const Vector3d& end, FreeRun& run) {
    const Vector3d t = run.points.back().tangent.normalized();
    const Vector3d wanted = across(end, t).normalized();
    const Vector3d& last = run.normals.back();
    const double angle = std::atan2(t.dot(last.cross(wanted)), last.dot(wanted));
    const double count = static_cast<double>(run.points.size() - 1);
    for (std::size_t k = 0; k < run.points.size(); ++k) {
        const Eigen::AngleAxisd turn(angle * static_cast<double>(k) / count,
                                     run.points[k].tangent.normalized());
        run.normals[k] = turn * run.normals[k];
    }
}

/// The opening's own normal, carried on where the curve runs along it.
void face_opening(const Vector3d& opening, FreeRun& run) {
    Vector3d n = across(opening, run.points.front().tangent).normalized();
    if (!n.allFinite()) {
        n = run.points.front().tangent.unitOrthogonal();
    }
    for (std::size_t k = 0; k < run.points.size(); ++k) {
        if (!leans_along(opening, run.points[k].tangent)) {
            n = across(opening, run.points[k].tangent).normalized();
        } else if (k > 0) {
            n = carried(n, run.points[k - 1], run.points[k]);
        }
        run.normals.push_back(n);
    }
}

void set_normals(const FreeRun& run, std::vector<Ribbon>& ribbons) {
    for (std::size_t i = 0; i < run.sides.size(); ++i) {
        const auto begin = run.normals.begin() + static_cast<std::ptrdiff_t>(i * (kSteps + 1));
        const auto normals =
            std::make_shared<const std::vector<Vector3d>>(begin, begin + (kSteps + 1));
        Ribbon& ribbon = ribbons[run.sides[i]];
        ribbon.at = [bare = ribbon.at, normals](double s) {
            RibbonPoint result = bare(s);
            const double at = std::clamp(s, 0.0, 1.0) * kSteps;
            const auto k = static_cast<std::size_t>(std::min(std::floor(at), kSteps - 1.0));
            const double part = at - static_cast<double>(k);
            const Vector3d n = (1.0 - part) * (*normals)[k] + part * (*normals)[k + 1];
            result.normal = across(n, result.tangent).normalized();
            result.inward = result.normal.cross(result.tangent).normalized();
            return result;
        };
    }
}

/// The runs of neighbouring sides without a face, around a loop that has another side as well.
std::vector<std::vector<std::size_t>> runs_of(const std::vector<bool>& faceless) {
    const std::size_t n = faceless.size();
    const std::size_t start =
        static_cast<std::size_t>(std::ranges::find(faceless, false) - faceless.begin());
    std::vector<std::vector<std::size_t>> runs;
    for (std::size_t k = 1; k < n; ++k) {
        const std::size_t i = (start + k) % n;
        if (!faceless[i]) {
            continue;
        }
        if (!faceless[(i + n - 1) % n]) {
            runs.emplace_back();
        }
        runs.back().push_back(i);
    }
    return runs;
}

}  // namespace

Result<Ribbon> free_ribbon(const BoundaryEdge& boundary) {
    double first = 0.0;
    double last = 0.0;
    const occ::Handle<Geom_Curve> curve = BRep_Tool::Curve(boundary.edge, first, last);
    if (curve.IsNull() || !(last > first)) {
        return fail(ErrorCode::Refused, "edge {} has no 3D curve", boundary.edge_number);
    }
    const bool backwards = boundary.edge.Orientation() == TopAbs_REVERSED;
    Ribbon ribbon;
    ribbon.first = backwards ? last : first;
    ribbon.last = backwards ? first : last;
    ribbon.edge = boundary.edge_number;
    ribbon.curve = occ::spline_of(curve, ribbon.first, ribbon.last);
    ribbon.at = [curve, t0 = ribbon.first, t1 = ribbon.last](double s) {
        gp_Pnt p;
        gp_Vec d;
        curve->D1(t0 + (t1 - t0) * s, p, d);
        RibbonPoint result;
        result.point = occ::from_occ(p);
        result.tangent = (t1 - t0) * occ::from_occ(d);
        result.normal = result.inward = Vector3d::Zero();
        result.curvature.setZero();
        return result;
    };
    return ribbon;
}

void set_free_normals(const std::vector<bool>& faceless, const Vector3d& opening,
                      std::vector<Ribbon>& ribbons) {
    const std::size_t n = ribbons.size();
    if (std::ranges::find(faceless, false) == faceless.end()) {
        for (std::size_t i = 0; i < n; ++i) {
            FreeRun run = run_of({i}, ribbons);
            face_opening(opening, run);
            set_normals(run, ribbons);
        }
        return;
    }
    for (std::vector<std::size_t>& sides : runs_of(faceless)) {
        const Vector3d start = ribbons[(sides.front() + n - 1) % n].at(1.0).normal;
        const Vector3d end = ribbons[(sides.back() + 1) % n].at(0.0).normal;
        FreeRun run = run_of(std::move(sides), ribbons);
        if (leans_along(start, run.points.front().tangent) ||
            leans_along(end, run.points.back().tangent)) {
            face_opening(opening, run);
        } else {
            carry(start, run);
            twist(end, run);
        }
        set_normals(run, ribbons);
    }
}

}  // namespace suture

#include "suture/check/crossing.h"

#include <Eigen/Dense>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace suture {

namespace {

constexpr int kEdgePoints = 48;
constexpr int kNewtonSteps = 20;
constexpr int kDoublings = 24;
// Points of both surfaces this near each other, against the size of their coordinates, are one.
constexpr double kSamePoint = 1e-11;
// Of one surface with itself: parameters nearer than this part of what they were at first have run
// together.
constexpr double kRunTogether = 0.25;

Eigen::Vector3d to_eigen(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}

/// Where the segment p q passes the triangle, if it does.
std::optional<Eigen::Vector3d> pierce(const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                                      const std::array<Eigen::Vector3d, 3>& t) {
    const Eigen::Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]);
    const double from = n.dot(p - t[0]);
    const double to = n.dot(q - t[0]);
    if (from * to > 0.0 || from == to) {
        return std::nullopt;
    }
    const Eigen::Vector3d x = p + from / (from - to) * (q - p);
    const double margin = -1e-9 * n.squaredNorm();
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d& a = t.at(k);
        const Eigen::Vector3d& b = t.at((k + 1) % 3);
        if ((b - a).cross(x - a).dot(n) < margin) {
            return std::nullopt;
        }
    }
    return x;
}

/// Signed distances of points of `a` from `b`, from a crossing on in one direction of `a`, as far
/// as both stay inside their faces: the largest.
double reach(const SurfaceTree& a, const SurfaceTree& b, const SurfacePoint& on_a,
             const SurfacePoint& on_b, const Eigen::Vector3d& direction, double step) {
    const auto slope = on_a.parameters_of(direction);
    double farthest = 0.0;
    std::array<double, 2> start = on_b.uv;
    for (int k = 0; k < kDoublings; ++k, step *= 2.0) {
        const std::array<double, 2> uv = {on_a.uv[0] + step * slope[0],
                                          on_a.uv[1] + step * slope[1]};
        if (a.clamped(uv) != uv || !a.contains(uv)) {
            break;
        }
        const Eigen::Vector3d point = a.point(uv[0], uv[1]);
        const auto foot = b.foot(point, start);
        if (!foot || !b.contains(foot->uv)) {
            break;
        }
        const double distance = (point - foot->point).dot(foot->normal());
        if (std::abs(distance) <= std::abs(farthest) || distance * farthest < 0.0) {
            break;
        }
        farthest = distance;
        start = foot->uv;
    }
    return farthest;
}

/// The smaller of how far `a` goes on both sides of `b`; 0 if on one side only.
double depth_of(const SurfaceTree& a, const SurfaceTree& b, const SurfacePoint& on_a,
                const SurfacePoint& on_b, double step) {
    const Eigen::Vector3d n = on_a.normal();
    const Eigen::Vector3d across = n.cross(n.cross(on_b.normal()));
    if (!(across.norm() > 0.0)) {
        return 0.0;
    }
    // A surface that is met at a small angle has to be followed farther.
    const double first = step / across.norm();
    const double one = reach(a, b, on_a, on_b, across.normalized(), first);
    const double two = reach(a, b, on_a, on_b, -across.normalized(), first);
    return one * two < 0.0 ? std::min(std::abs(one), std::abs(two)) : 0.0;
}

}  // namespace

SharedBorder::SharedBorder(const TopoDS_Face& one, const TopoDS_Face& two) {
    if (one.IsSame(two)) {
        TopTools_MapOfShape seen;
        for (TopExp_Explorer it(one, TopAbs_EDGE); it.More(); it.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
            if (BRep_Tool::Degenerated(edge)) {
                add_vertex(TopExp::FirstVertex(edge));
            } else if (!seen.Add(edge)) {
                add_edge(edge);
            }
        }
        return;
    }
    TopTools_IndexedMapOfShape of_two;
    TopExp::MapShapes(two, TopAbs_EDGE, of_two);
    TopExp::MapShapes(two, TopAbs_VERTEX, of_two);
    TopTools_IndexedMapOfShape of_one;
    TopExp::MapShapes(one, TopAbs_EDGE, of_one);
    TopExp::MapShapes(one, TopAbs_VERTEX, of_one);
    for (int i = 1; i <= of_one.Extent(); ++i) {
        const TopoDS_Shape& shape = of_one(i);
        if (!of_two.Contains(shape)) {
            continue;
        }
        if (shape.ShapeType() == TopAbs_VERTEX) {
            add_vertex(shape);
        } else if (!BRep_Tool::Degenerated(TopoDS::Edge(shape))) {
            add_edge(shape);
        }
    }
}

void SharedBorder::add_edge(const TopoDS_Shape& shape) {
    const TopoDS_Edge& edge = TopoDS::Edge(shape);
    Edge& added = edges_.emplace_back();
    added.curve.Initialize(edge);
    added.tolerance = BRep_Tool::Tolerance(edge);
    tolerance_ = std::max(tolerance_, added.tolerance);
    const double first = added.curve.FirstParameter();
    const double last = added.curve.LastParameter();
    for (int i = 0; i <= kEdgePoints; ++i) {
        added.t.push_back(first + (last - first) * i / kEdgePoints);
        added.points.push_back(to_eigen(added.curve.Value(added.t.back())));
        added.box.extend(added.points.back());
        if (i > 0) {
            added.step =
                std::max(added.step, (added.points.back() - *(added.points.end() - 2)).norm());
        }
    }
}

void SharedBorder::add_vertex(const TopoDS_Shape& shape) {
    const TopoDS_Vertex& vertex = TopoDS::Vertex(shape);
    vertices_.push_back({to_eigen(BRep_Tool::Pnt(vertex)), BRep_Tool::Tolerance(vertex)});
    tolerance_ = std::max(tolerance_, vertices_.back().tolerance);
}

bool SharedBorder::is_near(const Eigen::Vector3d& point, double distance) const {
    for (const Vertex& vertex : vertices_) {
        if ((vertex.point - point).norm() <= distance + vertex.tolerance) {
            return true;
        }
    }
    for (const Edge& edge : edges_) {
        const double wanted = distance + edge.tolerance;
        if (edge.box.exteriorDistance(point) > wanted + edge.step) {
            continue;
        }
        for (std::size_t i = 0; i < edge.points.size(); ++i) {
            const double here = (edge.points[i] - point).norm();
            if (here <= wanted) {
                return true;
            }
            if (here > wanted + edge.step) {
                continue;
            }
            double t = edge.t[i];
            for (int step = 0; step < 4; ++step) {
                gp_Pnt p;
                gp_Vec d;
                edge.curve.D1(t, p, d);
                const double speed = d.SquareMagnitude();
                if ((to_eigen(p) - point).norm() <= wanted) {
                    return true;
                }
                const Eigen::Vector3d r = point - to_eigen(p);
                t += speed > 0.0 ? (r.x() * d.X() + r.y() * d.Y() + r.z() * d.Z()) / speed : 0.0;
                t = std::clamp(t, edge.t.front(), edge.t.back());
            }
        }
    }
    return false;
}

std::optional<TriangleMeeting> meeting_of(const std::array<Eigen::Vector3d, 3>& a,
                                          const std::array<Eigen::Vector3d, 3>& b) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t k = 0; k < 3; ++k) {
        if (const auto x = pierce(a.at(k), a.at((k + 1) % 3), b)) {
            points.push_back(*x);
        }
        if (const auto x = pierce(b.at(k), b.at((k + 1) % 3), a)) {
            points.push_back(*x);
        }
    }
    if (points.empty()) {
        return std::nullopt;
    }
    TriangleMeeting result{{points.front(), points.front()}};
    for (const Eigen::Vector3d& p : points) {
        for (const Eigen::Vector3d& q : points) {
            if ((p - q).norm() > (result.ends[1] - result.ends[0]).norm()) {
                result.ends = {p, q};
            }
        }
    }
    return result;
}

std::optional<Crossing> refine_crossing(const SurfaceTree& a, const SurfaceTree& b,
                                        std::array<double, 2> uv_a, std::array<double, 2> uv_b,
                                        double step) {
    const bool same = a.number() == b.number();
    const double apart = std::hypot(uv_a[0] - uv_b[0], uv_a[1] - uv_b[1]);
    SurfacePoint on_a = a.at(uv_a[0], uv_a[1]);
    SurfacePoint on_b = b.at(uv_b[0], uv_b[1]);
    for (int k = 0;; ++k) {
        const Eigen::Vector3d r = on_b.point - on_a.point;
        if (r.norm() <= kSamePoint * on_a.point.cwiseAbs().maxCoeff() + 1e-3 * kSamePoint) {
            break;
        }
        if (k == kNewtonSteps) {
            return std::nullopt;
        }
        // The shortest step in lengths along the four tangents that brings both together.
        Eigen::Matrix<double, 3, 4> J;
        J << on_a.du, on_a.dv, -on_b.du, -on_b.dv;
        const Eigen::Array4d lengths = J.colwise().norm().transpose().array();
        if (!(lengths.minCoeff() > 0.0)) {
            return std::nullopt;
        }
        for (int c = 0; c < 4; ++c) {
            J.col(c) /= lengths[c];
        }
        const Eigen::Matrix3d M = J * J.transpose();
        const Eigen::Vector4d d = (J.transpose() * M.ldlt().solve(r)).array() / lengths;
        if (!d.allFinite()) {
            return std::nullopt;
        }
        const auto next_a = a.clamped({on_a.uv[0] + d[0], on_a.uv[1] + d[1]});
        const auto next_b = b.clamped({on_b.uv[0] + d[2], on_b.uv[1] + d[3]});
        on_a = a.at(next_a[0], next_a[1]);
        on_b = b.at(next_b[0], next_b[1]);
    }
    if (same &&
        std::hypot(on_a.uv[0] - on_b.uv[0], on_a.uv[1] - on_b.uv[1]) < kRunTogether * apart) {
        return std::nullopt;
    }
    if (!a.contains(on_a.uv) || !b.contains(on_b.uv)) {
        return std::nullopt;
    }
    Crossing result;
    result.point = on_a.point;
    const double sine = on_a.normal().cross(on_b.normal()).norm();
    result.angle = std::atan2(sine, std::abs(on_a.normal().dot(on_b.normal())));
    result.depth = std::min(depth_of(a, b, on_a, on_b, step), depth_of(b, a, on_b, on_a, step));
    return result;
}

}  // namespace suture

#include "suture/edges/split.h"

#include "suture/base/tolerance.h"
#include "suture/edges/walk.h"
#include "suture/occ/convert.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector3d;

/// Points per edge to see how flat a part of a loop is.
constexpr int kSamples = 16;

/// A rim that turns by less has no sharp turn there.
const double kSharpTurn = radians(30.0);

/// A part is flat enough if it leaves its plane by no more than this share of what the whole does.
constexpr double kFlatter = 0.1;

/// A loop that leaves its plane by less than this share of its diameter is closed by one face.
constexpr double kFlat = 1e-3;

/// A part narrower than this share of its length is no area, but an edge along another.
constexpr double kNarrow = 1e-3;

TopoDS_Vertex corner(const BoundaryLoop& loop, std::size_t i) {
    return TopExp::FirstVertex(loop.edges[i].edge, Standard_True);
}

/// Points along a run of edges, both of its ends included.
std::vector<Vector3d> points_of(const BoundaryLoop& loop, std::size_t from, std::size_t to) {
    std::vector<Vector3d> points;
    const std::size_t n = loop.edges.size();
    std::size_t i = from;
    do {
        for (int k = 0; k <= kSamples; ++k) {
            points.push_back(walk_to(loop.edges[i].edge, static_cast<double>(k) / kSamples).first);
        }
        i = (i + 1) % n;
    } while (i != to);
    return points;
}

/// How far points are from their best plane and, second, how wide they lie in it.
std::pair<double, double> extent_of(const std::vector<Vector3d>& points) {
    Vector3d centre = Vector3d::Zero();
    for (const Vector3d& p : points) {
        centre += p / static_cast<double>(points.size());
    }
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Vector3d& p : points) {
        covariance += (p - centre) * (p - centre).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
    std::pair<double, double> extent(0.0, 0.0);
    for (const Vector3d& p : points) {
        extent.first = std::max(extent.first, std::abs(axes.eigenvectors().col(0).dot(p - centre)));
        extent.second =
            std::max(extent.second, std::abs(axes.eigenvectors().col(1).dot(p - centre)));
    }
    return extent;
}

bool turns_sharply(const BoundaryLoop& loop, std::size_t i) {
    const std::size_t before = (i + loop.edges.size() - 1) % loop.edges.size();
    const Vector3d in = walk_to(loop.edges[before].edge, 1.0).second;
    const Vector3d out = walk_to(loop.edges[i].edge, 0.0).second;
    return std::atan2(in.cross(out).norm(), in.dot(out)) > kSharpTurn;
}

BoundaryLoop part_of(const BoundaryLoop& loop, std::size_t from, std::size_t to,
                     const TopoDS_Edge& closing) {
    BoundaryLoop part = loop;
    part.edges.clear();
    for (std::size_t i = from; i != to; i = (i + 1) % loop.edges.size()) {
        part.edges.push_back(loop.edges[i]);
    }
    BoundaryEdge cut;
    cut.edge = closing;
    part.edges.push_back(cut);
    part.planar = false;
    part.reason += ", cut in two";
    measure_size(part);
    return part;
}

}  // namespace

std::optional<CornerPair> corners_at(const BoundaryLoop& loop, const Vector3d& one,
                                     const Vector3d& other, double reach) {
    const auto nearest = [&](const Vector3d& point) {
        std::pair<double, std::size_t> best(INFINITY, 0);
        for (std::size_t i = 0; i < loop.edges.size(); ++i) {
            const double apart = (walk_to(loop.edges[i].edge, 0.0).first - point).norm();
            best = std::min(best, {apart, i});
        }
        return best;
    };
    const auto [gap_one, a] = nearest(one);
    const auto [gap_other, b] = nearest(other);
    if (gap_one > reach || gap_other > reach || a == b) {
        return std::nullopt;
    }
    return std::minmax(a, b);
}

std::optional<CornerPair> find_split(const BoundaryLoop& loop) {
    const double whole = extent_of(points_of(loop, 0, 0)).first;
    if (whole <= kFlat * loop.diameter) {
        return std::nullopt;
    }
    std::pair<double, CornerPair> best(kFlatter * whole, {0, 0});
    for (std::size_t a = 0; a < loop.edges.size(); ++a) {
        for (std::size_t b = a + 1; b < loop.edges.size(); ++b) {
            if (!turns_sharply(loop, a) || !turns_sharply(loop, b)) {
                continue;
            }
            const auto one = extent_of(points_of(loop, a, b));
            const auto other = extent_of(points_of(loop, b, a));
            if (std::min(one.second, other.second) > kNarrow * loop.diameter) {
                best = std::min(best, {std::max(one.first, other.first), {a, b}});
            }
        }
    }
    return best.second.second > 0 ? std::optional(best.second) : std::nullopt;
}

Result<std::pair<BoundaryLoop, BoundaryLoop>> split_loop(const BoundaryLoop& loop,
                                                         const CornerPair& corners) {
    const auto [a, b] = corners;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        if (extent_of(points_of(loop, from, to)).second <= kNarrow * loop.diameter) {
            return fail(ErrorCode::Usage,
                        "edge {} runs straight between the two vertices: nothing lies between it "
                        "and the cut",
                        loop.edges[from].edge_number);
        }
    }
    const TopoDS_Edge forth = BRepBuilderAPI_MakeEdge(corner(loop, a), corner(loop, b));
    const TopoDS_Edge back = TopoDS::Edge(forth.Reversed());
    std::pair parts(part_of(loop, a, b, back), part_of(loop, b, a, forth));
    parts.second.id = 0;
    return parts;
}

}  // namespace suture

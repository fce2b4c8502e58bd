#include "suture/detect/loop_shape.h"

#include "suture/detect/use_geometry.h"

#include <Eigen/Geometry>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopExp.hxx>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suture {

namespace {

/// Points per edge. A closed circle's bounding box comes out to a thousandth with these.
constexpr int kPoints = 64;

/// Loops flatter than this share of their diameter span what they enclose in their plane.
constexpr double kFlat = 1e-2;

/// An edge of at most as many tolerances of its vertices has no direction: its ends can lie
/// anywhere within these.
constexpr double kNoDirection = 4.0;

UseGeometry geometry_of(const ShellGraph& graph, const LoopStep& step) {
    const Coedge& use = graph.uses[step.use];
    return {use.edge, graph.faces[use.face]};
}

bool has_direction(const ShellGraph& graph, const LoopStep& step) {
    const UseGeometry geometry = geometry_of(graph, step);
    const double length = (geometry.at(0.5).point - geometry.at(0.0).point).norm() +
                          (geometry.at(1.0).point - geometry.at(0.5).point).norm();
    const TopoDS_Edge& edge = graph.uses[step.use].edge;
    double tolerance = 0.0;
    for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
        tolerance = std::max(tolerance, vertex.IsNull() ? 0.0 : BRep_Tool::Tolerance(vertex));
    }
    return length > kNoDirection * tolerance;
}

/// The turning of the whole loop. Over an edge without a direction it is that from the edge before
/// to the edge after, if all three belong to one face.
double turning_of(const ShellGraph& graph, const RawLoop& loop) {
    const std::size_t n = loop.steps.size();
    const auto face = [&](std::size_t i) { return graph.uses[loop.steps[i % n].use].face; };
    std::vector<double> at_end(n);
    std::vector<double> along(n);
    for (std::size_t i = 0; i < n; ++i) {
        at_end[i] = loop.steps[i].turning;
        along[i] = turning_along(geometry_of(graph, loop.steps[i]));
    }
    for (std::size_t i = 0; i < n && n > 2; ++i) {
        const std::size_t before = (i + n - 1) % n;
        const std::size_t after = (i + 1) % n;
        if (has_direction(graph, loop.steps[i]) || face(before) != face(i) ||
            face(after) != face(i)) {
            continue;
        }
        // uses run with the material on the left: against the walk, unless the file turns the face
        const bool with_walk = loop.steps[i].along_use;
        const UseGeometry arriving = geometry_of(graph, loop.steps[with_walk ? before : after]);
        const UseGeometry leaving = geometry_of(graph, loop.steps[with_walk ? after : before]);
        constexpr double kStep = 1.0 / kChords;
        const Eigen::Vector3d in = arriving.at(1.0).point - arriving.at(1.0 - kStep).point;
        const Eigen::Vector3d out = leaving.at(kStep).point - leaving.at(0.0).point;
        const Eigen::Vector3d normal =
            (arriving.at(1.0 - kStep).normal + leaving.at(kStep).normal).normalized();
        at_end[before] = signed_angle(in, out, normal);
        at_end[i] = 0.0;
        along[i] = 0.0;
    }
    return std::accumulate(at_end.begin(), at_end.end(), 0.0) +
           std::accumulate(along.begin(), along.end(), 0.0);
}

void add_step(const ShellGraph& graph, const LoopStep& step, LoopShape& shape) {
    const Coedge& use = graph.uses[step.use];
    const UseGeometry geometry(use.edge, graph.faces[use.face]);
    const double sign = step.along_use ? -1.0 : 1.0;
    for (int i = 0; i < kPoints; ++i) {
        const double t = (i + 0.5) / kPoints;
        const double at_use = step.along_use ? t : 1.0 - t;
        const UsePoint here = geometry.at(at_use);
        const Eigen::Vector3d chord = geometry.at(std::min(1.0, at_use + 0.5 / kPoints)).point -
                                      geometry.at(std::max(0.0, at_use - 0.5 / kPoints)).point;
        const Eigen::Vector3d walk = -sign * chord.normalized();
        shape.points.push_back(here.point);
        shape.along.push_back(walk);
        shape.onward.push_back((sign * here.normal).cross(walk).normalized());
    }
    const BRepAdaptor_Curve curve(use.edge);
    shape.length += GCPnts_AbscissaPoint::Length(curve);
}

}  // namespace

LoopShape measure_loop(const ShellGraph& graph, const RawLoop& loop) {
    LoopShape shape;
    for (const LoopStep& step : loop.steps) {
        add_step(graph, step, shape);
    }
    // the side of the material, not the direction of the walk, gives turning its sign
    shape.turning = turning_of(graph, loop);
    Eigen::Vector3d low = shape.points.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& p : shape.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
        shape.centre += p / static_cast<double>(shape.points.size());
    }
    shape.diameter = (high - low).norm();
    Eigen::Vector3d vector_area = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const Eigen::Vector3d& next = shape.points[(i + 1) % shape.points.size()];
        const Eigen::Vector3d half =
            0.5 * (shape.points[i] - shape.centre).cross(next - shape.centre);
        vector_area += half;
        shape.spanned_area += half.norm();
    }
    shape.axis = vector_area.normalized();
    for (const Eigen::Vector3d& p : shape.points) {
        shape.flatness = std::max(shape.flatness, std::abs(shape.axis.dot(p - shape.centre)));
    }
    if (shape.flatness <= kFlat * shape.diameter) {
        shape.spanned_area = vector_area.norm();  // the cone covers parts of a C twice
    }
    return shape;
}

}  // namespace suture

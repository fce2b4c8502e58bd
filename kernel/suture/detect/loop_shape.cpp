#include "suture/detect/loop_shape.h"

#include "suture/detect/use_geometry.h"

#include <Eigen/Geometry>

#include <BRepAdaptor_Curve.hxx>
#include <GCPnts_AbscissaPoint.hxx>

#include <algorithm>
#include <cmath>

namespace suture {

namespace {

/// Points per edge. A closed circle's bounding box comes out to a thousandth with these.
constexpr int kPoints = 64;

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
    // the side of the material, not the direction of the walk, gives turning its sign
    shape.turning += step.turning + turning_along(geometry);
    const BRepAdaptor_Curve curve(use.edge);
    shape.length += GCPnts_AbscissaPoint::Length(curve);
}

}  // namespace

LoopShape measure_loop(const ShellGraph& graph, const RawLoop& loop) {
    LoopShape shape;
    for (const LoopStep& step : loop.steps) {
        add_step(graph, step, shape);
    }
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
    return shape;
}

}  // namespace suture

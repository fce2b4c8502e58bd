#pragma once

#include <Eigen/Core>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

namespace suture {

/// Where a connecting curve begins or ends.
struct CurveEnd {
    TopoDS_Vertex vertex;
    Eigen::Vector3d leaving = Eigen::Vector3d::Zero();  ///< unit direction away from what is there
};

/// The curve between two ends that leaves both of them smoothly: a cubic whose end tangents are as
/// long as the gap is wide, times `tension`. A straight line where both directions lie on it.
///
/// Result   an edge on these vertices, from the first to the second.
[[nodiscard]] TopoDS_Edge connect_ends(const CurveEnd& from, const CurveEnd& to, double tension);

}  // namespace suture

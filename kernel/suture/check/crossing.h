#pragma once

#include "suture/check/surface_tree.h"

#include <BRepAdaptor_Curve.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Face.hxx>

#include <optional>
#include <vector>

namespace suture {

/// The edges and vertices that two faces share; of one face with itself its seams and poles.
class SharedBorder {
  public:
    SharedBorder(const TopoDS_Face& one, const TopoDS_Face& two);

    [[nodiscard]] bool has_edges() const { return !edges_.empty(); }
    /// Largest tolerance of these edges and vertices.
    [[nodiscard]] double tolerance() const { return tolerance_; }
    /// The point is nearer to one of them than this and the edge's own tolerance.
    [[nodiscard]] bool is_near(const Eigen::Vector3d& point, double distance) const;

  private:
    struct Edge {
        BRepAdaptor_Curve curve;
        double tolerance = 0.0;
        std::vector<double> t;
        std::vector<Eigen::Vector3d> points;
        double step = 0.0;  ///< the longest between two points
        Eigen::AlignedBox3d box;
    };
    struct Vertex {
        Eigen::Vector3d point;
        double tolerance = 0.0;
    };
    void add_edge(const TopoDS_Shape& edge);
    void add_vertex(const TopoDS_Shape& vertex);

    std::vector<Edge> edges_;
    std::vector<Vertex> vertices_;
    double tolerance_ = 0.0;
};

/// Where two surfaces pass through each other.
struct Crossing {
    Eigen::Vector3d point;
    double depth = 0.0;
    double angle = 0.0;
};

/// The stretch on which two triangles meet, as their weights there: none if they do not.
struct TriangleMeeting {
    std::array<Eigen::Vector3d, 2> ends;
};
[[nodiscard]] std::optional<TriangleMeeting> meeting_of(const std::array<Eigen::Vector3d, 3>& a,
                                                        const std::array<Eigen::Vector3d, 3>& b);

/// Refines a meeting near these parameters of the two surfaces to a point of both, and measures how
/// far each surface goes on beyond it: none where they do not meet inside both faces.
///
/// Input   step: the first step of that walk.
[[nodiscard]] std::optional<Crossing> refine_crossing(const SurfaceTree& a, const SurfaceTree& b,
                                                      std::array<double, 2> uv_a,
                                                      std::array<double, 2> uv_b, double step);

}  // namespace suture

#pragma once

#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

#include <memory>
#include <vector>

namespace suture::bench {

/// A point of a face with its parameters.
struct FacePoint {
    gp_Pnt2d parameters;
    gp_Pnt point;
};

/// The points of an even grid in the parameters that lie in a face.
[[nodiscard]] std::vector<FacePoint> grid_of(const TopoDS_Face& face, int across);

/// Points all over a face: inside and on its boundary.
[[nodiscard]] std::vector<gp_Pnt> points_of(const TopoDS_Face& face);

/// Distances from points to one face, its trimming respected. Every candidate (projections, the
/// nearest point of a grid and what it leads to, the boundary) is a point of the face, so the
/// smallest is never too small.
class FaceDistance {
  public:
    explicit FaceDistance(const TopoDS_Face& face);
    [[nodiscard]] double operator()(const gp_Pnt& point);

  private:
    struct Data;
    std::shared_ptr<Data> data_;
};

}  // namespace suture::bench

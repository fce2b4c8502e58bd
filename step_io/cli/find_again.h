#pragma once

#include <Eigen/Core>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <limits>
#include <span>
#include <vector>

namespace suture::cli {

/// Place and size of a face or an edge.
struct Signature {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    double extent = 0.0;  ///< length, or the square root of the area
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;  ///< box of the vertices
};

[[nodiscard]] Signature signature_of(const TopoDS_Shape& shape);

/// Finds faces or edges again in another copy of a model, where they have other numbers: by what is
/// cheap to know of each; area, length and centroid only when asked for.
class ShapeFinder {
  public:
    explicit ShapeFinder(const TopTools_IndexedMapOfShape& shapes);

    /// The number of the shape, or 0.
    [[nodiscard]] int find(const Signature& wanted);

    /// The same among the shapes of these numbers.
    [[nodiscard]] int find(const Signature& wanted, std::span<const int> among);

  private:
    [[nodiscard]] int nearest(const Signature& wanted, std::span<const int> among,
                              bool same_vertices_only);

    const TopTools_IndexedMapOfShape& shapes_;
    std::vector<Signature> signatures_;
};

}  // namespace suture::cli

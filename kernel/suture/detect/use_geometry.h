#pragma once

#include "suture/occ/handle.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <BRepAdaptor_Surface.hxx>
#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <vector>

namespace suture {

/// A point of an edge and the outward normal of the face there.
struct UsePoint {
    Eigen::Vector3d point;
    Eigen::Vector3d normal;  ///< zero where the surface has none
};

/// The geometry of an edge use: a face's edge, walked as the face goes.
class UseGeometry {
  public:
    /// Input  edge as the oriented face uses it; it may be degenerated.
    UseGeometry(const TopoDS_Edge& edge, const TopoDS_Face& face);

    /// t in [0,1] from the start of the use to its end; points lie on the face's surface.
    [[nodiscard]] UsePoint at(double t) const;
    [[nodiscard]] Eigen::Vector2d uv(double t) const;

    /// The angle that the material fills at the point of a degenerated edge.
    [[nodiscard]] double degenerated_angle() const;

  private:
    [[nodiscard]] Eigen::Vector3d normal_at(const Eigen::Vector2d& uv) const;

    /// The face's parameter range; unlike the surface's it is never infinite.
    [[nodiscard]] Eigen::AlignedBox2d bounds() const;

    TopoDS_Face face_;
    BRepAdaptor_Surface surface_;
    double first_ = 0.0;  // before pcurve_, whose making sets them
    double last_ = 0.0;
    occ::Handle<Geom2d_Curve> pcurve_;
    bool reversed_edge_ = false;
    bool reversed_face_ = false;
};

/// Signed angle from a to b about n, in (-pi, pi].
[[nodiscard]] double signed_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& n);

/// How finely an edge is walked: number of chords. Corner angles are taken between the chords that
/// begin there, so that the sum of all turning is that of one polygon and errs as a whole only.
inline constexpr int kChords = 24;

/// The interior angle of a face at the vertex between the end of one use and the start of the next,
/// in [0, 2 pi); both belong to one face.
[[nodiscard]] double corner_angle(const UseGeometry& arriving, const UseGeometry& leaving);

/// Sum of the turning to the left between the chords of a use, its ends left out.
[[nodiscard]] double turning_along(const UseGeometry& use);

}  // namespace suture

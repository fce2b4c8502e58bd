#pragma once

#include "suture/check/surface_grid.h"

#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>
#include <gp_Vec2d.hxx>

#include <array>
#include <optional>
#include <vector>

namespace suture {

/// A parameter range of an edge's curve.
struct EdgeRange {
    double first = 0.0, last = 1.0;
};

/// What a face is like next to a point of its border.
struct BorderPoint {
    gp_Pnt point;                     ///< the nearest point of the face's surface
    std::optional<gp_Vec> normal;     ///< outward unit normal; none where even its limit is unknown
    std::optional<double> curvature;  ///< normal curvature perpendicular to the edge, along normal
    /// The curvature's change per length along normal x tangent, at the same point: of the section
    /// of the face by the plane perpendicular to the edge.
    std::optional<double> curvature_slope;
};

/// One face as seen from one edge of its border: nearest points, outward normals, curvatures.
///
/// Works in the frame of the face's untransformed surface; locations may move, scale or mirror.
/// Not shared between threads: it owns adaptors with caches.
class FaceSide {
  public:
    /// Input  edge as it stands in the face taken FORWARD (see EdgeInFace).
    FaceSide(const TopoDS_Face& face, const TopoDS_Edge& edge, EdgeRange range, double length);

    /// At the edge's parameter t, where its curve has this point and derivative. The curvature's
    /// slope only if wanted: it takes third derivatives.
    [[nodiscard]] BorderPoint at(double t, const gp_Pnt& point, const gp_Vec& derivative,
                                 bool with_slope = false);

    /// The surface's parameters of the nearest point.
    [[nodiscard]] gp_Pnt2d parameters(double t, const gp_Pnt& point);

    /// Where uv lies on a knot line with less than C2 and the edge runs along it: a small step in
    /// the parameters into the face. Else zero.
    [[nodiscard]] gp_Vec2d off_breaks(double t, const gp_Pnt2d& uv);

    /// Polynomial pieces of the surface that the edge passes: how finely to sample.
    [[nodiscard]] int pieces() const { return pieces_; }
    /// Where the edge passes from one piece to the next, as parts of its range; unordered.
    [[nodiscard]] const std::vector<double>& passages() const { return passages_; }
    /// The highest degree of these: how many waves a piece may have.
    [[nodiscard]] int degree() const { return degree_; }
    /// The surface is a plane: everything along a straight edge is linear.
    [[nodiscard]] bool is_plane() const { return surface_.GetType() == GeomAbs_Plane; }
    /// The nearest point has a closed form: plane, cylinder, cone, sphere, torus.
    [[nodiscard]] bool is_elementary() const;

  private:
    /// One parameter direction of the surface.
    struct Direction {
        double low = 0.0, high = 0.0;  ///< only if bounded
        bool bounded = false, periodic = false, finite = false;
        double size = 1.0;           ///< of the range, or what stands for it
        std::vector<double> breaks;  ///< inner knots where the surface is less than C2

        [[nodiscard]] double clamped(double value) const;
        [[nodiscard]] bool at_break(double value) const;
    };
    struct Jet {
        gp_Pnt P;
        gp_Vec Su, Sv, Suu, Svv, Suv;
    };

    void set_up_direction(Direction& direction, bool is_u) const;
    void count_pieces();
    [[nodiscard]] double to_pcurve(double t) const;
    [[nodiscard]] Jet jet(const gp_Pnt2d& uv) const;
    [[nodiscard]] gp_Pnt2d nearest(double t, const gp_Pnt& local, gp_Pnt& on_surface);
    [[nodiscard]] gp_Pnt2d elementary_parameters(const gp_Pnt& local) const;
    [[nodiscard]] bool descend(const gp_Pnt& local, gp_Pnt2d& uv, gp_Pnt& on_surface) const;
    /// Looks all over the surface for a point nearer than on_surface.
    void project_globally(const gp_Pnt& local, gp_Pnt2d& uv, gp_Pnt& on_surface);
    void search_grid(const gp_Pnt& local, gp_Pnt2d& uv, gp_Pnt& on_surface);
    void set_local(BorderPoint& result, double t, const gp_Pnt2d& uv, const gp_Pnt& local,
                   const gp_Vec& tangent, bool with_slope);
    [[nodiscard]] gp_Vec2d inward(double t);
    [[nodiscard]] bool regular(const Jet& jet) const;
    [[nodiscard]] gp_Vec local_normal(const Jet& jet) const;
    [[nodiscard]] std::optional<gp_Vec> limit_normal(double t, const gp_Pnt& local);
    [[nodiscard]] std::optional<double> curvature(const Jet& jet, const gp_Vec& normal,
                                                  const gp_Vec& tangent) const;
    [[nodiscard]] double slope(const gp_Pnt2d& uv, const Jet& jet, const gp_Vec& normal,
                               const gp_Vec& tangent) const;
    [[nodiscard]] bool load_pcurve();

    TopoDS_Face face_;
    TopoDS_Edge edge_;
    EdgeRange range_;
    bool reversed_ = false;
    bool moved_ = false;
    gp_Trsf to_model_, to_local_;
    double scale_ = 1.0;   ///< of to_model_, positive
    double length_ = 1.0;  ///< of the edge, in the local frame
    GeomAdaptor_Surface surface_;
    std::array<Direction, 2> directions_;
    bool pcurve_known_ = false;
    std::optional<Geom2dAdaptor_Curve> pcurve_;
    EdgeRange pcurve_range_;
    std::optional<SurfaceGrid> grid_;  ///< made when first needed
    std::optional<gp_Pnt2d> last_;     ///< parameters of the last point: the start without a pcurve
    int pieces_ = 1;
    std::vector<double> passages_;
    int degree_ = 1;
};

}  // namespace suture

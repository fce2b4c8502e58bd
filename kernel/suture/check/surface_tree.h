#pragma once

#include "suture/check/derivative_net.h"
#include "suture/check/face_domain.h"

#include <Eigen/Geometry>

#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>

#include <array>
#include <optional>
#include <vector>

namespace suture {

/// A point of a face's surface with its derivatives.
struct SurfacePoint {
    std::array<double, 2> uv = {};
    Eigen::Vector3d point, du, dv;

    /// Zero where the surface is singular.
    [[nodiscard]] Eigen::Vector3d normal() const { return du.cross(dv).stableNormalized(); }
    /// The change of the parameters along a vector of the tangent plane.
    [[nodiscard]] std::array<double, 2> parameters_of(const Eigen::Vector3d& tangent) const;
};

/// A face's surface as a tree of boxes around ever smaller parts of it, made as they are asked for.
///
/// Not shared between threads.
class SurfaceTree {
  public:
    /// A part of the surface. Its box holds it up to an estimate from nine of its points.
    struct Cell {
        ParameterBox uv;
        Eigen::AlignedBox3d box;
        bool flat_known = false;  ///< small enough for its points to tell its shape
        double sag = 0.0;         ///< how far it may be from the two triangles of its corners
        FaceDomain::Part part = FaceDomain::Part::Border;
        std::vector<int> near;                    ///< pieces of the face's loops that may pass it
        int children = -1;                        ///< first of two; -1: not made yet
        std::vector<Eigen::Vector3d> by_u, by_v;  ///< derivatives, by differences; if flat_known
        std::array<Eigen::Vector3d, 4> corners;   ///< low low, high low, high high, low high
    };

    /// Throws std::domain_error for a face that goes around its surface hundreds of times.
    SurfaceTree(const TopoDS_Face& face, int number);

    [[nodiscard]] int number() const { return number_; }
    /// Planes, cylinders, cones and spheres cannot, nor a torus that is a ring.
    [[nodiscard]] bool can_meet_itself() const;
    [[nodiscard]] const FaceDomain& domain() const { return domain_; }
    [[nodiscard]] const Cell& cell(int i) const { return cells_[static_cast<std::size_t>(i)]; }
    /// It is not to be split.
    [[nodiscard]] bool is_smallest(const Cell& cell) const {
        return is_smallest(cell.uv, 0) && is_smallest(cell.uv, 1);
    }
    /// The first of the two halves of a cell; invalidates references to cells.
    int split(int i);

    /// Proven not to pass through itself over the box: by the control net of a polynomial spline,
    /// for some plane the projected surface is a monotone map of it.
    [[nodiscard]] bool is_injective(const ParameterBox& box) const;

    [[nodiscard]] SurfacePoint at(double u, double v) const;
    [[nodiscard]] Eigen::Vector3d point(double u, double v) const;

    /// The point of the surface at which its distance from `from` is stationary, downhill from a
    /// start, within the surface's bounds; none if the search does not settle.
    [[nodiscard]] std::optional<SurfacePoint> foot(const Eigen::Vector3d& from,
                                                   std::array<double, 2> start) const;
    /// The nearest point of the face itself, if it is not farther than the limit.
    [[nodiscard]] std::optional<SurfacePoint> nearest(const Eigen::Vector3d& from, double limit);

    /// The parameters lie inside the face's loops, also a period away.
    [[nodiscard]] bool contains(const std::array<double, 2>& uv) const {
        const auto in = domain_.in_period(uv[0], uv[1]);
        return domain_.contains(in[0], in[1]);
    }
    [[nodiscard]] std::array<double, 2> clamped(std::array<double, 2> uv) const;

  private:
    [[nodiscard]] double length_of(const Cell& cell, std::size_t k) const;
    [[nodiscard]] bool is_smallest(const ParameterBox& uv, std::size_t k) const;
    [[nodiscard]] Cell make_cell(const ParameterBox& uv, std::vector<int> near) const;
    [[nodiscard]] bool has_break(const ParameterBox& uv, std::size_t k) const;

    int number_ = 0;
    GeomAdaptor_Surface surface_;
    gp_Trsf to_model_;
    bool moved_ = false;
    FaceDomain domain_;
    ParameterBox bounds_;
    std::array<bool, 2> bounded_ = {false, false};
    /// Where the surface's shape may change in each direction: knots, and parts of a turn.
    std::array<std::vector<double>, 2> breaks_;
    std::optional<DerivativeNet> net_;  ///< of a spline
    std::vector<Cell> cells_;
};

}  // namespace suture

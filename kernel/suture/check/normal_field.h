#pragma once

#include "suture/check/face_domain.h"
#include "suture/occ/handle.h"

#include <Eigen/Core>

#include <Geom_Surface.hxx>

#include <array>
#include <string>
#include <vector>

namespace suture {

/// A polynomial vector field along the normal of one piece of a surface, S_u x S_v but for a
/// positive factor, in Bernstein's form over the piece's box: it lies within the cone of its
/// coefficients.
struct NormalPiece {
    ParameterBox uv;
    std::array<int, 2> degrees = {0, 0};
    std::vector<Eigen::Vector3d> coefficients;  ///< with v fastest
    /// Sides at the surface's own end, where it may be singular as a whole: low u, high u, low v,
    /// high v.
    std::array<bool, 4> at_end = {false, false, false, false};

    [[nodiscard]] Eigen::Vector3d& at(int i, int j) {
        return coefficients[static_cast<std::size_t>(i * (degrees[1] + 1) + j)];
    }
    [[nodiscard]] const Eigen::Vector3d& at(int i, int j) const {
        return coefficients[static_cast<std::size_t>(i * (degrees[1] + 1) + j)];
    }
    /// The field at a corner.
    [[nodiscard]] const Eigen::Vector3d& corner(bool high_u, bool high_v) const {
        return at(high_u ? degrees[0] : 0, high_v ? degrees[1] : 0);
    }
    [[nodiscard]] std::array<NormalPiece, 2> halves(std::size_t direction) const {
        return split(direction, uv.middle(direction));
    }
    [[nodiscard]] std::array<NormalPiece, 2> split(std::size_t direction, double at) const;
    /// The part within a box that meets the piece's.
    [[nodiscard]] NormalPiece clipped(const ParameterBox& box) const;
    /// Divides by the distance from those ends of the surface on which the field vanishes, up to
    /// rounding: it keeps its direction, and has one there.
    void divide_out_ends();
};

/// The field of a surface, piece by piece, or why there is none.
struct NormalField {
    std::vector<NormalPiece> pieces;
    /// The pieces' boxes are in the surface's own parameters; else they are one row of pieces that
    /// cover the whole box in an order of their own.
    bool own_parameters = true;
    std::string reason;  ///< why there are no pieces, else empty
};

/// Exact but for rounding: of a B-spline or Bezier surface, rational or not, and of a surface of
/// extrusion or revolution, over the pieces that meet the box.
[[nodiscard]] NormalField make_normal_field(const occ::Handle<Geom_Surface>& surface,
                                            const ParameterBox& box);

}  // namespace suture

#pragma once

#include "suture/check/certify/bezier_piece.h"
#include "suture/occ/handle.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt2d.hxx>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace suture::certify {

/// A surface turned so that the side which is collapsed to a point is u = low.
struct PoleOfSpline {
    SplineSurface turned;
    bool across_u = true;  ///< as this surface's u it has the other's u, or v
    bool at_low = true;    ///< and it is the other's low end
};

/// A part of a surface without kinks inside, and its sides that are points.
struct SmoothPiece {
    SplineSurface surface;
    std::vector<PoleOfSpline> poles;
};

/// The sides of a surface that are collapsed to a point.
[[nodiscard]] std::vector<PoleOfSpline> find_poles(const SplineSurface& surface);

/// A face's surface as B-splines that are it exactly, but for rounding.
///
/// A B-spline or Bezier surface is itself; a surface of extrusion or revolution is converted over
/// the face's range; an offset surface is what it is offset from, and a distance.
class ExactSpline {
  public:
    /// Input  surface of the face, in the model's place and without trimming.
    /// Refuses  other surfaces, and sweeps and offsets of other things: `reason` says why.
    ExactSpline(const TopoDS_Face& face, const occ::Handle<Geom_Surface>& surface);

    [[nodiscard]] const std::string& reason() const { return reason_; }

    /// The surface between its knots of less than C1: smooth pieces that meet in their sides.
    [[nodiscard]] const std::vector<SmoothPiece>& pieces() const { return pieces_; }

    /// Of u or v, of the whole.
    [[nodiscard]] Span range(std::size_t direction) const;

    /// The inner knots of u or v at which the surface is less than C1.
    [[nodiscard]] std::vector<double> kinks(std::size_t direction) const;

    /// Along the normal S_u x S_v.
    [[nodiscard]] double offset() const { return offset_; }

    /// How far the conversion may have moved points by rounding.
    [[nodiscard]] double rounding() const { return rounding_; }

    /// Parameters here of a point at uv of the face's surface.
    [[nodiscard]] std::array<double, 2> parameters(const gp_Pnt2d& uv, const gp_Pnt& point) const;

  private:
    [[nodiscard]] occ::Handle<Geom_BSplineSurface> convert(
        const TopoDS_Face& face, const occ::Handle<Geom_Surface>& surface);

    occ::Handle<Geom_BSplineSurface> whole_;
    std::vector<SmoothPiece> pieces_;
    double offset_ = 0.0, rounding_ = 0.0;
    bool other_parameters_ = false;  ///< than the face's surface
    std::array<double, 2> periods_ = {0.0, 0.0};
    std::string reason_;
};

}  // namespace suture::certify

#pragma once

#include "suture/check/certify/bezier_piece.h"
#include "suture/occ/handle.h"

#include <Geom_Surface.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace suture::certify {

/// The nearest point of a face's surface to a stretch of an edge, and the unit normal there.
struct Foot {
    TaylorModel3 point;  ///< counted from the stretch's origin
    TaylorModel3 normal;
};

/// All that is asked of one stretch.
struct Stretch {
    Span range;                    ///< of the edge's parameter
    std::array<double, 3> origin;  ///< near the stretch
    TaylorModel3 curve;            ///< the edge, counted from the origin
    gp_Vec normal;                 ///< sampled outward normal in the middle: which side is outside
    std::vector<std::array<double, 2>> nodes;  ///< sampled parameters at Chebyshev's points
};

/// The points of [-1, 1] at which `nodes` are sampled, in rising order.
[[nodiscard]] const std::vector<double>& path_points();

/// A surface as the certificate sees it: plane, cylinder, cone, sphere, torus or B-spline.
class CertifiedSurface {
  public:
    /// Refuses  any other surface: `reason` says which.
    explicit CertifiedSurface(const occ::Handle<Geom_Surface>& surface);

    [[nodiscard]] const std::string& reason() const { return reason_; }
    [[nodiscard]] bool is_spline() const { return spline_.has_value(); }

    /// The feet, one for each polynomial piece that the stretch may touch: at every point of it
    /// one of them is right. Empty where nothing can be said: then the stretch is to be divided,
    /// and `why` says what stood in the way.
    [[nodiscard]] std::vector<Foot> feet(const Stretch& stretch, std::string& why) const;

  private:
    [[nodiscard]] std::optional<Foot> elementary_foot(const Stretch& stretch) const;
    [[nodiscard]] std::vector<Foot> spline_feet(const Stretch& stretch, std::string& why) const;

    occ::Handle<Geom_Surface> surface_;
    std::optional<SplineSurface> spline_;
    std::string reason_;
};

}  // namespace suture::certify

#pragma once

#include "suture/check/certify/bezier_piece.h"
#include "suture/check/certify/exact_spline.h"
#include "suture/occ/handle.h"

#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>
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
    /// Where the stretch runs along a knot with a kink: a step in the parameters to the side on
    /// which the face lies. Else zero.
    std::array<double, 2> inward = {0.0, 0.0};
};

/// The surface of a face as the certificate sees it: plane, cylinder, cone, sphere, torus, or
/// B-splines that are smooth in themselves; of an offset surface what it is offset from.
class CertifiedSurface {
  public:
    /// Refuses  a surface that is none of these, nor exactly made of them: `reason` says which.
    explicit CertifiedSurface(const TopoDS_Face& face);

    [[nodiscard]] const std::string& reason() const { return reason_; }
    [[nodiscard]] bool is_elementary() const { return !spline_; }

    /// Plane, cylinder, cone, sphere and torus: the nearest point is a function of the edge's point
    /// alone, and the same for both.
    [[nodiscard]] bool same_elementary(const CertifiedSurface& other) const;

    /// The parameters that the stretch's nodes are in, of a point at these of the face's surface.
    [[nodiscard]] std::array<double, 2> node(const gp_Pnt2d& uv, const gp_Pnt& point) const;

    /// Knots of u or v at which the nodes' surface has a kink.
    [[nodiscard]] std::vector<double> kinks(std::size_t direction) const {
        return spline_ ? spline_->kinks(direction) : std::vector<double>{};
    }

    /// The feet, one for each polynomial piece that the stretch may touch: at every point of it
    /// one of them is right. Empty where nothing can be said: then the stretch is to be divided,
    /// and `why` says what stood in the way.
    [[nodiscard]] std::vector<Foot> feet(const Stretch& stretch, std::string& why) const;

  private:
    [[nodiscard]] std::optional<Foot> elementary_foot(const Stretch& stretch) const;
    [[nodiscard]] std::vector<Foot> spline_feet(const Stretch& stretch, std::string& why) const;

    occ::Handle<Geom_Surface> surface_;
    std::optional<ExactSpline> spline_;
    std::string reason_;
};

/// The feet on one piece, offset by a distance along its normal (0: on itself). Nodes may lie
/// outside of it. As for CertifiedSurface::feet; off_path is a bound of how far the stretch is from
/// the sampled path on the surface, infinite where that is not known.
[[nodiscard]] std::vector<Foot> feet_on(const SmoothPiece& smooth, double offset,
                                        const Stretch& stretch, double& off_path, std::string& why);

/// What is known near a side of the surface that is collapsed to a point.
struct NearPole {
    TaylorModel3 normal;    ///< all normals there, as one vector
    double distance = 0.0;  ///< the stretch is nowhere farther from the point
};

/// Nothing where the stretch is not near such a side.
[[nodiscard]] std::optional<NearPole> near_pole(const std::vector<PoleOfSpline>& poles,
                                                const Stretch& stretch);

}  // namespace suture::certify

#include "suture/candidates/carriers.h"

#include "suture/candidates/to_surface.h"
#include "suture/fill/recognise/border.h"
#include "suture/fill/recognise/form.h"
#include "suture/fill/recognise/plain.h"
#include "suture/fill/recognise/surface_foot.h"
#include "suture/occ/convert.h"
#include "suture/occ/model_surface.h"

#include <Eigen/Geometry>

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_OffsetSurface.hxx>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace suture {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using recognise::Border;

/// As shares of the hole's diameter: distances that vary by more are no constant; offsets below
/// this are none.
constexpr double kSpread = 6e-5;
constexpr double kLeastOffset = 1e-3;

/// A distance is 0 where its middle is within so many times its spread: noise of a border lies on
/// one side of a surface.
constexpr double kZero = 3.0;

/// Of the grid from which feet on surfaces without formulas are sought.
constexpr std::size_t kRows = 20;

/// A foot may lie so far beside the point as a share of their distance; or of the hole's diameter;
/// or so many times what a coordinate is good to. One on the border of the domain lies further.
constexpr double kBeside = 0.045;
constexpr double kOn = 1e-9;
constexpr double kRounding = 20.0;

/// Walls are thinner than this share of the hole.
constexpr double kWall = 2.0;

/// Signed distances of points from a surface, along X_u x X_v.
struct Range {
    double low = INFINITY;
    double high = -INFINITY;
    void add(double d) {
        low = std::min(low, d);
        high = std::max(high, d);
    }
    [[nodiscard]] double middle() const { return 0.5 * (low + high); }
    [[nodiscard]] double spread() const { return high - low; }
};

class Ruler {
  public:
    /// Input    beside: what a foot may lie beside its point in any case.
    Ruler(const Surface& surface, double beside) : surface_(surface), beside_(beside) {
        if (const auto* spline = std::get_if<SplineSurface>(&surface)) {
            foot_.emplace(*spline, kRows);
        }
    }

    /// Signed distance; infinite where the surface ends before.
    [[nodiscard]] double operator()(const Vector3d& point) const {
        if (!foot_) {
            return recognise::distance_to(surface_, point).value;
        }
        const Eigen::Vector2d uv = foot_->find(point);
        const SurfaceJet jet = evaluate(surface_, uv.x(), uv.y());
        const Vector3d n = jet.u.cross(jet.v).normalized();
        const Vector3d d = point - jet.point;
        const double beside = (d - d.dot(n) * n).norm();
        return beside <= std::max(kBeside * d.norm(), beside_) ? d.dot(n) : INFINITY;
    }

  private:
    const Surface& surface_;
    double beside_;
    std::optional<recognise::SurfaceFoot> foot_;
};

/// The closed form at a distance, or OCCT's offset of anything else.
///
/// Result   without what it is to be called.
std::optional<Candidate> offset_of(const Surface& surface, const TopoDS_Face& face, double distance,
                                   const Hole& hole) {
    if (recognise::closed_form(surface)) {
        Surface result = surface;
        if (auto* plane = std::get_if<Plane>(&result)) {
            plane->frame.origin += distance * plane->frame.z;
        } else if (auto* cone = std::get_if<Cone>(&result)) {
            cone->radius += distance / std::cos(cone->half_angle);
        } else if (auto* torus = std::get_if<Torus>(&result)) {
            torus->minor += distance;
        } else {
            *recognise::sizes_of(result).front() += distance;
        }
        return Candidate{std::move(result), {}, {}};
    }
    const occ::Handle<Geom_Surface> offset =
        occ::make<Geom_OffsetSurface>(BRep_Tool::Surface(face), distance);
    auto copy = to_surface(offset, hole);
    if (!copy) {
        return std::nullopt;
    }
    Candidate candidate{std::move(*copy), {}, {}};
    candidate.original = std::make_shared<const ModelSurface>(ModelSurface{offset});
    return candidate;
}

bool within_reach(const TopoDS_Face& face, const Border& border) {
    Bnd_Box box;
    BRepBndLib::Add(face, box, /*useTriangulation=*/Standard_False);
    Bnd_Box hole;
    const Matrix3Xd points = border.model_points();
    for (Eigen::Index k = 0; k < points.cols(); k += Border::kSamples / 4) {
        hole.Add(occ::to_point(Vector3d(points.col(k))));
    }
    hole.Enlarge(kWall * border.size);
    return !box.IsVoid() && !box.IsOut(hole);
}

Range range_of(const Surface& surface, const Matrix3Xd& points, double limit, double beside) {
    const Ruler ruler(surface, beside);
    Range range;
    // A few points far apart first: most surfaces are far off.
    const Eigen::Index stride = std::max<Eigen::Index>(points.cols() / 7, 1);
    for (const Eigen::Index step : {stride, Eigen::Index(1)}) {
        for (Eigen::Index k = 0; k < points.cols(); k += step) {
            range.add(ruler(points.col(k)));
            if (!(range.spread() <= limit)) {
                return range;
            }
        }
    }
    return range;
}

}  // namespace

std::vector<Candidate> find_carriers(const std::vector<TopoDS_Face>& faces,
                                     const occ::Numbering& numbering, const Hole& hole,
                                     double noise, bool offsets) {
    const Border border = recognise::border_of(hole, noise);
    const Matrix3Xd points = border.model_points();
    const double limit = std::max(kSpread, 3.0 * border.noise) * border.size;
    const double beside = std::max(kOn, kRounding * border.rounding) * border.size;
    std::vector<Surface> seen;
    std::vector<Candidate> same;
    std::vector<Candidate> moved;
    for (const TopoDS_Face& face : faces) {
        if (!within_reach(face, border)) {
            continue;
        }
        const auto found = to_surface(BRep_Tool::Surface(face), hole);
        if (!found) {
            continue;
        }
        const Surface& surface = *found;
        const bool known = std::any_of(seen.begin(), seen.end(), [&](const Surface& other) {
            return same_surface(other, surface, border.origin, border.size, limit * 1e-3);
        });
        if (known) {
            continue;
        }
        seen.push_back(surface);
        const Range range = range_of(surface, points, limit, beside);
        const bool far = !(range.spread() <= limit) || !std::isfinite(range.middle());
        if (far || std::abs(range.middle()) > kWall * border.size) {
            continue;
        }
        const int number = numbering.of(face);
        const double half = std::max(0.5 * range.spread(), border.rounding * border.size);
        if (std::abs(range.middle()) <= 2.0 * kZero * half) {
            same.push_back(
                {surface, "same surface", fmt::format("the surface of face {}", number)});
        } else if (offsets && std::abs(range.middle()) > kLeastOffset * border.size) {
            const double size = std::abs(range.middle());
            const double round = recognise::find_round_length(size, half).value_or(size);
            const double distance = std::copysign(round, range.middle());
            if (auto offset = offset_of(surface, face, distance, hole)) {
                offset->kind = "offset";
                offset->from = fmt::format("face {}, offset by {:.7g}", number, round);
                offset->chance = recognise::chance_of_round(size, round);
                moved.push_back(std::move(*offset));
            }
        }
    }
    same.insert(same.end(), moved.begin(), moved.end());
    return same;
}

}  // namespace suture

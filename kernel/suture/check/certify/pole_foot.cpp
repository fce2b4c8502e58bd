// The nearest points near a side of a surface that is collapsed to a point P. There
// S = P + (x + 1) T for x = -1 at the side, with T a polynomial: its derivatives have a normal
// where those of S vanish. An edge that comes within e of P has its nearest point within 2 e of P,
// so all normals of that neighbourhood together enclose it.
#include "suture/check/certify/foot_point.h"

#include <gp_XYZ.hxx>

#include <algorithm>
#include <cmath>

namespace suture::certify {

namespace {

// Poles of a side no farther apart than this part of the surface's size are one point.
constexpr double kCollapsed = 1e-12;

// The box reaches this many times as far from the side as the edge does.
constexpr double kRoom = 2.5;

// Farther from the side than this part of the first knot span normals vary too much.
constexpr double kNear = 0.02;

// Into how many parts a span along the side is divided, for the normals' sake: their series are
// short enough then.
constexpr int kParts = 8;
constexpr int kMostParts = 64;

/// The surface seen with the collapsed side at u = low.
SplineSurface turned(const SplineSurface& surface, bool across_u, bool at_low) {
    SplineSurface result;
    const std::vector<double>& across = across_u ? surface.knots_u : surface.knots_v;
    result.knots_u = across;
    if (!at_low) {
        std::ranges::reverse(result.knots_u);
        for (double& knot : result.knots_u) {
            knot = -knot;
        }
    }
    result.knots_v = across_u ? surface.knots_v : surface.knots_u;
    result.degree_u = across_u ? surface.degree_u : surface.degree_v;
    result.degree_v = across_u ? surface.degree_v : surface.degree_u;
    result.rational = surface.rational;
    const int rows = result.poles_u();
    const int columns = result.poles_v();
    for (int i = 0; i < rows; ++i) {
        const int from_side = at_low ? i : rows - 1 - i;
        for (int j = 0; j < columns; ++j) {
            const int index = across_u ? from_side * columns + j : j * rows + from_side;
            result.poles.push_back(surface.poles[static_cast<std::size_t>(index)]);
        }
    }
    return result;
}

gp_XYZ point_of(const std::array<double, 4>& pole) {
    return gp_XYZ(pole[0], pole[1], pole[2]) / pole[3];
}

/// The first row of poles is one point, and the others are not.
bool starts_in_a_point(const SplineSurface& surface) {
    const gp_XYZ first = point_of(surface.poles.front());
    double size = 0.0;
    for (const auto& pole : surface.poles) {
        size = std::max(size, (point_of(pole) - first).Modulus());
    }
    const auto columns = static_cast<std::ptrdiff_t>(surface.poles_v());
    return std::all_of(
        surface.poles.begin(), surface.poles.begin() + columns,
        [&](const auto& pole) { return (point_of(pole) - first).Modulus() <= kCollapsed * size; });
}

/// All unit normals of a part of a span along the side, and the least length of T there.
struct Normals {
    TaylorModel3 unit;
    double shortest = 0.0;
};

class PoleSide {
  public:
    /// Input  reach: how far from the side.
    PoleSide(const SplineSurface& surface, double reach, const std::array<double, 3>& origin)
        : surface_(surface), origin_(origin) {
        // A box that does not shrink with the reach, so that rounding stays small against it.
        const std::vector<double>& knots = surface.knots_u;
        const auto p = static_cast<std::size_t>(surface.degree_u);
        const double width = kRoom * kNear * (knots[p + 1] - knots[p]);
        across_ = {knots.front(), knots.front() + width};
        from_side_ = reach / width;
    }

    /// x + 1 is between 0 and twice this.
    [[nodiscard]] double from_side() const { return from_side_; }

    /// The normals over a part of span k along the side, as far as the reach.
    [[nodiscard]] std::optional<Normals> normals(int k, const Span& along) const {
        const BezierPiece piece(surface_, surface_.degree_u, k, across_, along, origin_);
        const TaylorModel above = TaylorModel(from_side_).widened(from_side_);  // x + 1
        const auto [t, tx, ty] =
            piece.divided(above - TaylorModel(1.0), TaylorModel::linear(0.0, 1.0));
        // S_x = T + (x + 1) T_x, S_y = (x + 1) T_y.
        const TaylorModel3 normal = cross(t + above * tx, ty);
        Normals result;
        result.unit = inverse(sqrt(dot(normal, normal))) * normal;
        result.shortest = std::sqrt(std::max(0.0, dot(t, t).lower()));
        return known(result.unit) ? std::optional(result) : std::nullopt;
    }

  private:
    const SplineSurface& surface_;
    std::array<double, 3> origin_;
    Span across_;
    double from_side_ = 0.0;
};

std::optional<NearPole> near_first_row(const SplineSurface& surface, double reach,
                                       const Stretch& stretch) {
    const std::vector<double>& knots = surface.knots_u;
    const auto p = static_cast<std::size_t>(surface.degree_u);
    const double span = knots[p + 1] - knots[p];
    if (!(reach < kNear * span)) {
        return std::nullopt;
    }
    const gp_XYZ at = point_of(surface.poles.front()) -
                      gp_XYZ(stretch.origin[0], stretch.origin[1], stretch.origin[2]);
    const TaylorModel3 pole = {at.X(), at.Y(), at.Z()};
    const double rounding =
        16 * kRounding * (at.Modulus() + point_of(surface.poles.front()).Modulus());
    const double near = longest(stretch.curve - pole) + rounding;
    const PoleSide side(surface, kRoom * reach, stretch.origin);
    std::vector<TaylorModel3> units;
    const std::vector<double>& along = surface.knots_v;
    for (int k = surface.degree_v; k < surface.poles_v(); ++k) {
        const double low = along[static_cast<std::size_t>(k)];
        const double high = along[static_cast<std::size_t>(k) + 1];
        int parts = low < high ? kParts : 0;
        for (int i = 0; i < parts;) {
            const double width = (high - low) / parts;
            const auto found = side.normals(k, {low + i * width, low + (i + 1) * width});
            if (!found) {
                if (parts >= kMostParts) {
                    return std::nullopt;
                }
                parts *= 2;
                i *= 2;
                continue;
            }
            // There the surface is (x + 1) |T| from P.
            if (!(side.from_side() * found->shortest > near)) {
                return std::nullopt;
            }
            units.push_back(found->unit);
            ++i;
        }
    }
    if (units.empty()) {
        return std::nullopt;
    }
    TaylorModel3 middle;
    for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (const TaylorModel3& unit : units) {
            sum += unit.at(c).middle();
        }
        middle.at(c) = sum / static_cast<double>(units.size());
    }
    double spread = 0.0;
    for (const TaylorModel3& unit : units) {
        spread = std::max(spread, longest(unit - middle));
    }
    return NearPole{widened(middle, spread), near};
}

}  // namespace

std::vector<PoleOfSpline> find_poles(const SplineSurface& surface) {
    std::vector<PoleOfSpline> poles;
    for (const bool across_u : {true, false}) {
        for (const bool at_low : {true, false}) {
            SplineSurface same = turned(surface, across_u, at_low);
            if (starts_in_a_point(same)) {
                poles.push_back({std::move(same), across_u, at_low});
            }
        }
    }
    return poles;
}

std::optional<NearPole> near_pole(const std::vector<PoleOfSpline>& poles, const Stretch& stretch) {
    for (const auto& [surface, across_u, at_low] : poles) {
        double reach = 0.0;
        for (const auto& node : stretch.nodes) {
            const double value = node.at(across_u ? 0 : 1);
            reach = std::max(reach, (at_low ? value : -value) - surface.knots_u.front());
        }
        if (const auto near = near_first_row(surface, reach, stretch)) {
            return near;
        }
    }
    return std::nullopt;
}

}  // namespace suture::certify

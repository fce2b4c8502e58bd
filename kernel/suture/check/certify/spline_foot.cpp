// The nearest points of a B-spline surface. With them proven: near a path x0(t) in the parameters,
// where f = |S - C|^2 / 2 is convex with a least curvature λ, the minimum of f over the domain is
// no farther from x0 than |projected gradient of f at x0| / λ. The path need not be exact for that.
#include "suture/check/certify/foot_point.h"
#include "suture/occ/handle.h"

#include <algorithm>
#include <numbers>

namespace suture::certify {

namespace {

constexpr int kPathDegree = 6;

// How far the box around a path reaches beyond it: this part of its width, and of the knot span's.
constexpr double kMargin = 0.25;
constexpr double kLeastMargin = 1e-3;

// A sampled parameter this near the domain's border, as a part of its width, lies on it.
constexpr double kOnBorder = 1e-12;

// One this far outside is another turn of a periodic surface.
constexpr double kLeaves = 1e-9;

constexpr std::size_t kMostPieces = 4;

/// The polynomial through values at path_points().
std::vector<double> interpolate(const std::vector<double>& values) {
    // Newton's form, multiplied out.
    const std::vector<double>& x = path_points();
    std::vector<double> d = values;
    for (std::size_t r = 1; r < d.size(); ++r) {
        for (std::size_t i = d.size() - 1; i >= r; --i) {
            d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - r]);
        }
    }
    std::vector<double> powers = {d.back()};
    for (std::size_t i = d.size() - 1; i-- > 0;) {
        powers.insert(powers.begin(), 0.0);
        for (std::size_t k = 0; k + 1 < powers.size(); ++k) {
            powers[k] -= x[i] * powers[k + 1];
        }
        powers[0] += d[i];
    }
    return powers;
}

/// One parameter along the stretch, in units of a box around it.
struct Path {
    Span box;
    TaylorModel model;                     ///< in [-1, 1] of the box
    double low = 0.0, high = 0.0;          ///< the domain in these units
    bool at_low = false, at_high = false;  ///< runs along the domain's border
    double outside = 0.0;                  ///< how far it leaves the domain
    std::vector<int> spans;                ///< k with knots[k] < knots[k + 1] that the box touches
    bool crease = false;                   ///< the box holds a knot at which the surface is only C0

    [[nodiscard]] double reach() const { return model.range().magnitude(); }
};

Path make_path(const std::vector<double>& nodes, const std::vector<double>& knots, int degree) {
    Path path;
    const auto p = static_cast<std::size_t>(degree);
    const double first = knots[p];
    const double last = knots[knots.size() - p - 1];
    const auto [least, most] = std::ranges::minmax(nodes);
    path.at_low = most - first <= kOnBorder * (last - first);
    path.at_high = last - least <= kOnBorder * (last - first);
    double span_width = last - first;
    for (std::size_t k = p; k + p + 1 < knots.size(); ++k) {
        if (knots[k] < knots[k + 1] && knots[k] <= most && knots[k + 1] >= least) {
            span_width = std::min(span_width, knots[k + 1] - knots[k]);
        }
    }
    if (least < first - kLeaves * (last - first) || most > last + kLeaves * (last - first)) {
        return path;
    }
    const double margin = kMargin * (most - least) + kLeastMargin * span_width;
    path.box = {least - margin, most + margin};
    for (std::size_t k = p; k + p + 1 < knots.size(); ++k) {
        if (knots[k] < knots[k + 1] && knots[k] < path.box.high && knots[k + 1] > path.box.low) {
            path.spans.push_back(static_cast<int>(k));
        }
        const bool inside = knots[k] > path.box.low && knots[k] < path.box.high;
        const auto repeated = std::ranges::count(knots, knots[k]);
        path.crease =
            path.crease || (inside && knots[k] > first && knots[k] < last && repeated >= degree);
    }
    const double middle = 0.5 * (path.box.low + path.box.high);
    const double half = 0.5 * (path.box.high - path.box.low);
    path.low = (first - middle) / half;
    path.high = (last - middle) / half;
    if (path.at_low || path.at_high) {
        path.model = TaylorModel(path.at_low ? path.low : path.high);
        return path;
    }
    std::vector<double> values(nodes.size());
    std::transform(nodes.begin(), nodes.end(), values.begin(),
                   [&](double node) { return (node - middle) / half; });
    path.model = TaylorModel(interpolate(values), 0.0);
    const Interval range = path.model.range();
    path.outside = std::max({0.0, path.low - range.low, range.high - path.high});
    return path;
}

/// The part of a gradient that a minimum inside the domain would not have: at its border only what
/// would lead inwards.
double projected(const Interval& gradient, const Path& path) {
    if (path.at_low) {
        return std::max(0.0, -gradient.low);
    }
    return path.at_high ? std::max(0.0, gradient.high) : gradient.magnitude();
}

/// What one polynomial piece says of the path.
struct PieceFoot {
    BezierPiece::Jet jet;
    BezierPiece::Bounds bounds;
    double gradient = 0.0;           ///< projected, with both parameters in lengths
    double least = 0.0, most = 0.0;  ///< of the Hessian's eigenvalues
};

/// Parameters per length, to make the Hessian about 1: the same for all pieces.
struct Scale {
    double alpha = 0.0, beta = 0.0;
};

std::optional<PieceFoot> look_at(const BezierPiece& piece, const Path& u, const Path& v,
                                 const TaylorModel3& curve, std::optional<Scale>& scale) {
    PieceFoot result;
    result.jet = piece.along(u.model, v.model);
    if (!known(result.jet.S) || !known(result.jet.Sx) || !known(result.jet.Sy)) {
        return std::nullopt;
    }
    result.bounds = piece.bounds();
    const auto length = [](const TaylorModel3& d) {
        return std::hypot(d[0].middle(), d[1].middle(), d[2].middle());
    };
    if (!scale) {
        scale = Scale{1.0 / length(result.jet.Sx), 1.0 / length(result.jet.Sy)};
    }
    const auto [alpha, beta] = *scale;
    const TaylorModel3 r = result.jet.S - curve;
    const double gu = projected(dot(r, result.jet.Sx).range(), u) * alpha;
    const double gv = projected(dot(r, result.jet.Sy).range(), v) * beta;
    result.gradient = std::hypot(gu, gv);
    const BezierPiece::Bounds& b = result.bounds;
    Interval3 apart;
    for (std::size_t i = 0; i < 3; ++i) {
        apart.at(i) = b.S.at(i) - curve.at(i).range();
    }
    const auto scaled = [](double factor, const Interval& a) {
        return Interval{factor, factor} * a;
    };
    const Interval a = scaled(alpha * alpha, dot(b.Sx, b.Sx) + dot(apart, b.Sxx));
    const Interval c = scaled(beta * beta, dot(b.Sy, b.Sy) + dot(apart, b.Syy));
    const Interval m = scaled(alpha * beta, dot(b.Sx, b.Sy) + dot(apart, b.Sxy));
    // Of [a m; m c]: the smaller eigenvalue grows with a and c, and falls with |m|.
    const double half = 0.5 * (a.low + c.low);
    result.least = (half - std::hypot(0.5 * (a.low - c.low), m.magnitude())) * (1.0 - 1e-12);
    result.most = a.magnitude() + c.magnitude() + 2.0 * m.magnitude();
    return std::isfinite(result.least) && std::isfinite(result.most) ? std::optional(result)
                                                                     : std::nullopt;
}

/// The foot of one piece, with room for the true parameters being up to `distance` off the path.
std::optional<Foot> foot_of(const PieceFoot& piece, const Scale& scale, double distance) {
    const BezierPiece::Bounds& b = piece.bounds;
    const double x = scale.alpha * distance;
    const double y = scale.beta * distance;
    const double sx = longest(b.Sx);
    const double sy = longest(b.Sy);
    Foot foot;
    foot.point = widened(piece.jet.S, sx * x + sy * y);
    const TaylorModel3 normal = cross(piece.jet.Sx, piece.jet.Sy);
    const double turned = (longest(b.Sxx) * sy + sx * longest(b.Sxy)) * x +
                          (longest(b.Sxy) * sy + sx * longest(b.Syy)) * y;
    const TaylorModel3 off = widened(normal, turned);
    foot.normal = inverse(sqrt(dot(off, off))) * off;
    return known(foot.point) && known(foot.normal) ? std::optional(foot) : std::nullopt;
}

}  // namespace

const std::vector<double>& path_points() {
    static const std::vector<double> points = [] {
        std::vector<double> result;
        for (int k = kPathDegree; k >= 0; --k) {
            result.push_back(std::cos(std::numbers::pi * (k + 0.5) / (kPathDegree + 1)));
        }
        return result;
    }();
    return points;
}

std::vector<Foot> CertifiedSurface::spline_feet(const Stretch& stretch, std::string& why) const {
    std::array<std::vector<double>, 2> nodes;
    for (const auto& node : stretch.nodes) {
        nodes[0].push_back(node[0]);
        nodes[1].push_back(node[1]);
    }
    const Path u = make_path(nodes[0], spline_->knots_u, spline_->degree_u);
    const Path v = make_path(nodes[1], spline_->knots_v, spline_->degree_v);
    why = "no bound at this length";
    if (u.spans.empty() || v.spans.empty()) {
        why = "the edge leaves the surface's parameter range";
        return {};
    }
    if (u.crease || v.crease) {
        why = "the edge runs along or across a knot at which the surface is only C0";
        return {};
    }
    if (u.spans.size() * v.spans.size() > kMostPieces) {
        return {};
    }
    std::vector<PieceFoot> pieces;
    std::optional<Scale> scale;
    double gradient = 0.0;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const int ku : u.spans) {
        for (const int kv : v.spans) {
            const BezierPiece piece(*spline_, ku, kv, u.box, v.box, stretch.origin);
            const auto found = look_at(piece, u, v, stretch.curve, scale);
            if (!found) {
                return {};
            }
            gradient = std::max(gradient, found->gradient);
            least = std::min(least, found->least);
            most = std::max(most, found->most);
            pieces.push_back(*found);
        }
    }
    if (!(least > 0.0)) {
        why = "the nearest point is not unique, or the surface is singular";
        return {};
    }
    const double outside = std::hypot(u.outside / scale->alpha, v.outside / scale->beta);
    const double distance = (gradient + most * outside) / least + outside;
    if (!(u.reach() + scale->alpha * distance <= 1.0) ||
        !(v.reach() + scale->beta * distance <= 1.0)) {
        return {};
    }
    std::vector<Foot> feet;
    for (const PieceFoot& piece : pieces) {
        const auto foot = foot_of(piece, *scale, distance);
        if (!foot) {
            return {};
        }
        feet.push_back(*foot);
    }
    return feet;
}

}  // namespace suture::certify

// The nearest points of a B-spline surface. With them proven: near a path x0(t) in the parameters,
// where f = |S - C|^2 / 2 is convex around it with a least curvature λ, the minimum of f over the
// domain is no farther from x0 than |projected gradient of f at x0| / λ. The path need not be exact
// for that.
#include "suture/check/certify/foot_point.h"
#include "suture/check/certify/spline_path.h"
#include "suture/occ/handle.h"

#include <algorithm>

namespace suture::certify {

namespace {

// One this far outside of the whole surface is another turn of a periodic one.
constexpr double kLeaves = 1e-9;

// Nodes this near to a knot with a kink, as a part of the surface's range, run along it.
constexpr double kOnKink = 1e-8;

constexpr std::size_t kMostPieces = 4;

// Normals of a converted surface, whose poles have been rounded.
constexpr double kTurnedByRounding = 1e-12;

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
    // From the edge to any point no farther from the path than the box's margins.
    const double around = longest(b.Sx) * (1.0 - u.reach()) + longest(b.Sy) * (1.0 - v.reach());
    Interval3 apart;
    for (std::size_t i = 0; i < 3; ++i) {
        const Interval range = r.at(i).range();
        apart.at(i) = Interval{range.low - around, range.high + around}.widened();
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

/// How far beyond the domain's border, and how much the surface's normals turn per length: what
/// feet on an offset surface need besides.
double beside_border(const PieceFoot& piece, const Foot& foot, double offset,
                     const TaylorModel3& curve, const Scale& scale) {
    // Held by the border, the nearest point of the offset is not that over the nearest point of
    // what it is offset from; but no farther from the edge, and so no farther from it than twice
    // its own distance.
    const double apart = 2.0 * longest(foot.point + TaylorModel(offset) * foot.normal - curve);
    const BezierPiece::Bounds& b = piece.bounds;
    const double xx = dot(b.Sx, b.Sx).low * scale.alpha * scale.alpha;
    const double yy = dot(b.Sy, b.Sy).low * scale.beta * scale.beta;
    const double xy = dot(b.Sx, b.Sy).magnitude() * scale.alpha * scale.beta;
    const double metric = 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
    const double bend = longest(b.Sxx) * scale.alpha * scale.alpha +
                        2.0 * longest(b.Sxy) * scale.alpha * scale.beta +
                        longest(b.Syy) * scale.beta * scale.beta;
    const double shrunk = 1.0 - std::abs(offset) * bend / metric;
    if (!(metric > 0.0) || !(shrunk > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    return apart / (shrunk * std::sqrt(metric));
}

/// Of each direction the values of the nodes.
std::vector<double> values_of(const Stretch& stretch, std::size_t direction) {
    std::vector<double> values;
    values.reserve(stretch.nodes.size());
    for (const auto& node : stretch.nodes) {
        values.push_back(node.at(direction));
    }
    return values;
}

}  // namespace
std::vector<Foot> feet_on(const SmoothPiece& smooth, double offset, const Stretch& stretch,
                          double& off_path, std::string& why) {
    off_path = std::numeric_limits<double>::infinity();
    const SplineSurface& surface = smooth.surface;
    const auto ends_in_a_point = [&](bool across_u) {
        std::array<bool, 2> ends = {false, false};
        for (const PoleOfSpline& pole : smooth.poles) {
            ends.at(pole.at_low ? 0 : 1) |= pole.across_u == across_u;
        }
        return ends;
    };
    const auto any = [](const std::array<bool, 2>& ends) { return ends[0] || ends[1]; };
    const auto ends_u = ends_in_a_point(true);
    const auto ends_v = ends_in_a_point(false);
    const Path u =
        make_path(values_of(stretch, 0), surface.knots_u, surface.degree_u, ends_u, any(ends_v));
    const Path v =
        make_path(values_of(stretch, 1), surface.knots_v, surface.degree_v, ends_v, any(ends_u));
    why = "no bound at this length";
    if (u.spans.size() * v.spans.size() > kMostPieces) {
        return {};
    }
    std::vector<PieceFoot> pieces;
    std::optional<Scale> scale;
    double off = 0.0;
    double gradient = 0.0;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const int ku : u.spans) {
        for (const int kv : v.spans) {
            const BezierPiece piece(surface, ku, kv, u.box, v.box, stretch.origin);
            const auto found = look_at(piece, u, v, stretch.curve, scale);
            if (!found) {
                return {};
            }
            off = std::max(off, longest(found->jet.S - stretch.curve));
            gradient = std::max(gradient, found->gradient);
            least = std::min(least, found->least);
            most = std::max(most, found->most);
            pieces.push_back(*found);
        }
    }
    if (u.outside == 0.0 && v.outside == 0.0) {
        off_path = off;
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
    const bool held = u.at_low || u.at_high || v.at_low || v.at_high || outside > 0.0;
    std::vector<Foot> feet;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const PieceFoot& piece = pieces[i];
        if (!u.may_be_in(i / v.spans.size(), scale->alpha * distance) ||
            !v.may_be_in(i % v.spans.size(), scale->beta * distance)) {
            continue;
        }
        auto foot = foot_of(piece, *scale, distance);
        if (foot && offset != 0.0 && held) {
            foot = foot_of(piece, *scale,
                           distance + beside_border(piece, *foot, offset, stretch.curve, *scale));
        }
        if (!foot) {
            return {};
        }
        if (offset != 0.0) {
            foot->point = foot->point + TaylorModel(offset) * foot->normal;
        }
        feet.push_back(*foot);
    }
    return feet;
}

std::vector<Foot> CertifiedSurface::spline_feet(const Stretch& stretch, std::string& why) const {
    const auto at_pole = [&](double off_path) -> std::vector<Foot> {
        for (const SmoothPiece& smooth : spline_->pieces()) {
            const auto near = near_pole(smooth.poles, stretch);
            if (near && spline_->offset() == 0.0) {
                // The nearest point is no farther than the pole, nor than the path.
                return {{widened(stretch.curve, std::min(off_path, near->distance)), near->normal}};
            }
        }
        return {};
    };
    // For each direction the nodes' range; what only touches a kink does not cross it.
    std::array<Span, 2> reach;
    for (const std::size_t k : {0U, 1U}) {
        const std::vector<double> values = values_of(stretch, k);
        const auto [least, most] = std::ranges::minmax(values);
        const auto [first, last] = spline_->range(k);
        if (least < first - kLeaves * (last - first) || most > last + kLeaves * (last - first)) {
            why = "the edge leaves the surface's parameter range";
            return at_pole(std::numeric_limits<double>::infinity());
        }
        const double on_kink = kOnKink * (last - first);
        if (most - least > 2.0 * on_kink) {
            reach.at(k) = {least + on_kink, most - on_kink};
        } else {
            const double side =
                std::clamp(0.5 * (least + most) + stretch.inward.at(k), first, last);
            reach.at(k) = {side, side};
        }
    }
    std::vector<Foot> feet;
    for (const SmoothPiece& smooth : spline_->pieces()) {
        const SplineSurface& surface = smooth.surface;
        const auto touches = [](const std::vector<double>& knots, const Span& span) {
            return knots.front() <= span.high && span.low <= knots.back();
        };
        if (!touches(surface.knots_u, reach[0]) || !touches(surface.knots_v, reach[1])) {
            continue;
        }
        double off_path = 0.0;
        std::vector<Foot> found = feet_on(smooth, spline_->offset(), stretch, off_path, why);
        if (found.empty()) {
            found = at_pole(off_path);
        }
        if (found.empty()) {
            return {};
        }
        for (Foot& foot : found) {
            foot.point = widened(foot.point, spline_->rounding());
            foot.normal = widened(foot.normal, spline_->rounding() > 0.0 ? kTurnedByRounding : 0.0);
            feet.push_back(foot);
        }
    }
    return feet;
}

}  // namespace suture::certify

#include "suture/check/certify/certify_edges.h"

#include "suture/check/certify/edge_curve.h"
#include "suture/check/certify/foot_point.h"
#include "suture/check/certify/spline_path.h"
#include "suture/check/edge_uses.h"
#include "suture/check/face_side.h"
#include "suture/check/measure_edge.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <TopoDS.hxx>

#include <queue>

namespace suture {

namespace {

using certify::Span;

// An edge is divided into no more stretches than this, and into none shorter than this part of its
// parameter range: a singular point can be approached for ever.
constexpr int kMostStretches = 3000;
constexpr double kShortest = 1e-10;

// Where so many divisions did not lower the worst bound to this part, it is what rounding leaves,
// or what is there: nothing more comes of dividing.
constexpr int kPatience = 50;
constexpr double kLowered = 0.8;

// Of the limits: an edge that keeps them by far need not be bounded more sharply than this part of
// them allows.
constexpr double kPartOfLimit = 0.2;

// Where an edge crosses a kink is looked for between so many points, and found by so many halvings.
constexpr int kCrossingSamples = 64;
constexpr int kCrossingSteps = 45;

// By how much two evaluations of the same point and normal may differ.
constexpr double kGapRounding = 1e-14;
constexpr double kAngleRounding = 1e-8;

/// Bounds on one stretch of an edge; infinite where nothing is known.
struct Bound {
    Span range;
    double gap = std::numeric_limits<double>::infinity();
    double angle = std::numeric_limits<double>::infinity();
    std::string why;
};

/// No angle between two unit vectors is larger, by their cross product and by their dot product.
double largest_angle(const certify::TaylorModel3& a, const certify::TaylorModel3& b) {
    const certify::TaylorModel cosine = dot(a, b);
    const certify::Interval range = cosine.range();
    const certify::TaylorModel3 sine = cross(a, b);
    constexpr double kSafe = 1e-15;  // of arc sine and arc cosine
    double angle = std::acos(std::clamp(range.low, -1.0, 1.0)) + kSafe;
    const double most = longest(sine);
    if (range.low >= 0.0 && most < 1.0) {
        angle = std::min(angle, std::asin(most) + kSafe);
    }
    const double least = std::sqrt(std::max(0.0, dot(sine, sine).lower()));
    if (range.high <= 0.0) {
        angle = std::min(angle, kPi - std::asin(std::min(1.0, least)) + kSafe);
    }
    return angle;
}

class EdgeProver {
  public:
    EdgeProver(const TopoDS_Edge& edge, const std::array<TopoDS_Face, 2>& faces,
               const std::array<EdgeInFace, 2>& uses)
        : curve_(edge),
          adaptor_(edge),
          range_{adaptor_.FirstParameter(), adaptor_.LastParameter()},
          sides_{FaceSide(faces[0], uses[0].edge, range_, length_of(edge, adaptor_)),
                 FaceSide(faces[1], uses[1].edge, range_, length_of(edge, adaptor_))},
          surfaces_{certify::CertifiedSurface(faces[0]), certify::CertifiedSurface(faces[1])},
          uses_(uses) {}

    /// Input  gap_seen, angle_seen: largest that were measured; what is seen here may raise them.
    EdgeCertificate prove(double gap_seen, double angle_seen, const Tolerance& limit,
                          double slack) {
        seen_ = {gap_seen, angle_seen};
        EdgeCertificate result;
        result.reason = obstacle();
        if (!result.reason.empty()) {
            return result;
        }
        if (surfaces_[0].same_elementary(surfaces_[1])) {
            // One nearest point for both, and normals that agree everywhere or nowhere.
            certify::Stretch middle;
            middle.range = curve_.pieces().front();
            const auto one = sample(0, middle).normal;
            const auto two = sample(1, middle).normal;
            const bool opposite = one && two && *one * *two < 0.0;
            result.gap = gap_seen + kGapRounding * middle_size();
            result.angle = opposite ? kPi : angle_seen + kAngleRounding;
            result.certified = result.within_slack = true;
            result.stretches = 1;
            return result;
        }
        const auto wanted = [&](double seen, double most) {
            return seen + slack * std::max(seen, kPartOfLimit * most);
        };
        const auto excess = [&](const Bound& bound) {
            return std::max(bound.gap / wanted(seen_.gap, limit.linear),
                            bound.angle / wanted(seen_.angle, limit.angular));
        };
        const auto better = [&](const Bound& a, const Bound& b) { return excess(a) < excess(b); };
        std::priority_queue<Bound, std::vector<Bound>, decltype(better)> open(better);
        for (const Span& piece : pieces()) {
            open.push(bound(piece));
            ++result.stretches;
        }
        double before = std::numeric_limits<double>::infinity();
        int next_look = result.stretches + kPatience;
        const double shortest = kShortest * (range_.last - range_.first);
        while (!open.empty() && excess(open.top()) > 1.0 && result.stretches < kMostStretches) {
            const Bound worst = open.top();
            if (worst.range.high - worst.range.low < shortest) {
                break;
            }
            if (result.stretches >= next_look) {
                const double now = excess(worst);
                if (std::isfinite(now) && now > kLowered * before) {
                    break;
                }
                before = now;
                next_look += kPatience;
            }
            open.pop();
            const double middle = 0.5 * (worst.range.low + worst.range.high);
            open.push(bound({worst.range.low, middle}));
            open.push(bound({middle, worst.range.high}));
            ++result.stretches;
        }
        for (; !open.empty(); open.pop()) {
            const Bound& last = open.top();
            result.gap = std::max(result.gap, last.gap);
            result.angle = std::max(result.angle, last.angle);
            if (!std::isfinite(last.gap) || !std::isfinite(last.angle)) {
                const gp_Pnt at = adaptor_.Value(0.5 * (last.range.low + last.range.high));
                result.reason =
                    fmt::format("{}, at ({:.6g} {:.6g} {:.6g})", last.why, at.X(), at.Y(), at.Z());
                return result;
            }
        }
        result.certified = true;
        result.within_slack = result.gap <= wanted(seen_.gap, limit.linear) &&
                              result.angle <= wanted(seen_.angle, limit.angular);
        return result;
    }

  private:
    [[nodiscard]] std::string obstacle() const {
        for (const std::size_t i : {0U, 1U}) {
            if (!surfaces_.at(i).reason().empty()) {
                return fmt::format("Face{} is {}", uses_.at(i).face, surfaces_.at(i).reason());
            }
        }
        return curve_.reason();
    }

    /// The largest coordinate in the middle: how large roundings may be.
    [[nodiscard]] double middle_size() const {
        const gp_Pnt p = adaptor_.Value(0.5 * (range_.first + range_.last));
        return std::max({std::abs(p.X()), std::abs(p.Y()), std::abs(p.Z())}) + 1.0;
    }

    /// The curve's pieces, divided where the nearest points cross a kink of their surface.
    std::vector<Span> pieces() {
        std::vector<double> cuts;
        for (const std::size_t i : {0U, 1U}) {
            for (const std::size_t k : {0U, 1U}) {
                for (const double kink : surfaces_.at(i).kinks(k)) {
                    add_crossings(i, k, kink, cuts);
                }
            }
        }
        std::vector<Span> pieces = curve_.pieces();
        for (const double cut : cuts) {
            const auto at = std::ranges::find_if(
                pieces, [&](const Span& piece) { return piece.low < cut && cut < piece.high; });
            if (at != pieces.end()) {
                const Span rest{cut, at->high};
                at->high = cut;
                pieces.insert(at + 1, rest);
            }
        }
        return pieces;
    }

    void add_crossings(std::size_t i, std::size_t k, double kink, std::vector<double>& cuts) {
        const auto beyond = [&](double t) {
            const gp_Pnt at = adaptor_.Value(t);
            return surfaces_.at(i).node(sides_.at(i).parameters(t, at), at).at(k) - kink;
        };
        double before_t = range_.first;
        double before = beyond(before_t);
        for (int sample = 1; sample <= kCrossingSamples; ++sample) {
            const double t =
                range_.first + (range_.last - range_.first) * sample / kCrossingSamples;
            const double now = beyond(t);
            if (before * now < 0.0) {
                double low = before_t;
                double high = t;
                for (int step = 0; step < kCrossingSteps; ++step) {
                    const double middle = 0.5 * (low + high);
                    ((beyond(middle) < 0.0) == (before < 0.0) ? low : high) = middle;
                }
                cuts.push_back(0.5 * (low + high));
            }
            before_t = t;
            before = now;
        }
    }

    Bound bound(const Span& range) {
        Bound result;
        result.range = range;
        const gp_Pnt origin = adaptor_.Value(0.5 * (range.low + range.high));
        certify::Stretch stretch;
        stretch.range = range;
        stretch.origin = {origin.X(), origin.Y(), origin.Z()};
        stretch.curve = curve_.model(range, stretch.origin);
        if (!known(stretch.curve)) {
            result.why = "no bound at this length";
            return result;
        }
        std::array<std::vector<certify::Foot>, 2> feet;
        std::array<BorderPoint, 2> seen;
        for (const std::size_t i : {0U, 1U}) {
            seen.at(i) = sample(i, stretch);
            if (!seen.at(i).normal) {
                result.why = fmt::format("Face{} has no normal", uses_.at(i).face);
                return result;
            }
            feet.at(i) = surfaces_.at(i).feet(stretch, result.why);
            if (feet.at(i).empty()) {
                result.why = fmt::format("Face{}: {}", uses_.at(i).face, result.why);
                return result;
            }
        }
        seen_.gap = std::max(seen_.gap, seen[0].point.Distance(seen[1].point));
        seen_.angle = std::max(seen_.angle, seen[0].normal->Angle(*seen[1].normal));
        result.gap = result.angle = 0.0;
        for (const certify::Foot& one : feet[0]) {
            for (const certify::Foot& two : feet[1]) {
                result.gap = std::max(result.gap, longest(one.point - two.point));
                result.angle = std::max(result.angle, largest_angle(one.normal, two.normal));
            }
        }
        return result;
    }

    /// The side in the middle, and the sampled path of the nearest point.
    BorderPoint sample(std::size_t i, certify::Stretch& stretch) {
        FaceSide& side = sides_.at(i);
        const double middle = 0.5 * (stretch.range.low + stretch.range.high);
        const double half = 0.5 * (stretch.range.high - stretch.range.low);
        gp_Pnt point;
        gp_Vec tangent;
        adaptor_.D1(middle, point, tangent);
        const BorderPoint seen = side.at(middle, point, tangent);
        if (!seen.normal) {
            return seen;
        }
        stretch.normal = *seen.normal;
        stretch.nodes.clear();
        if (!surfaces_.at(i).is_elementary()) {
            for (const double x : certify::path_points()) {
                const double t = middle + half * x;
                const gp_Pnt at = adaptor_.Value(t);
                stretch.nodes.push_back(surfaces_.at(i).node(side.parameters(t, at), at));
            }
            const gp_Vec2d inward = side.off_breaks(middle, side.parameters(middle, point));
            stretch.inward = {inward.X(), inward.Y()};
        }
        return seen;
    }

    struct Seen {
        double gap = 0.0, angle = 0.0;
    };
    Seen seen_;
    certify::EdgeCurve curve_;
    BRepAdaptor_Curve adaptor_;
    EdgeRange range_;
    std::array<FaceSide, 2> sides_;
    std::array<certify::CertifiedSurface, 2> surfaces_;
    std::array<EdgeInFace, 2> uses_;
};

}  // namespace

Result<std::vector<EdgeCertificate>> certify_edges(const TopoDS_Shape& shape,
                                                   const std::vector<EdgeContinuity>& edges,
                                                   const Profile& profile, double slack,
                                                   const Progress& progress) {
    if (!(slack > 0.0)) {
        return fail(ErrorCode::Usage, "the slack of a certificate must be positive, not {}", slack);
    }
    std::vector<EdgeCertificate> certificates(edges.size());
    if (edges.empty()) {
        return certificates;
    }
    const occ::Numbering numbering(shape);
    std::vector<int> numbers;
    numbers.reserve(edges.size());
    for (const EdgeContinuity& edge : edges) {
        numbers.push_back(edge.edge);
    }
    const auto all_uses = find_edge_uses(numbering, numbers);
    tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
        const EdgeContinuity& edge = edges[i];
        EdgeCertificate& result = certificates[i];
        if (progress.cancelled()) {
            return;
        }
        const auto& uses = all_uses.at(static_cast<std::size_t>(edge.edge - 1));
        const auto face = [&](std::size_t k) {
            return TopoDS::Face(numbering.faces(uses.at(k).face));
        };
        auto proven = occ::guarded("certifying the edge", [&] {
            return EdgeProver(TopoDS::Edge(numbering.edges(edge.edge)), {face(0), face(1)},
                              {uses.at(0), uses.at(1)})
                .prove(edge.max_gap, edge.max_angle, profile.tolerance, slack);
        });
        if (proven) {
            result = std::move(*proven);
        } else {
            result.reason = proven.error().message;
        }
        result.edge = edge.edge;
    });
    if (progress.cancelled()) {
        return fail(ErrorCode::Cancelled, "certifying was stopped");
    }
    return certificates;
}

}  // namespace suture

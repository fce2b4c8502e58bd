#include "suture/check/certify/certify_edges.h"

#include "suture/check/certify/edge_curve.h"
#include "suture/check/certify/foot_point.h"
#include "suture/check/edge_uses.h"
#include "suture/check/face_side.h"
#include "suture/check/measure_edge.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <BRep_Tool.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopoDS.hxx>

#include <queue>

namespace suture {

namespace {

using certify::Span;

// An edge is divided into no more stretches than this, and into none shorter than this part of its
// parameter range: a singular point can be approached for ever.
constexpr int kMostStretches = 3000;
constexpr double kShortest = 1e-7;

// Of the limits: an edge that keeps them by far need not be bounded more sharply than this part of
// them allows.
constexpr double kPartOfLimit = 0.2;

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
          surfaces_{surface_of(faces[0]), surface_of(faces[1])},
          uses_(uses) {}

    EdgeCertificate prove(double gap_wanted, double angle_wanted) {
        EdgeCertificate result;
        result.reason = obstacle();
        if (!result.reason.empty()) {
            return result;
        }
        const auto excess = [&](const Bound& bound) {
            return std::max(bound.gap / gap_wanted, bound.angle / angle_wanted);
        };
        const auto better = [&](const Bound& a, const Bound& b) { return excess(a) < excess(b); };
        std::priority_queue<Bound, std::vector<Bound>, decltype(better)> open(better);
        for (const Span& piece : curve_.pieces()) {
            open.push(bound(piece));
            ++result.stretches;
        }
        const double shortest = kShortest * (range_.last - range_.first);
        while (!open.empty() && excess(open.top()) > 1.0 && result.stretches < kMostStretches) {
            const Bound worst = open.top();
            if (worst.range.high - worst.range.low < shortest) {
                break;
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
        result.within_slack = result.gap <= gap_wanted && result.angle <= angle_wanted;
        return result;
    }

  private:
    static certify::CertifiedSurface surface_of(const TopoDS_Face& face) {
        auto surface = BRep_Tool::Surface(face);
        while (const auto trimmed = occ::cast<Geom_RectangularTrimmedSurface>(surface)) {
            surface = trimmed->BasisSurface();
        }
        return certify::CertifiedSurface(surface);
    }

    [[nodiscard]] std::string obstacle() const {
        for (const std::size_t i : {0U, 1U}) {
            if (!surfaces_.at(i).reason().empty()) {
                return fmt::format("Face{} is {}", uses_.at(i).face, surfaces_.at(i).reason());
            }
        }
        return curve_.reason();
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
        for (const std::size_t i : {0U, 1U}) {
            if (!sample(sides_.at(i), surfaces_.at(i).is_spline(), stretch)) {
                result.why = fmt::format("Face{} has no normal", uses_.at(i).face);
                return result;
            }
            feet.at(i) = surfaces_.at(i).feet(stretch, result.why);
            if (feet.at(i).empty()) {
                result.why = fmt::format("Face{}: {}", uses_.at(i).face, result.why);
                return result;
            }
        }
        result.gap = result.angle = 0.0;
        for (const certify::Foot& one : feet[0]) {
            for (const certify::Foot& two : feet[1]) {
                result.gap = std::max(result.gap, longest(one.point - two.point));
                result.angle = std::max(result.angle, largest_angle(one.normal, two.normal));
            }
        }
        return result;
    }

    /// The sampled normal in the middle, and the sampled path of the nearest point.
    bool sample(FaceSide& side, bool with_path, certify::Stretch& stretch) {
        const double middle = 0.5 * (stretch.range.low + stretch.range.high);
        const double half = 0.5 * (stretch.range.high - stretch.range.low);
        gp_Pnt point;
        gp_Vec tangent;
        adaptor_.D1(middle, point, tangent);
        const auto normal = side.at(middle, point, tangent).normal;
        if (!normal) {
            return false;
        }
        stretch.normal = *normal;
        stretch.nodes.clear();
        if (with_path) {
            for (const double x : certify::path_points()) {
                const double t = middle + half * x;
                const gp_Pnt2d uv = side.parameters(t, adaptor_.Value(t));
                stretch.nodes.push_back({uv.X(), uv.Y()});
            }
        }
        return true;
    }

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
    const auto wanted = [&](double measured, double limit) {
        return measured + slack * std::max(measured, kPartOfLimit * limit);
    };
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
                .prove(wanted(edge.max_gap, profile.tolerance.linear),
                       wanted(edge.max_angle, profile.tolerance.angular));
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

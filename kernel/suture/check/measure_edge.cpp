#include "suture/check/measure_edge.h"

#include "suture/check/face_side.h"
#include "suture/occ/guard.h"

#include <fmt/ranges.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <TopAbs.hxx>

#include <algorithm>
#include <cmath>

namespace suture {

namespace {

// A straight edge between planes: the gap is convex and the angle constant along it, so that both
// ends say all; one point between guards against an edge that is not what it says.
constexpr int kSamplesStraight = 3;
// Conics on elementary surfaces have no more than a few maxima.
constexpr int kSamplesElementary = 17;
// Otherwise: for each polynomial piece that the edge or its surfaces have along it four points, or
// twice as many as an angle's waves can have turns, degree - 2: OCCT's filling makes few pieces of
// degree 14 with waves in each.
constexpr int kSamplesLeast = 33;
constexpr int kSamplesPerPiece = 4;
constexpr int kSamplesMost = 513;

// A fitted surface errs most, and in the narrowest waves, next to its corners: of an edge that is
// no conic between elementary surfaces, each of the first and last steps is divided further.
constexpr int kEndSteps = 3;
constexpr int kEndDivisions = 4;

// Pieces that the even division does not reach with so many points get them on their own, if they
// are longer than this part of the edge: knots may crowd towards a corner.
constexpr double kLeastPiece = 1e-5;

// Where between two steps of the even division an inner sample lies: off the middle, so that it
// does not fall on knots, which tend to lie at round parameters.
constexpr double kOffset = 0.38;

// Local maxima that seem to reach this part of the largest one are refined, at most so many, until
// the value settles to kSettled, in at most kRefineSteps steps of the golden section.
constexpr double kWorthRefining = 0.5;
constexpr int kRefineMost = 12;
constexpr double kSettled = 1e-3;
constexpr int kRefineSteps = 24;

// Below these, values are rounding noise and are not refined: angles in radians, gaps against the
// edge's length, curvature mismatches.
constexpr double kNoiseAngle = 1e-8;
constexpr double kNoiseGap = 1e-10;
constexpr double kNoiseMismatch = 1e-4;

// A face that turns by less than this angle over a width equal to the edge's length is flat: its
// curvature is not compared. It is half of the G1 angle that no eye sees (0.01 deg).
constexpr double kFlatTurning = 1e-4;

// Two normals farther apart than this are a knife edge, or the faces are oriented inconsistently.
constexpr double kKnifeAngle = radians(179.0);

struct Sample {
    double t = 0.0;
    gp_Pnt point;
    double speed = 0.0;
    // What could not be measured is below every value.
    double gap = -1.0, edge_gap = -1.0, angle = -1.0, mismatch = -1.0, mismatch_sum = -1.0;
    double excess = 0.0;  ///< of the first face's curvature over the second's, both unsigned
    bool opposite = false;
    bool failed = false;
};

/// How the face, as oriented in the shape, runs along the edge.
TopAbs_Orientation direction(const TopoDS_Face& face, const EdgeUse& use) {
    return TopAbs::Compose(face.Orientation(), use.edge.Orientation());
}

/// Not of the edge's adaptor: GCPnts takes a line's length from its parameters, which is wrong
/// under a location that scales.
double length_of(const TopoDS_Edge& edge, const BRepAdaptor_Curve& adaptor) {
    TopLoc_Location location;
    double first = 0.0;
    double last = 0.0;
    const auto curve = BRep_Tool::Curve(edge, location, first, last);
    if (curve.IsNull()) {
        return GCPnts_AbscissaPoint::Length(adaptor);
    }
    return std::abs(location.Transformation().ScaleFactor()) *
           GCPnts_AbscissaPoint::Length(GeomAdaptor_Curve(curve, first, last));
}

Eigen::Vector3d to_eigen(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}

class EdgeMeter {
  public:
    EdgeMeter(const TopoDS_Edge& edge, const std::array<TopoDS_Face, 2>& faces,
              const std::array<EdgeUse, 2>& uses)
        : curve_(edge),
          range_{curve_.FirstParameter(), curve_.LastParameter()},
          length_(length_of(edge, curve_)),
          sides_{FaceSide(faces[0], uses[0].edge, range_, length_),
                 FaceSide(faces[1], uses[1].edge, range_, length_)},
          same_direction_(direction(faces[0], uses[0]) == direction(faces[1], uses[1])) {}

    EdgeContinuity run();

  private:
    [[nodiscard]] std::vector<double> parameters() const;
    Sample measure(double t);
    void measure_into(Sample& sample);
    void compare_curvatures(Sample& sample, double k1, double k2) const;
    void record(const Sample& sample);
    void refine(const std::vector<Sample>& samples, double Sample::*value, double noise);
    void refine_kinks(const std::vector<Sample>& samples);
    void golden(double low, double high, double Sample::*value, double best);
    void set_mean_angle(const std::vector<Sample>& samples);
    void set_note();

    BRepAdaptor_Curve curve_;
    EdgeRange range_;
    double length_;
    std::array<FaceSide, 2> sides_;
    bool same_direction_;
    EdgeContinuity result_;
    int tried_ = 0, without_normal_ = 0, failed_ = 0;
};

/// Both ends, and points between them.
std::vector<double> EdgeMeter::parameters() const {
    const bool conic = curve_.GetType() <= GeomAbs_Ellipse;
    const bool elementary = conic && sides_[0].is_elementary() && sides_[1].is_elementary();
    const bool straight = elementary && curve_.GetType() == GeomAbs_Line && sides_[0].is_plane() &&
                          sides_[1].is_plane();
    const int pieces =
        std::max({curve_.NbIntervals(GeomAbs_CN), sides_[0].pieces(), sides_[1].pieces()});
    const int degree = std::max(sides_[0].degree(), sides_[1].degree());
    const int per_piece = std::max(kSamplesPerPiece, 2 * (degree - 2));
    const int count = straight ? kSamplesStraight
                      : elementary
                          ? kSamplesElementary
                          : std::clamp(per_piece * pieces + 1, kSamplesLeast, kSamplesMost);
    std::vector<double> fractions = {0.0};
    for (int i = 1; i < count - 1; ++i) {
        fractions.push_back((i - kOffset) / (count - 2));
    }
    fractions.push_back(1.0);
    if (!elementary) {
        for (const int first : {0, count - 1 - kEndSteps}) {
            for (int i = first; i < first + kEndSteps; ++i) {
                const double low = fractions[static_cast<std::size_t>(i)];
                const double step = fractions[static_cast<std::size_t>(i) + 1] - low;
                for (int k = 1; k < kEndDivisions; ++k) {
                    fractions.push_back(low + step * k / kEndDivisions);
                }
            }
        }
        const double even = 1.0 / (count - 2);
        std::vector<double> ends = {0.0, 1.0};
        for (const FaceSide& side : sides_) {
            ends.insert(ends.end(), side.passages().begin(), side.passages().end());
        }
        std::ranges::sort(ends);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const double piece = ends[i + 1] - ends[i];
            for (int k = 0; piece > kLeastPiece && piece < per_piece * even && k < per_piece; ++k) {
                fractions.push_back(ends[i] + piece * (k + kOffset) / per_piece);
            }
        }
        std::ranges::sort(fractions);
    }
    for (double& s : fractions) {
        s = range_.first + s * (range_.last - range_.first);
    }
    return fractions;
}

void EdgeMeter::compare_curvatures(Sample& sample, double k1, double k2) const {
    const double flat = kFlatTurning / length_;
    const double largest = std::max(std::abs(k1), std::abs(k2));
    if (largest <= flat) {
        sample.mismatch = sample.mismatch_sum = 0.0;
        return;
    }
    sample.mismatch = std::abs(k1 - k2) / largest;
    sample.mismatch_sum = std::abs(k1 - k2) / (std::abs(k1) + std::abs(k2));
    sample.excess = std::abs(k1) - std::abs(k2);
    sample.opposite = k1 * k2 < 0.0 && std::min(std::abs(k1), std::abs(k2)) > flat;
}

void EdgeMeter::measure_into(Sample& sample) {
    gp_Vec tangent;
    curve_.D1(sample.t, sample.point, tangent);
    sample.speed = tangent.Magnitude();
    const BorderPoint one = sides_[0].at(sample.t, sample.point, tangent);
    const BorderPoint two = sides_[1].at(sample.t, sample.point, tangent);
    sample.gap = one.point.Distance(two.point);
    sample.edge_gap = std::max(sample.point.Distance(one.point), sample.point.Distance(two.point));
    if (one.normal && two.normal) {
        sample.angle =
            std::atan2(one.normal->CrossMagnitude(*two.normal), *one.normal * *two.normal);
    }
    if (one.curvature && two.curvature) {
        compare_curvatures(sample, *one.curvature, *two.curvature);
    }
}

Sample EdgeMeter::measure(double t) {
    Sample sample;
    sample.t = t;
    if (!occ::guarded("measuring an edge", [&] { measure_into(sample); })) {
        sample.failed = true;
    }
    record(sample);
    return sample;
}

void EdgeMeter::record(const Sample& sample) {
    ++tried_;
    if (sample.failed) {
        ++failed_;
        return;
    }
    if (sample.gap >= result_.max_gap) {
        result_.max_gap = sample.gap;
        result_.gap_at = to_eigen(sample.point);
    }
    result_.edge_gap = std::max(result_.edge_gap, sample.edge_gap);
    if (sample.angle < 0.0) {
        ++without_normal_;
        return;
    }
    ++result_.samples;
    if (sample.angle >= result_.max_angle) {
        result_.max_angle = sample.angle;
        result_.angle_at = to_eigen(sample.point);
    }
    if (sample.mismatch < 0.0) {
        return;
    }
    ++result_.curvature_samples;
    if (sample.mismatch >= result_.curvature_mismatch) {
        result_.curvature_mismatch = sample.mismatch;
        result_.curvature_at = to_eigen(sample.point);
    }
    result_.curvature_mismatch_sum = std::max(result_.curvature_mismatch_sum, sample.mismatch_sum);
    result_.opposite_concavity = result_.opposite_concavity || sample.opposite;
}

void EdgeMeter::golden(double low, double high, double Sample::*value, double best) {
    constexpr double ratio = 1.0 / std::numbers::phi;
    double left = high - ratio * (high - low);
    double right = low + ratio * (high - low);
    double at_left = measure(left).*value;
    double at_right = measure(right).*value;
    for (int step = 0; step < kRefineSteps; ++step) {
        best = std::max({best, at_left, at_right});
        // The whole bracket is as high as its highest point, smooth peak or kink.
        if (std::min(at_left, at_right) >= best * (1.0 - kSettled)) {
            return;
        }
        if (at_left >= at_right) {
            high = right;
            right = left;
            at_right = at_left;
            left = high - ratio * (high - low);
            at_left = measure(left).*value;
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = low + ratio * (high - low);
            at_right = measure(right).*value;
        }
    }
}

/// Of the parabola through an inner sample that is a peak and its neighbours.
double top_of_parabola(const std::vector<Sample>& samples, std::size_t i, double Sample::*value) {
    const Sample& m = samples[i];
    const double before = samples[i - 1].t - m.t;
    const double after = samples[i + 1].t - m.t;
    const double slope_before = (samples[i - 1].*value - m.*value) / before;
    const double slope_after = (samples[i + 1].*value - m.*value) / after;
    const double bend = (slope_after - slope_before) / (after - before);
    const double slope = slope_before - bend * before;
    return bend < 0.0 ? m.*value - slope * slope / (4.0 * bend) : m.*value;
}

void EdgeMeter::refine(const std::vector<Sample>& samples, double Sample::*value, double noise) {
    const auto at = [&](std::size_t i) { return samples[i].*value; };
    const std::size_t last = samples.size() - 1;
    std::vector<std::size_t> peaks;
    for (std::size_t i = 0; i <= last; ++i) {
        const double before = at(i > 0 ? i - 1 : i + 1);
        const double after = at(i < last ? i + 1 : i - 1);
        const bool peak = at(i) >= before && at(i) >= after;
        const bool settled = std::min(before, after) >= at(i) * (1.0 - 0.25 * kSettled);
        if (peak && !settled && at(i) > noise) {
            peaks.push_back(i);
        }
    }
    const auto height = [&](std::size_t i) {
        return i == 0 || i == last ? at(i) : top_of_parabola(samples, i, value);
    };
    std::ranges::stable_sort(peaks, std::greater(), height);
    for (std::size_t k = 0; k < std::min<std::size_t>(peaks.size(), kRefineMost); ++k) {
        const std::size_t i = peaks[k];
        if (height(i) >= kWorthRefining * height(peaks.front())) {
            golden(samples[i > 0 ? i - 1 : i].t, samples[std::min(i + 1, last)].t, value, at(i));
        }
    }
}

/// Of two faces that bend opposite ways the mismatch has a kink, and its peak, where they bend
/// alike: it may be too narrow to raise a sample.
void EdgeMeter::refine_kinks(const std::vector<Sample>& samples) {
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const Sample& a = samples[i - 1];
        const Sample& b = samples[i];
        if (a.excess * b.excess < 0.0 && (a.opposite || b.opposite)) {
            golden(a.t, b.t, &Sample::mismatch, std::max(a.mismatch, b.mismatch));
        }
    }
}

void EdgeMeter::set_mean_angle(const std::vector<Sample>& samples) {
    double sum = 0.0;
    double weight = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const Sample& a = samples[i - 1];
        const Sample& b = samples[i];
        if (a.angle >= 0.0 && b.angle >= 0.0) {
            const double step = 0.5 * (a.speed + b.speed) * (b.t - a.t);
            sum += 0.5 * (a.angle + b.angle) * step;
            weight += step;
        }
    }
    result_.mean_angle = weight > 0.0 ? sum / weight : result_.max_angle;
}

void EdgeMeter::set_note() {
    std::vector<std::string> parts;
    if (failed_ > 0) {
        parts.push_back(fmt::format("OCCT could not evaluate {} of {} samples", failed_, tried_));
    }
    if (without_normal_ > 0) {
        parts.push_back(fmt::format("no normal at {} of {} samples: singular surface",
                                    without_normal_, tried_));
    }
    if (result_.samples > 0 && result_.curvature_samples == 0) {
        parts.emplace_back("no curvature at any sample");
    }
    if (same_direction_) {
        parts.emplace_back(
            "the two faces are oriented inconsistently: both use the edge in the "
            "same direction");
    } else if (result_.max_angle > kKnifeAngle) {
        parts.emplace_back("knife edge: the faces fold back onto each other");
    }
    result_.note = fmt::format("{}", fmt::join(parts, "; "));
}

EdgeContinuity EdgeMeter::run() {
    result_.length = length_;
    std::vector<Sample> samples;
    for (const double t : parameters()) {
        samples.push_back(measure(t));
    }
    set_mean_angle(samples);
    refine(samples, &Sample::gap, kNoiseGap * length_);
    refine(samples, &Sample::edge_gap, kNoiseGap * length_);
    refine(samples, &Sample::angle, kNoiseAngle);
    refine(samples, &Sample::mismatch, kNoiseMismatch);
    refine_kinks(samples);
    set_note();
    return result_;
}

}  // namespace

EdgeContinuity measure_edge(const TopoDS_Edge& edge, const std::array<TopoDS_Face, 2>& faces,
                            const std::array<EdgeUse, 2>& uses) {
    return EdgeMeter(edge, faces, uses).run();
}

}  // namespace suture

#include "suture/check/measure_edge.h"

#include "suture/check/edge_sample.h"
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

// Local maxima that seem to reach this part of the largest one are refined, at most so many, until
// the value settles to kSettled, in at most kRefineSteps steps of the golden section.
constexpr double kWorthRefining = 0.5;
constexpr int kRefineMost = 12;
constexpr double kSettled = 1e-3;
constexpr int kRefineSteps = 24;
constexpr int kKinkSteps = 40;

// Below these, values are rounding noise and are not refined: angles in radians, gaps against the
// edge's length, curvature mismatches.
constexpr double kNoiseAngle = 1e-8;
constexpr double kNoiseGap = 1e-10;
constexpr double kNoiseMismatch = 1e-4;

// The changes of curvature are compared where they can mean something: on edges that are tangent
// within this angle, and whose curvatures agree within this part of the larger one.
constexpr double kTangentForG3 = radians(1.0);
constexpr double kMismatchForG3 = 0.5;

// Two normals farther apart than this are a knife edge, or the faces are oriented inconsistently.
constexpr double kKnifeAngle = radians(179.0);

/// How the face, as oriented in the shape, runs along the edge.
TopAbs_Orientation direction(const TopoDS_Face& face, const EdgeInFace& use) {
    return TopAbs::Compose(face.Orientation(), use.edge.Orientation());
}

Eigen::Vector3d to_eigen(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}

class EdgeMeter {
  public:
    EdgeMeter(const TopoDS_Edge& edge, const std::array<TopoDS_Face, 2>& faces,
              const std::array<EdgeInFace, 2>& uses)
        : curve_(edge),
          range_{curve_.FirstParameter(), curve_.LastParameter()},
          length_(length_of(edge, curve_)),
          sides_{FaceSide(faces[0], uses[0].edge, range_, length_),
                 FaceSide(faces[1], uses[1].edge, range_, length_)},
          same_direction_(direction(faces[0], uses[0]) == direction(faces[1], uses[1])),
          gap_t_(range_.first),
          angle_t_(range_.first),
          curvature_t_(range_.first) {}

    EdgeContinuity run();

  private:
    EdgeSample measure(double t);
    void measure_into(EdgeSample& sample);
    void record_g3(const EdgeSample& sample);
    void measure_g3(const std::vector<EdgeSample>& samples);
    [[nodiscard]] double part_of_length(const std::vector<EdgeSample>& samples, double t) const;
    void record(const EdgeSample& sample);
    void refine(const std::vector<EdgeSample>& samples, double EdgeSample::*value, double noise);
    void refine_kinks(const std::vector<EdgeSample>& samples);
    void refine_kink(EdgeSample a, EdgeSample b, int steps);
    void golden(double low, double high, double EdgeSample::*value, double best);
    void set_mean_angle(const std::vector<EdgeSample>& samples);
    void set_note();

    BRepAdaptor_Curve curve_;
    EdgeRange range_;
    double length_;
    std::array<FaceSide, 2> sides_;
    bool same_direction_;
    EdgeContinuity result_;
    double gap_t_ = 0.0, angle_t_ = 0.0, curvature_t_ = 0.0;
    bool with_slopes_ = false;
    int tried_ = 0, without_normal_ = 0, failed_ = 0;
};

void EdgeMeter::record_g3(const EdgeSample& sample) {
    if (sample.g3 < 0.0) {
        return;
    }
    ++result_.g3_samples;
    if (sample.g3 >= result_.g3_mismatch) {
        result_.g3_mismatch = sample.g3;
        result_.g3_at = to_eigen(sample.point);
    }
}

void EdgeMeter::measure_g3(const std::vector<EdgeSample>& samples) {
    if (result_.curvature_samples == 0 || result_.max_angle > kTangentForG3 ||
        result_.curvature_mismatch > kMismatchForG3) {
        return;
    }
    with_slopes_ = true;
    for (const EdgeSample& before : samples) {
        EdgeSample sample;
        sample.t = before.t;
        if (occ::guarded("measuring an edge", [&] { measure_into(sample); })) {
            record_g3(sample);
        }
    }
}

void EdgeMeter::measure_into(EdgeSample& sample) {
    gp_Vec tangent;
    curve_.D1(sample.t, sample.point, tangent);
    sample.speed = tangent.Magnitude();
    const BorderPoint one = sides_[0].at(sample.t, sample.point, tangent, with_slopes_);
    const BorderPoint two = sides_[1].at(sample.t, sample.point, tangent, with_slopes_);
    sample.gap = one.point.Distance(two.point);
    sample.edge_gap = std::max(sample.point.Distance(one.point), sample.point.Distance(two.point));
    if (one.normal && two.normal) {
        sample.angle =
            std::atan2(one.normal->CrossMagnitude(*two.normal), *one.normal * *two.normal);
    }
    if (one.curvature && two.curvature) {
        compare_curvatures(*one.curvature, *two.curvature, length_, sample);
    }
    if (one.curvature_slope && two.curvature_slope) {
        compare_slopes(one, two, length_, sample);
    }
}

EdgeSample EdgeMeter::measure(double t) {
    EdgeSample sample;
    sample.t = t;
    if (!occ::guarded("measuring an edge", [&] { measure_into(sample); })) {
        sample.failed = true;
    }
    record(sample);
    return sample;
}

void EdgeMeter::record(const EdgeSample& sample) {
    ++tried_;
    if (sample.failed) {
        ++failed_;
        return;
    }
    if (sample.gap >= result_.max_gap) {
        result_.max_gap = sample.gap;
        result_.gap_at = to_eigen(sample.point);
        gap_t_ = sample.t;
    }
    result_.edge_gap = std::max(result_.edge_gap, sample.edge_gap);
    if (sample.angle < 0.0) {
        ++without_normal_;
        return;
    }
    result_.min_angle =
        result_.samples == 0 ? sample.angle : std::min(result_.min_angle, sample.angle);
    ++result_.samples;
    if (sample.angle >= result_.max_angle) {
        result_.max_angle = sample.angle;
        result_.angle_at = to_eigen(sample.point);
        angle_t_ = sample.t;
    }
    if (sample.mismatch < 0.0) {
        return;
    }
    ++result_.curvature_samples;
    if (sample.mismatch >= result_.curvature_mismatch) {
        result_.curvature_mismatch = sample.mismatch;
        result_.curvature_at = to_eigen(sample.point);
        curvature_t_ = sample.t;
    }
    result_.curvature_difference = std::max(result_.curvature_difference, sample.difference);
    result_.curvature_mismatch_sum = std::max(result_.curvature_mismatch_sum, sample.mismatch_sum);
    result_.opposite_concavity = result_.opposite_concavity || sample.opposite;
}

void EdgeMeter::golden(double low, double high, double EdgeSample::*value, double best) {
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
double top_of_parabola(const std::vector<EdgeSample>& samples, std::size_t i,
                       double EdgeSample::*value) {
    const EdgeSample& m = samples[i];
    const double before = samples[i - 1].t - m.t;
    const double after = samples[i + 1].t - m.t;
    const double slope_before = (samples[i - 1].*value - m.*value) / before;
    const double slope_after = (samples[i + 1].*value - m.*value) / after;
    const double bend = (slope_after - slope_before) / (after - before);
    const double slope = slope_before - bend * before;
    return bend < 0.0 ? m.*value - slope * slope / (4.0 * bend) : m.*value;
}

void EdgeMeter::refine(const std::vector<EdgeSample>& samples, double EdgeSample::*value,
                       double noise) {
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
/// alike: it may be too narrow to raise a sample, so that the place itself is sought.
void EdgeMeter::refine_kinks(const std::vector<EdgeSample>& samples) {
    for (std::size_t i = 1; i < samples.size(); ++i) {
        refine_kink(samples[i - 1], samples[i], kKinkSteps);
    }
}

void EdgeMeter::refine_kink(EdgeSample a, EdgeSample b, int steps) {
    const bool alike_between = a.excess * b.excess < 0.0;
    // Where one of them turns from one way to the other it is flat, and the less bent for a while.
    const bool flat_between = a.opposite != b.opposite;
    if (steps == 0 || !(a.opposite || b.opposite) || !(alike_between || flat_between)) {
        return;
    }
    const EdgeSample middle = measure(0.5 * (a.t + b.t));
    if (middle.mismatch >= 2.0 * (1.0 - kSettled)) {
        return;  // there is no more than 2
    }
    if (!alike_between && middle.excess * a.excess < 0.0) {
        refine_kink(a, middle, steps - 1);
        refine_kink(middle, b, steps - 1);
        return;
    }
    const bool like_a =
        alike_between ? middle.excess * a.excess > 0.0 : middle.opposite == a.opposite;
    (like_a ? a : b) = middle;
    refine_kink(a, b, steps - 1);
}

void EdgeMeter::set_mean_angle(const std::vector<EdgeSample>& samples) {
    double sum = 0.0;
    double weight = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const EdgeSample& a = samples[i - 1];
        const EdgeSample& b = samples[i];
        if (a.angle >= 0.0 && b.angle >= 0.0) {
            const double step = 0.5 * (a.speed + b.speed) * (b.t - a.t);
            sum += 0.5 * (a.angle + b.angle) * step;
            weight += step;
        }
    }
    result_.mean_angle = weight > 0.0 ? sum / weight : result_.max_angle;
}

/// By the trapezoid rule over the samples: good to see where a point lies.
double EdgeMeter::part_of_length(const std::vector<EdgeSample>& samples, double t) const {
    double before = 0.0;
    double all = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const EdgeSample& a = samples[i - 1];
        const EdgeSample& b = samples[i];
        const double step = 0.5 * (a.speed + b.speed) * (b.t - a.t);
        const double part = b.t > a.t ? std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0) : 0.0;
        before += part * step;
        all += step;
    }
    return all > 0.0 ? before / all : 0.0;
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
    std::vector<EdgeSample> samples;
    for (const double t : sample_parameters(curve_, range_, sides_)) {
        samples.push_back(measure(t));
    }
    set_mean_angle(samples);
    refine(samples, &EdgeSample::gap, kNoiseGap * length_);
    refine(samples, &EdgeSample::edge_gap, kNoiseGap * length_);
    refine(samples, &EdgeSample::angle, kNoiseAngle);
    refine(samples, &EdgeSample::mismatch, kNoiseMismatch);
    refine_kinks(samples);
    measure_g3(samples);
    result_.gap_along = part_of_length(samples, gap_t_);
    result_.angle_along = part_of_length(samples, angle_t_);
    result_.curvature_along = part_of_length(samples, curvature_t_);
    set_note();
    return result_;
}

}  // namespace

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

EdgeContinuity measure_edge(const TopoDS_Edge& edge, const std::array<TopoDS_Face, 2>& faces,
                            const std::array<EdgeInFace, 2>& uses) {
    return EdgeMeter(edge, faces, uses).run();
}

}  // namespace suture

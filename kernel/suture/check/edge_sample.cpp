#include "suture/check/edge_sample.h"

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

// Still narrower waves stand within less than a step of the end: there the samples lie so far from
// it, as parts of the edge.
constexpr std::array<double, 3> kNearEnd = {1e-4, 3e-4, 1e-3};

// Pieces that the even division does not reach with so many points get them on their own, if they
// are longer than this part of the edge: knots may crowd towards a corner.
constexpr double kLeastPiece = 1e-5;

// Where between two steps of the even division an inner sample lies: off the middle, so that it
// does not fall on knots, which tend to lie at round parameters.
constexpr double kOffset = 0.38;

// A face that turns by less than this angle over a width equal to the edge's length is flat: its
// curvature is not compared. It is half of the G1 angle that no eye sees (0.01 deg).
constexpr double kFlatTurning = 1e-4;

}  // namespace

std::vector<double> sample_parameters(const BRepAdaptor_Curve& curve, const EdgeRange& range,
                                      const std::array<FaceSide, 2>& sides) {
    const bool conic = curve.GetType() <= GeomAbs_Ellipse;
    const bool elementary = conic && sides[0].is_elementary() && sides[1].is_elementary();
    const bool straight =
        elementary && curve.GetType() == GeomAbs_Line && sides[0].is_plane() && sides[1].is_plane();
    const int pieces =
        std::max({curve.NbIntervals(GeomAbs_CN), sides[0].pieces(), sides[1].pieces()});
    const int degree = std::max(sides[0].degree(), sides[1].degree());
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
        for (const double s : kNearEnd) {
            fractions.push_back(s);
            fractions.push_back(1.0 - s);
        }
        const double even = 1.0 / (count - 2);
        std::vector<double> ends = {0.0, 1.0};
        for (const FaceSide& side : sides) {
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
        s = range.first + s * (range.last - range.first);
    }
    return fractions;
}

void compare_curvatures(double k1, double k2, double length, EdgeSample& sample) {
    const double flat = kFlatTurning / length;
    const double largest = std::max(std::abs(k1), std::abs(k2));
    sample.difference = std::abs(k1 - k2);
    if (largest <= flat) {
        sample.mismatch = sample.mismatch_sum = 0.0;
        return;
    }
    sample.mismatch = std::abs(k1 - k2) / largest;
    sample.mismatch_sum = std::abs(k1 - k2) / (std::abs(k1) + std::abs(k2));
    sample.excess = std::abs(k1) - std::abs(k2);
    sample.opposite = k1 * k2 < 0.0 && std::min(std::abs(k1), std::abs(k2)) > flat;
}

/// The change of a radius per length, R' = -k'/k^2, is a number; its arc tangent is the angle at
/// which the evolute, the curve of the centres, leaves. Of a flat face that stays flat it is zero.
void compare_slopes(const BorderPoint& one, const BorderPoint& two, double length,
                    EdgeSample& sample) {
    const double flat = kFlatTurning / length;
    const std::array<double, 2> k = {*one.curvature, *two.curvature};
    const std::array<double, 2> slope = {*one.curvature_slope, *two.curvature_slope};
    if (std::max(std::abs(k[0]), std::abs(k[1])) <= flat) {
        if (std::max(std::abs(slope[0]), std::abs(slope[1])) <= flat / length) {
            sample.g3 = 0.0;
        }
        return;  // where a curvature passes through zero its radius tells nothing
    }
    sample.g3 = std::abs(std::atan2(slope[0], k[0] * k[0]) - std::atan2(slope[1], k[1] * k[1]));
}

}  // namespace suture

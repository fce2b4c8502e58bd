#include "suture/fill/mvs/samples.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::mvs {
namespace {

// Steps of the table from which parameters at equal arc lengths are read.
constexpr int kTable = 64;

// Parameters on a domain curve, which has the ribbon's own speed, by arc length.
class ArcLength {
  public:
    explicit ArcLength(const DomainCurve& curve) : walked_(kTable + 1, 0.0) {
        for (int k = 0; k < kTable; ++k) {
            const double middle = (k + 0.5) / kTable;
            walked_[static_cast<std::size_t>(k) + 1] =
                walked_[static_cast<std::size_t>(k)] + curve.derivative(middle).norm();
        }
    }

    /// The parameter up to which this part of the length is walked.
    [[nodiscard]] double at(double part) const {
        const double target = walked_.back() * part;
        const auto above = std::lower_bound(walked_.begin() + 1, walked_.end() - 1, target);
        const auto k = static_cast<std::size_t>(above - walked_.begin()) - 1;
        const double t = (target - walked_[k]) / (walked_[k + 1] - walked_[k]);
        return std::clamp((static_cast<double>(k) + t) / kTable, 0.0, 1.0);
    }

  private:
    std::vector<double> walked_;
};

// Pieces may be longer than asked for by this factor before they are halved.
constexpr double kStretch = 1.25;
constexpr int kHalvings = 12;

// Cuts a side into pieces, as parts of its length.
class Pieces {
  public:
    Pieces(const DomainCurve& curve, const ArcLength& arc, double length, const Scale& scale,
           const Density& density)
        : curve_(curve),
          arc_(arc),
          length_(length / scale.length),
          scale_(scale),
          density_(density) {
        const double coarsest = std::max(widest(density.u), widest(density.v)) / density.per_span;
        const int count = std::max(density.least, static_cast<int>(std::ceil(length_ / coarsest)));
        for (int k = 0; k < count; ++k) {
            cut(static_cast<double>(k) / count, (k + 1.0) / count, kHalvings);
        }
        cuts_.push_back(1.0);
    }

    /// Where pieces begin, and 1.
    [[nodiscard]] const std::vector<double>& cuts() const { return cuts_; }

  private:
    static double width(const Axis& axis, double t) {
        const int span = axis.span_of(t);
        return axis.upper(span) - axis.lower(span);
    }
    static double widest(const Axis& axis) {
        double result = 0.0;
        for (int k = 0; k < axis.spans(); ++k) {
            result = std::max(result, axis.upper(k) - axis.lower(k));
        }
        return result;
    }
    [[nodiscard]] double spacing(double part) const {
        const Eigen::Vector2d uv = curve_.at(arc_.at(part)) / scale_.length;
        return std::min(width(density_.u, uv.x()), width(density_.v, uv.y())) / density_.per_span;
    }
    void cut(double from, double to, int halvings) {
        const double middle = 0.5 * (from + to);
        const double shortest = std::min({spacing(from), spacing(middle), spacing(to)});
        if (halvings > 0 && (to - from) * length_ > kStretch * shortest) {
            cut(from, middle, halvings - 1);
            cut(middle, to, halvings - 1);
        } else {
            cuts_.push_back(from);
        }
    }

    const DomainCurve& curve_;
    const ArcLength& arc_;
    double length_;
    const Scale& scale_;
    const Density& density_;
    std::vector<double> cuts_;
};

// A place on a side and the part of the length for which it stands.
struct Station {
    double part, weight;
};

std::vector<Station> stations(const std::vector<double>& cuts, bool ends) {
    std::vector<Station> result;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        const double before = k > 0 ? cuts[k] - cuts[k - 1] : 0.0;
        const double after = k + 1 < cuts.size() ? cuts[k + 1] - cuts[k] : 0.0;
        if (ends) {
            result.push_back({cuts[k], 0.5 * (before + after)});
        } else if (after > 0.0) {
            result.push_back({cuts[k] + 0.5 * after, after});
        }
    }
    return result;
}

// The part of a side over which it bends towards a corner at which it does not end.
constexpr double kBend = 0.5;
// The part of the shorter side over which disagreeing normals at a corner are felt.
constexpr double kReach = 0.05;
// The same of disagreeing curvatures.
constexpr double kCurvatureReach = 0.25;
// Share of the boundary's length that an inner point stands for.
constexpr double kInnerShare = 0.02;

// Falls from 1 at 0 to 0 at 1, with two derivatives zero at both ends.
double fade(double t) {
    return t >= 1.0 ? 0.0 : 1.0 - t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
}

// One side with what its corners do to it.
struct Side {
    const Ribbon& ribbon;
    Eigen::Vector3d at_start, at_end;     // shifts towards the corners
    double mismatch_start, mismatch_end;  // of normals, in radians
    double twist_start, twist_end;        // of curvatures
    double shorter_start, shorter_end;    // of the two sides at a corner: what is felt from there
    double length;

    [[nodiscard]] Eigen::Vector3d shift(double s) const {
        return fade(s / kBend) * at_start + fade((1.0 - s) / kBend) * at_end;
    }
    // walked: arc length from the start.
    [[nodiscard]] double unmet(double walked) const {
        const double from_start = std::max(0.0, 1.0 - walked / (kReach * shorter_start));
        const double from_end = std::max(0.0, 1.0 - (length - walked) / (kReach * shorter_end));
        return 0.5 * std::max(from_start * mismatch_start, from_end * mismatch_end);
    }
    // How much the nearer twisted corner is felt, 1 at the corner.
    [[nodiscard]] double twisted(double walked) const {
        const auto felt = [&](double twist, double distance, double shorter) {
            return twist * length > kSameBend ? fade(distance / (kCurvatureReach * shorter)) : 0.0;
        };
        return std::max(felt(twist_start, walked, shorter_start),
                        felt(twist_end, length - walked, shorter_end));
    }
};

void sample_side(const Side& side, const DomainCurve& curve, const Scale& scale,
                 const Density& density, bool ends, BoundarySample sample,
                 std::vector<BoundarySample>& samples) {
    const ArcLength arc(curve);
    const Pieces pieces(curve, arc, side.length, scale, density);
    for (const Station& station : stations(pieces.cuts(), ends)) {
        const double s = arc.at(station.part);
        const RibbonPoint p = side.ribbon.at(s);
        const Eigen::Vector2d along = curve.derivative(s).normalized();
        sample.s = s;
        sample.length = station.weight * side.length / scale.length;
        sample.uv = curve.at(s) / scale.length;
        sample.across = Eigen::Vector2d(-along.y(), along.x());
        sample.point = (p.point + side.shift(s) - scale.centre) / scale.length;
        sample.normal = p.normal;
        sample.inward = p.inward;
        sample.curvature = p.curvature * scale.length;
        sample.continuity = side.ribbon.continuity;
        sample.unmet_angle =
            sample.continuity >= Continuity::G1 ? side.unmet(station.part * side.length) : 0.0;
        if (sample.continuity >= Continuity::G2) {
            const double felt = side.twisted(station.part * side.length);
            sample.curvature_weight = 1.0 - felt;
            sample.unmet_curvature =
                felt * std::max(side.twist_start, side.twist_end) * scale.length;
        }
        samples.push_back(sample);
    }
}

}  // namespace

std::vector<Corner> corners_of(const RibbonLoop& loop) {
    const std::size_t n = loop.ribbons.size();
    std::vector<Corner> corners(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Ribbon& ribbon = loop.ribbons[i];
        const Ribbon& previous = loop.ribbons[(i + n - 1) % n];
        const RibbonPoint before = previous.at(1.0);
        const RibbonPoint after = ribbon.at(0.0);
        corners[i].point = 0.5 * (before.point + after.point);
        const Eigen::Matrix3d twist = before.curvature - after.curvature;
        if (std::min(previous.continuity, ribbon.continuity) >= Continuity::G2) {
            corners[i].twist = twist.norm();
        } else if (previous.continuity >= Continuity::G2) {
            corners[i].twist = (twist * after.tangent.normalized()).norm();
        } else if (ribbon.continuity >= Continuity::G2) {
            corners[i].twist = (twist * before.tangent.normalized()).norm();
        }
        if (std::min(previous.continuity, ribbon.continuity) >= Continuity::G1) {
            corners[i].mismatch = std::atan2(before.normal.cross(after.normal).norm(),
                                             before.normal.dot(after.normal));
        }
    }
    return corners;
}

std::vector<BoundarySample> sample_boundary(const Hole& hole, const Domain& domain,
                                            const Scale& scale, const Density& density, bool ends) {
    std::vector<BoundarySample> samples;
    for (std::size_t l = 0; l < hole.loops.size(); ++l) {
        const RibbonLoop& loop = hole.loops[l];
        const DomainLoop& laid = domain.loops[l];
        const std::vector<Corner> corners = corners_of(loop);
        const std::size_t n = loop.ribbons.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Ribbon& ribbon = loop.ribbons[i];
            const std::size_t next = (i + 1) % n;
            const double length = laid.lengths[i];
            const Side side{ribbon,
                            corners[i].point - ribbon.at(0.0).point,
                            corners[next].point - ribbon.at(1.0).point,
                            corners[i].mismatch,
                            corners[next].mismatch,
                            corners[i].twist,
                            corners[next].twist,
                            std::min(length, laid.lengths[(i + n - 1) % n]),
                            std::min(length, laid.lengths[next]),
                            length};
            BoundarySample sample;
            sample.loop = static_cast<int>(l);
            sample.ribbon = static_cast<int>(i);
            sample_side(side, laid.curves[i], scale, density, ends, sample, samples);
        }
    }
    for (std::size_t k = 0; k < hole.through.size(); ++k) {
        BoundarySample sample;
        sample.loop = -1;
        sample.length = kInnerShare;
        sample.uv = domain.through[k] / scale.length;
        sample.across.setZero();
        sample.point = (hole.through[k].point - scale.centre) / scale.length;
        sample.normal = hole.through[k].normal.value_or(Eigen::Vector3d::Zero());
        sample.inward.setZero();
        sample.curvature.setZero();
        sample.continuity = hole.through[k].normal ? Continuity::G1 : Continuity::G0;
        if (hole.through[k].normal) {  // tangent in both directions
            sample.across = Eigen::Vector2d::UnitX();
            samples.push_back(sample);
            sample.across = Eigen::Vector2d::UnitY();
        }
        samples.push_back(sample);
    }
    return samples;
}

}  // namespace suture::mvs

#include "suture/fill/extend/cut.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::extend {
namespace {

using Eigen::Vector2d;

/// A side that meets the seam nearer to its ends than this share of it meets it in its corner.
constexpr double kAtEnd = 1e-6;

struct Candidate {
    std::size_t corner = 0;
    std::size_t other_corner = 0;
    Vector2d from, to;
    double skew = 0.0;  ///< how far it leaves the line of constant `around`, in model units
};

double positive_remainder(double value, double period) {
    const double r = std::fmod(value, period);
    return r < 0.0 ? r + period : r;
}

class Cutter {
  public:
    Cutter(const Chart& chart, const Region& region, std::vector<Trace>& traces, double snap)
        : chart_(chart),
          region_(region),
          traces_(traces),
          snap_(snap),
          c_(region.around),
          d_(1 - region.around),
          period_(chart.period[region.around]),
          first_(region.low >= 0 ? region.low : region.high),
          second_(region.kind == Region::Kind::Band ? region.high : -1) {}

    Result<Seam> cut() {
        std::vector<Candidate> candidates = all();
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) { return a.skew < b.skew; });
        for (const Candidate& candidate : candidates) {
            if (clear(candidate)) {
                return place(candidate);
            }
        }
        return fail(ErrorCode::Refused,
                    "the hole goes all the way around the {}, and no straight line from corner to "
                    "corner cuts it open",
                    kind_name(chart_.surface));
    }

  private:
    const Chart& chart_;
    const Region& region_;
    std::vector<Trace>& traces_;
    double snap_;
    int c_, d_;
    double period_;
    int first_, second_;

    [[nodiscard]] Trace& first() const { return traces_[static_cast<std::size_t>(first_)]; }
    [[nodiscard]] Trace& second() const { return traces_[static_cast<std::size_t>(second_)]; }

    [[nodiscard]] double length_around(const Vector2d& at, double by) const {
        const SurfaceJet jet = evaluate(chart_.surface, at.x(), at.y());
        return std::abs(by) * (c_ == 0 ? jet.u : jet.v).norm();
    }

    /// Where a B-spline's domain begins; its seam can be nowhere else.
    [[nodiscard]] std::optional<double> own_seam() const {
        const auto* spline = std::get_if<SplineSurface>(&chart_.surface);
        if (spline == nullptr) {
            return std::nullopt;
        }
        return c_ == 0 ? spline->knots_u[static_cast<std::size_t>(spline->degree_u)]
                       : spline->knots_v[static_cast<std::size_t>(spline->degree_v)];
    }

    /// The seam straight, if it can be; false where it would leave a B-spline's own seam.
    bool straighten(Candidate& candidate) const {
        if (const auto own = own_seam()) {
            const double off = std::remainder(candidate.from[c_] - *own, period_);
            if (length_around(candidate.from, off) > snap_ || candidate.skew > snap_) {
                return false;
            }
            candidate.from[c_] -= off;
        }
        if (candidate.skew <= snap_) {
            candidate.to[c_] = candidate.from[c_];
            candidate.skew = 0.0;
        }
        return true;
    }

    [[nodiscard]] std::vector<Candidate> all() const {
        std::vector<Candidate> candidates;
        const auto add = [&](Candidate candidate) {
            if (straighten(candidate)) {
                candidates.push_back(candidate);
            }
        };
        for (std::size_t a = 0; a < first().sides.size(); ++a) {
            Candidate candidate;
            candidate.corner = a;
            candidate.from = first().sides[a].front();
            if (region_.pole != nullptr) {
                candidate.to = candidate.from;
                candidate.to[d_] = region_.pole->value;
                add(candidate);
                continue;
            }
            for (std::size_t b = 0; b < second().sides.size(); ++b) {
                candidate.other_corner = b;
                candidate.to = nearest(second().sides[b].front(), candidate.from, chart_.period);
                if (chart_.period[d_] > 0.0) {
                    candidate.to[d_] = candidate.from[d_] +
                                       positive_remainder(candidate.to[d_] - candidate.from[d_],
                                                          chart_.period[d_]);
                }
                candidate.skew = length_around(candidate.to, candidate.to[c_] - candidate.from[c_]);
                add(candidate);
            }
        }
        return candidates;
    }

    /// By how much to move a trace that is neither end of the seam to lie beside it.
    [[nodiscard]] Vector2d beside(const Trace& trace, const Candidate& seam) const {
        Vector2d middle = 0.5 * (seam.from + seam.to);
        middle[c_] += 0.5 * period_ * first().winding[c_];
        return nearest(trace.centre(), middle, chart_.period) - trace.centre();
    }

    /// Whether no side meets the seam between its ends.
    [[nodiscard]] bool clear(const Candidate& seam) const {
        const double rise = seam.to[d_] - seam.from[d_];
        if (region_.low >= 0 ? !(rise > 0.0) : !(rise < 0.0)) {
            return false;
        }
        const double slope = (seam.to[c_] - seam.from[c_]) / rise;
        bool free = true;
        for (int l = 0; l < static_cast<int>(traces_.size()); ++l) {
            const Trace& trace = traces_[static_cast<std::size_t>(l)];
            Vector2d by = Vector2d::Zero();
            if (l == second_) {
                by = seam.to - trace.sides[seam.other_corner].front();
            } else if (l != first_) {
                by = beside(trace, seam);
            }
            // Sheared, so that the seam and its other places are the multiples of the period.
            const auto turns = [&](const Vector2d& p) {
                const Vector2d q = p + by - seam.from;
                return (q[c_] - slope * q[d_]) / period_;
            };
            trace.for_each_piece([&](const Vector2d& p, const Vector2d& q) {
                const double a = turns(p);
                const double b = turns(q);
                const double crossed = std::max(std::floor(a), std::floor(b));
                if (std::floor(a) == std::floor(b)) {
                    return;
                }
                const double f = (crossed - a) / (b - a);
                const double at = ((1.0 - f) * p[d_] + f * q[d_] + by[d_] - seam.from[d_]) / rise;
                free = free && (at < kAtEnd || at > 1.0 - kAtEnd);
            });
        }
        return free;
    }

    /// Moves the sides from `corner` on by `by`, and those before it, which follow after them.
    void start_at(Trace& trace, std::size_t corner, const Vector2d& by) const {
        const double turn = trace.winding[c_] * period_;
        for (std::size_t i = 0; i < trace.sides.size(); ++i) {
            for (Vector2d& p : trace.sides[i]) {
                p += by;
                p[c_] += i < corner ? turn : 0.0;
            }
        }
    }

    Seam place(const Candidate& candidate) {
        Seam seam;
        seam.loop = first_;
        seam.corner = static_cast<int>(candidate.corner);
        seam.other_loop = second_;
        seam.other_corner = static_cast<int>(candidate.other_corner);
        seam.from = candidate.from;
        seam.to = candidate.to;
        seam.period[c_] = period_ * first().winding[c_];
        Vector2d by = Vector2d::Zero();
        if (const auto own = own_seam()) {  // into the B-spline's own domain
            by[c_] = *own + (seam.period[c_] > 0.0 ? 0.0 : period_) - seam.from[c_];
        }
        seam.from += by;
        seam.to += by;
        for (int l = 0; l < static_cast<int>(traces_.size()); ++l) {
            Trace& trace = traces_[static_cast<std::size_t>(l)];
            if (l != first_ && l != second_) {
                trace.shift(beside(trace, candidate) + by);
            }
        }
        if (second_ >= 0) {
            const Vector2d start = second().sides[candidate.other_corner].front();
            start_at(second(), candidate.other_corner, candidate.to + by + seam.period - start);
        }
        start_at(first(), candidate.corner, by);
        return seam;
    }
};

}  // namespace

Result<Seam> cut_open(const Chart& chart, const Region& region, std::vector<Trace>& traces,
                      double snap) {
    return Cutter(chart, region, traces, snap).cut();
}

}  // namespace suture::extend

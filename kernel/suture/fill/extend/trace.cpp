#include "suture/fill/extend/trace.h"

#include <algorithm>
#include <cmath>

namespace suture::extend {
namespace {

using Eigen::Vector2d;

/// Per side: a side that goes all the way around is followed in steps of a 32nd of the period.
constexpr int kSamples = 32;

/// Less than this share of a period along a pole is rounding: there the sides meet.
constexpr double kSmooth = 1e-6;

/// From `end` to `start`, both in one pole: the way around the hole, which lies to the left, or to
/// the right where `reversed`.
Vector2d along_pole(const Pole& pole, const Vector2d& end, const Vector2d& start,
                    const Vector2d& period, bool reversed) {
    const int c = 1 - pole.across;
    Vector2d result = start;
    if (period[c] > 0.0) {
        const double left = pole.across == 1 ? -pole.side : pole.side;
        const double direction = reversed ? -left : left;
        double way = std::fmod(direction * (start[c] - end[c]), period[c]);
        way += way < -kSmooth * period[c] ? period[c] : 0.0;
        if (std::abs(way) <= kSmooth * period[c]) {
            return end;
        }
        result[c] = end[c] + direction * way;
    }
    return result;
}

}  // namespace

Vector2d Trace::low() const {
    Vector2d result = Vector2d::Constant(INFINITY);
    for (const auto& side : sides) {
        for (const Vector2d& p : side) {
            result = result.cwiseMin(p);
        }
    }
    return result;
}

Vector2d Trace::high() const {
    Vector2d result = Vector2d::Constant(-INFINITY);
    for (const auto& side : sides) {
        for (const Vector2d& p : side) {
            result = result.cwiseMax(p);
        }
    }
    return result;
}

void Trace::shift(const Vector2d& by) {
    for (auto& side : sides) {
        for (Vector2d& p : side) {
            p += by;
        }
    }
}

void Trace::for_each_piece(
    const std::function<void(const Vector2d&, const Vector2d&)>& call) const {
    const Vector2d* last = nullptr;
    for (const auto& side : sides) {
        for (const Vector2d& p : side) {
            if (last != nullptr) {
                call(*last, p);
            }
            last = &p;
        }
    }
    if (winding.isZero()) {
        call(*last, sides.front().front());
    }
}

double Trace::area() const {
    const Vector2d origin = sides.front().front();
    double doubled = 0.0;
    for_each_piece([&](const Vector2d& p, const Vector2d& q) {
        const Vector2d a = p - origin;
        const Vector2d b = q - origin;
        doubled += a.x() * b.y() - a.y() * b.x();
    });
    return 0.5 * doubled;
}

Samples sample_loop(const Chart& chart, const RibbonLoop& loop) {
    Samples samples;
    for (const Ribbon& ribbon : loop.ribbons) {
        auto& side = samples.emplace_back();
        for (int k = 0; k <= kSamples; ++k) {
            side.push_back(chart.uv(ribbon, static_cast<double>(k) / kSamples));
        }
    }
    return samples;
}

Trace unwrap(const Chart& chart, const Samples& samples, bool reversed) {
    Trace trace;
    const Vector2d start = samples.front().front();
    Vector2d now = start;
    const auto join = [&](const Vector2d& next, std::size_t corner) {
        Vector2d close = nearest(next, now, chart.period);
        const Pole* pole = chart.pole_at(now);
        if (pole == nullptr || pole != chart.pole_at(close)) {
            return close;
        }
        Vector2d there = along_pole(*pole, now, close, chart.period, reversed);
        if (there != now) {
            trace.pole_corners.push_back(static_cast<int>(corner));
        }
        return there;
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
        auto& side = trace.sides.emplace_back();
        for (const Vector2d& p : samples[i]) {
            if (side.empty()) {
                now = i == 0 ? start : join(p, i);
            } else {
                now = nearest(p, now, chart.period);
            }
            side.push_back(now);
        }
    }
    const Vector2d end = join(start, 0);
    for (const int c : {0, 1}) {
        if (chart.period[c] > 0.0) {
            trace.winding[c] = static_cast<int>(std::lround((end[c] - start[c]) / chart.period[c]));
        }
    }
    return trace;
}

TrimCurve trim_of(const std::shared_ptr<const Chart>& chart, const Ribbon& ribbon,
                  const std::vector<Vector2d>& side) {
    // Shared: a fill is copied with its curves, and a B-spline can be large.
    return [chart, shared = std::make_shared<const Ribbon>(ribbon), side](double s) {
        const double t = std::clamp(s, 0.0, 1.0) * kSamples;
        const auto k = std::min(static_cast<std::size_t>(t), side.size() - 2);
        const double f = t - static_cast<double>(k);
        const Vector2d about = (1.0 - f) * side[k] + f * side[k + 1];
        return nearest(chart->uv(*shared, s), about, chart->period);
    };
}

}  // namespace suture::extend

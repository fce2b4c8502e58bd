#include "suture/fill/recognise/ball.h"

#include "suture/fill/recognise/form.h"
#include "suture/fill/recognise/plain.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::recognise {
namespace {

using Eigen::Vector3d;

/// |n1 - n2|^2 below this says nothing on the radius.
constexpr double kLeastTurn = 1e-3;
/// Contacts that miss a common centre by more than this share of the hole's size are none.
constexpr double kMiss = 1e-3;
/// A radius whose spread is larger than this is not constant.
constexpr double kSpread = 3e-2;
/// Between samples they may miss it by more, in the border's coordinates.
constexpr double kPromising = 0.03;
/// Every so many samples of one side are compared with the other one.
constexpr int kEvery = 3;
constexpr std::size_t kFewest = 3;
constexpr int kSections = 24;

struct Hit {
    double miss = INFINITY;
    double radius = 0.0;
    double s[2] = {0.0, 0.0};
};

/// The ball that touches two points, and by how much its centres miss each other.
Hit between(const Vector3d& p1, const Vector3d& n1, const Vector3d& p2, const Vector3d& n2) {
    const Vector3d turn = n1 - n2;
    if (turn.squaredNorm() < kLeastTurn) {
        return {};
    }
    const Vector3d way = p1 - p2;
    const double r = way.dot(turn) / turn.squaredNorm();
    return {(way - r * turn).norm(), r, {}};
}

/// The place on side b that has a common centre with sample k of side a, by golden sections about
/// the nearest sample; none at the side's ends.
Hit find_hit(const Border& border, const Side& a, int k, const Side& b) {
    const auto point = [&](const Side& side, int i) { return border.points.col(side.first + i); };
    const auto normal = [&](const Side& side, int i) { return border.normals.col(side.first + i); };
    Hit best;
    int place = 0;
    for (int i = 0; i < Border::kSamples; ++i) {
        const Hit hit = between(point(a, k), normal(a, k), point(b, i), normal(b, i));
        if (hit.miss < best.miss) {
            best = hit;
            place = i;
        }
    }
    if (place == 0 || place == Border::kSamples - 1 || best.miss > kPromising) {
        return {};
    }
    const Vector3d p1 = border.size * point(a, k) + border.origin;
    const Vector3d n1 = normal(a, k);
    const auto at = [&](double s) {
        const RibbonPoint p = b.ribbon->at(s);
        return between(p1, n1, p.point, p.normal);
    };
    double low = (place - 0.5) / Border::kSamples;
    double high = (place + 1.5) / Border::kSamples;
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double x = high - golden * (high - low);
    double y = low + golden * (high - low);
    Hit at_x = at(x);
    Hit at_y = at(y);
    for (int section = 0; section < kSections; ++section) {
        if (at_x.miss < at_y.miss) {
            high = y;
            y = x;
            at_y = at_x;
            x = high - golden * (high - low);
            at_x = at(x);
        } else {
            low = x;
            x = y;
            at_x = at_y;
            y = low + golden * (high - low);
            at_y = at(y);
        }
    }
    Hit hit = at_x.miss < at_y.miss ? at_x : at_y;
    hit.s[0] = (k + 0.5) / Border::kSamples;
    hit.s[1] = at_x.miss < at_y.miss ? x : y;
    return hit;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The guess for two sides; spread: infinite where there is none.
BallGuess guess(const Border& border, std::size_t a, std::size_t b) {
    BallGuess result{{a, b}, 0.0, INFINITY, {0.5, 0.5}};
    std::vector<Hit> hits;
    std::vector<double> radii;
    for (int k = 1; k < Border::kSamples; k += kEvery) {
        const Hit hit = find_hit(border, border.sides[a], k, border.sides[b]);
        if (hit.miss < kMiss * border.size) {
            hits.push_back(hit);
            radii.push_back(hit.radius);
        }
    }
    if (hits.size() < kFewest) {
        return result;
    }
    result.radius = median(radii);
    std::vector<double> off;
    off.reserve(radii.size());
    for (const double r : radii) {
        off.push_back(std::abs(r - result.radius));
    }
    result.spread = median(off) / std::abs(result.radius);
    const Hit& middle = hits[hits.size() / 2];
    result.at[0] = middle.s[0];
    result.at[1] = middle.s[1];
    return result;
}

}  // namespace

std::vector<BallGuess> guess_balls(const Border& border) {
    std::vector<BallGuess> guesses;
    for (std::size_t a = 0; a < border.sides.size(); ++a) {
        for (std::size_t b = a + 1; b < border.sides.size(); ++b) {
            if (!border.sides[a].ribbon->support || !border.sides[b].ribbon->support) {
                continue;
            }
            // From the shorter side: the ball may leave it for the next while it goes on along the
            // other one.
            const bool shorter = border.sides[a].length <= border.sides[b].length;
            const BallGuess found = shorter ? guess(border, a, b) : guess(border, b, a);
            if (found.spread < kSpread && std::abs(found.radius) < 100.0 * border.size) {
                guesses.push_back(found);
            }
        }
    }
    std::sort(guesses.begin(), guesses.end(),
              [](const BallGuess& x, const BallGuess& y) { return x.spread < y.spread; });
    return guesses;
}

std::vector<BallRadius> radii_for(const BallGuess& guess, const Border& border) {
    std::vector<BallRadius> radii;
    const double sign = guess.radius < 0.0 ? -1.0 : 1.0;
    const double slack = std::max(3.0 * guess.spread, 1e-6) * std::abs(guess.radius);
    const double size = std::abs(guess.radius);
    const auto add = [&](double r, double chance) {
        const bool known = std::any_of(radii.begin(), radii.end(), [&](const BallRadius& other) {
            return other.value == sign * r;
        });
        if (std::abs(r - size) <= slack && !known) {
            radii.push_back({sign * r, std::min(chance, 1.0)});
        }
    };
    double tried = 0.0;
    for (const Side& side : border.sides) {
        if (side.ribbon->support) {
            Surface other = side.ribbon->support->surface;
            if (!std::holds_alternative<Cone>(other)) {
                for (const double* r : sizes_of(other)) {
                    tried += 1.0;
                    add(*r, tried * 2.0 * std::abs(*r - size) / size);
                }
            }
        }
    }
    if (const auto round = find_round_length(size, slack)) {
        add(*round, chance_of_round(size, *round));
    }
    add(size, 1.0);
    return radii;
}

}  // namespace suture::recognise

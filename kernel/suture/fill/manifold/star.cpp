#include "suture/fill/manifold/star.h"

#include "suture/base/contract.h"
#include "suture/base/tolerance.h"

#include <algorithm>
#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

/// From layer k + 1 on the surface is one B-spline: charts of other sides end there. Deviation:
/// with three sides L_m is so skew that the h auxiliary layers reach further, by their own width.
int skew_layers(int k, int n) {
    return n >= 4 ? 0 : k / 2 + 1;
}

int outer_layers(int k) {
    return (k + 1) / 2;
}

/// mu by (3), (4) and (5): it ends where the corners' blocks begin, runs on into them, and its
/// derivatives from the second to the k-th vanish there.
/// q_k of mu: even, q(1) = 0, q'(1) = 1, q''(1) = ... = q^(k)(1) = 0, from
/// q' = C int_0^t (1 - s^2)^(k-1) ds. Coefficients of t^0, t^1, ...
VectorXd bulge(int k) {
    VectorXd q = VectorXd::Zero(2 * k + 1);
    if (k == 0) {
        return q;
    }
    double binomial = 1.0;
    double slope = 0.0;
    for (int a = 0; a < k; ++a) {
        const double coefficient = (a % 2 == 0 ? 1.0 : -1.0) * binomial / (2 * a + 1);
        slope += coefficient;
        q[2 * a + 2] = coefficient / (2 * a + 2);
        binomial *= static_cast<double>(k - 1 - a) / (a + 1);
    }
    q /= slope;
    q[0] = -q.sum();
    return q;
}

/// Knots with `h` more at either end that repeat the outermost spacing.
std::vector<double> with_auxiliary(std::vector<double> knots, int h) {
    const double first = knots[1] - knots[0];
    const double last = knots[knots.size() - 1] - knots[knots.size() - 2];
    std::vector<double> result;
    for (int a = h; a > 0; --a) {
        result.push_back(knots.front() - a * first);
    }
    result.insert(result.end(), knots.begin(), knots.end());
    for (int a = 1; a <= h; ++a) {
        result.push_back(knots.back() + a * last);
    }
    return result;
}

bool increases(const std::vector<double>& knots) {
    return std::adjacent_find(knots.begin(), knots.end(), std::greater_equal<>()) == knots.end();
}

Result<void> check_given(const StarSize& size) {
    if (size.given.empty()) {
        return {};
    }
    if (size.given.size() != size.columns.size()) {
        return fail(ErrorCode::Refused, "knots are given for {} of {} sides", size.given.size(),
                    size.columns.size());
    }
    for (std::size_t m = 0; m < size.given.size(); ++m) {
        const auto& [depth, middle] = size.given[m];
        const auto counts = [](const std::vector<double>& knots, int intervals) {
            return knots.empty() || static_cast<int>(knots.size()) == intervals + 1;
        };
        if (!counts(depth, size.layers) || !counts(middle, size.columns[m])) {
            return fail(ErrorCode::Refused, "side {} has {} and {} given knots, not {} and {}", m,
                        depth.size(), middle.size(), size.layers + 1, size.columns[m] + 1);
        }
        if (!increases(depth) || !increases(middle) || (!depth.empty() && depth.front() != 0.0) ||
            (!middle.empty() && (middle.front() != -1.0 || middle.back() != 1.0))) {
            return fail(ErrorCode::Refused,
                        "the given knots of side {} do not increase from 0, or from -1 to 1", m);
        }
    }
    return {};
}

}  // namespace

int Star::least_layers(int k, int n) {
    return k + 1 + skew_layers(k, n) + outer_layers(k);
}

double Star::aperture_bound(int k, int n) {
    const int half = k / 2;
    return (half + 1) / (2.0 * std::cos(kPi / n));
}

double Star::default_aperture(int k, const std::vector<int>& columns) {
    const double bound = aperture_bound(k, static_cast<int>(columns.size()));
    const double all_even = columns.front();
    const bool equal =
        std::all_of(columns.begin(), columns.end(), [&](int r) { return r == columns.front(); });
    constexpr double kShare = 0.8;
    return equal && all_even < bound ? all_even : kShare * bound;
}

Result<Star> Star::make(const StarSize& size) {
    const int n = static_cast<int>(size.columns.size());
    if (n < 3) {
        return fail(ErrorCode::Refused, "a star has at least 3 sides, not {}", n);
    }
    if (size.k < 0) {
        return fail(ErrorCode::Refused, "the order of continuity is at least 0, not {}", size.k);
    }
    for (int m = 0; m < n; ++m) {
        if (size.columns[static_cast<std::size_t>(m)] < 1) {
            return fail(ErrorCode::Refused, "side {} has no interval in its middle", m);
        }
    }
    if (size.layers < least_layers(size.k, n)) {
        return fail(ErrorCode::Refused, "{} layers are too few: k = {} with {} sides needs {}",
                    size.layers, size.k, n, least_layers(size.k, n));
    }
    if (auto given = check_given(size); !given) {
        return tl::unexpected(given.error());
    }
    Star star;
    star.size_ = size;
    if (size.aperture == 0.0) {
        star.size_.aperture = default_aperture(size.k, size.columns);
    }
    double reach = 1.0;
    for (const GivenKnots& given : size.given) {
        reach = given.depth.empty() ? reach : std::min(reach, given.depth[1]);
    }
    const double bound = reach * aperture_bound(size.k, n);
    if (!(star.size_.aperture > 0.0 && star.size_.aperture < bound)) {
        return fail(ErrorCode::Refused,
                    "the aperture {:.6g} is not between 0 and {:.6g}, its bound for k = {} and {} "
                    "sides",
                    star.size_.aperture, bound, size.k, n);
    }
    star.alpha_ = 2.0 * kPi / n;
    star.q_ = bulge(size.k);
    star.f_x_ = star.size_.aperture * (1.0 + std::cos(star.alpha_)) / 2.0;
    star.f_y_ = star.size_.aperture * std::sin(star.alpha_) / 2.0;
    star.cot_ = std::cos(star.alpha_) / std::sin(star.alpha_);
    for (int m = 0; m < n; ++m) {
        star.rays_.emplace_back(std::cos(star.alpha_ * m), std::sin(star.alpha_ * m));
    }
    star.make_knots();
    for (int m = 0; m < n; ++m) {
        if (star.border(m) < star.inner_) {
            return fail(ErrorCode::Refused,
                        "the given knots of side {} end at {:.6g}, before the border zone begins "
                        "at {:.6g}",
                        m, star.border(m), star.inner_);
        }
    }
    star.make_points();
    return star;
}

void Star::make_knots() {
    const int s = size_.layers;
    std::vector<std::vector<double>> depth;
    for (int m = 0; m < n(); ++m) {
        std::vector<double> knots;
        if (!size_.given.empty()) {
            knots = size_.given[index(m)].depth;
        }
        for (int i = static_cast<int>(knots.size()); i <= s; ++i) {
            knots.push_back(i);
        }
        depth.push_back(with_auxiliary(knots, h()));
    }
    knots_x_ = depth;
    double regular = 0.0;
    double widest = 0.0;
    for (int m = 0; m < n(); ++m) {
        const std::vector<double>& own = depth[index(m)];
        regular = std::max(regular, own[static_cast<std::size_t>(k() + 1 + h())]);
        widest = std::max(widest, own[1] - own[0]);
        const int r = columns(m);
        std::vector<double> knots;
        const auto ray = [&](int ray_of, int i) {
            return depth[index(ray_of)][static_cast<std::size_t>(i + h())] * std::sin(alpha_);
        };
        for (int i = s + h(); i > 0; --i) {
            knots.push_back(-f_y_ - ray(m - 1, i));
        }
        for (int j = 0; j <= r; ++j) {
            const bool given = !size_.given.empty() && !size_.given[index(m)].middle.empty();
            knots.push_back(f_y_ * (given
                                        ? size_.given[index(m)].middle[static_cast<std::size_t>(j)]
                                        : 2.0 * j / r - 1.0));
        }
        for (int i = 1; i <= s + h(); ++i) {
            knots.push_back(f_y_ + ray(m + 1, i));
        }
        knots_y_.push_back(std::move(knots));
    }
    inner_ = regular + skew_layers(k(), n()) * widest;
}

void Star::make_points() {
    first_ = {0};
    for (int m = 0; m < n(); ++m) {
        const int middle = columns(m) - 1 + odd();
        first_.push_back(first_.back() + charts_x() * (middle + charts_x()));
    }
    VectorXd charts = VectorXd::Zero(count());
    for (int m = 0; m < n(); ++m) {
        for (int i = 0; i < charts_x(); ++i) {
            for (int j = 0; j < charts_y(m); ++j) {
                charts[point_of(m, i, j)] += kept(m, i, j) ? 1.0 : 0.0;
            }
        }
    }
    weights_ = charts.cwiseInverse();
}

int Star::point_of(int m, int i, int j) const {
    const int s = size_.layers;
    const int last = s - odd();  // the largest i
    if (j <= last) {
        // L_{m-1}, which side m - 1 numbers: (i', s + r + b) of it is (b, s - i') of this side.
        return point_of(m - 1, last - j, s + columns(m - 1) + i);
    }
    const auto side = index(m);
    return first_[side] + i + charts_x() * (j - last - 1);
}

bool Star::kept(int m, int i, int j) const {
    const int s = size_.layers;
    if (j >= s + columns(m) + h() && i < h()) {
        return false;  // (7)
    }
    // (8). Deviation: for even k the limit itself is discarded too; it is side m - 1's.
    return odd() != 0 ? j >= s - h() : j > s - h();
}

double Star::border(int m) const {
    return knots_x(m)[static_cast<std::size_t>(size_.layers - outer_layers(k()) + h())];
}

double Star::mu(double y) const {
    const double beyond = std::abs(y) - f_y_;
    if (beyond >= 0.0) {
        return f_x_ + beyond * cot_;
    }
    const double t2 = y * y / (f_y_ * f_y_);
    double q = 0.0;
    for (Eigen::Index l = q_.size() - 1; l >= 0; l -= 2) {
        q = q * t2 + q_[l];
    }
    return f_x_ + f_y_ * cot_ * q;
}

VectorXd Star::mu_series(double y, double towards, int order) const {
    VectorXd series = VectorXd::Zero(order + 1);
    if (std::abs(towards) > f_y_) {
        const double sign = towards > 0.0 ? 1.0 : -1.0;
        series[0] = f_x_ + (sign * y - f_y_) * cot_;
        if (order > 0) {
            series[1] = sign * cot_;
        }
        return series;
    }
    // Taylor coefficients of q at y / f_y by repeated synthetic division.
    VectorXd c = q_;
    const double t = y / f_y_;
    double scale = f_y_ * cot_;
    for (Eigen::Index l = 0; l <= std::min<Eigen::Index>(order, c.size() - 1); ++l) {
        for (Eigen::Index a = c.size() - 2; a >= l; --a) {
            c[a] += t * c[a + 1];
        }
        series[l] = scale * c[l];
        scale /= f_y_;
    }
    series[0] += f_x_;
    return series;
}

Vector2d Star::to_side(int m, const Vector2d& p) const {
    const Vector2d& v = rays_[index(m)];
    return {v.x() * p.x() + v.y() * p.y(), v.x() * p.y() - v.y() * p.x()};
}

Vector2d Star::from_side(int m, const Vector2d& p) const {
    return to_side(-m, p);
}

Vector2d Star::chart_centre(int m, int i, int j) const {
    // (1) and (2) in the corners' blocks, (6) between them: F takes all three to one grid.
    const auto middle = [&](const std::vector<double>& knots, int first) {
        const auto a = static_cast<std::size_t>(first + h());
        return odd() != 0 ? (knots[a] + knots[a + 1]) / 2.0 : knots[a];
    };
    const double y = middle(knots_y(m), j);
    return from_side(m, {middle(knots_x(m), i) + mu(y), y});
}

}  // namespace suture::manifold

#include "suture/fill/manifold/knot_curves.h"

#include <algorithm>
#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;

/// Bends smaller than this, against the reach, are none: with four sides mu is straight.
constexpr double kStraight = 1e-12;

class Curves {
  public:
    explicit Curves(const Star& star)
        : star_(star), bend_((star.mu(star.f_y()) - star.mu(0.0)) / (star.f_y() * star.f_y())) {
        bend_ = std::abs(bend_) * star.f_y() < kStraight ? 0.0 : bend_;
        for (int m = 0; m < star.n(); ++m) {
            add_side(m);
            const double reach = star.f_y() + star.inner() * std::sin(star.alpha());
            add_across(m, star.inner(), -reach, -star.f_y());
            add_across(m, star.inner(), -star.f_y(), star.f_y());
            add_across(m, star.inner(), star.f_y(), reach);
        }
    }

    [[nodiscard]] std::vector<PlaneCurve> take() { return std::move(curves_); }

  private:
    const Star& star_;
    double bend_;
    std::vector<PlaneCurve> curves_;

    /// Whether side m has a chart with i in [i0, i1], j in [j0, j1].
    [[nodiscard]] bool any(int m, int i0, int i1, int j0, int j1) const {
        for (int j = std::max(0, j0); j <= std::min(j1, star_.charts_y(m) - 1); ++j) {
            for (int i = std::max(0, i0); i <= std::min(i1, star_.charts_x() - 1); ++i) {
                if (star_.kept(m, i, j)) {
                    return true;
                }
            }
        }
        return false;
    }

    void add_side(int m) {
        const int p = star_.degree();
        const std::vector<double>& x = star_.knots_x(m);
        const std::vector<double>& y = star_.knots_y(m);
        const auto count_x = static_cast<int>(x.size());
        const auto count_y = static_cast<int>(y.size());
        const auto at = [](const std::vector<double>& knots, int i) {
            return knots[static_cast<std::size_t>(i)];
        };
        constexpr double kSame = 1e-9;
        for (int a = 0; a < count_x && at(x, a) < star_.inner() - kSame; ++a) {
            for (int b = 0; b + 1 < count_y; ++b) {
                if (any(m, a - p - 1, a, b - p, b)) {
                    add_across(m, at(x, a), at(y, b), at(y, b + 1));
                }
                if (a + 1 < count_x && any(m, a - p, a, b - p - 1, b)) {
                    add_along(m, at(y, b), at(x, a), at(x, a + 1));
                }
            }
        }
    }

    /// x - mu(y) = x0 for y in [from, to], where mu is one polynomial.
    void add_across(int m, double x0, double from, double to) {
        const double middle = 0.5 * (from + to);
        const double s = std::sin(star_.alpha());
        const double c = std::cos(star_.alpha());
        PlaneCurve curve;
        const auto parameter = [&](double y) {
            return curve.across().dot(Vector2d(x0 + star_.mu(y), y));
        };
        if (std::abs(middle) < star_.f_y()) {
            curve.offset = x0 + star_.mu(0.0);
            curve.bend = bend_;
        } else {
            curve.axis = {s, middle > 0.0 ? -c : c};
            curve.offset = curve.axis.dot(Vector2d(x0 + star_.mu(middle), middle));
        }
        curve.from = parameter(from);
        curve.to = parameter(to);
        add(m, curve);
    }

    /// y = y0 for x - mu in [from, to].
    void add_along(int m, double y0, double from, double to) {
        const double mu = star_.mu(y0);
        add(m, {{0.0, -1.0}, -y0, 0.0, from + mu, to + mu});
    }

    void add(int m, PlaneCurve curve) {
        curve.axis = star_.from_side(m, curve.axis);
        curves_.push_back(curve);
    }
};

}  // namespace

std::vector<PlaneCurve> knot_curves(const Star& star) {
    return Curves(star).take();
}

int polynomial_degree(const Star& star, const Vector2d& near) {
    const int p = star.degree();
    int degree = 2 * p;
    for (int m = 0; m < star.n(); ++m) {
        const Vector2d local = star.to_side(m, near);
        const double x = local.x() - star.mu(local.y());
        const bool bent = star.k() > 0 && std::abs(local.y()) < star.f_y();
        if (bent && x > star.knots_x(m).front() && x < star.knots_x(m).back()) {
            degree = std::max(degree, p + 2 * star.k() * p);
        }
    }
    return degree;
}

}  // namespace suture::manifold

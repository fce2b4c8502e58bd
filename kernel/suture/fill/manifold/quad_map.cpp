#include "suture/fill/manifold/quad_map.h"

#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

VectorXd coefficients(std::initializer_list<double> values) {
    VectorXd result(static_cast<Eigen::Index>(values.size()));
    std::copy(values.begin(), values.end(), result.begin());
    return result;
}

/// Cubic Hermite functions on [0,1]: value and derivative at 0, then at 1.
const std::array<VectorXd, 4>& hermite() {
    static const std::array<VectorXd, 4> kFunctions = {
        coefficients({1.0, 0.0, -3.0, 2.0}), coefficients({0.0, 1.0, -2.0, 1.0}),
        coefficients({0.0, 0.0, 3.0, -2.0}), coefficients({0.0, 0.0, -1.0, 1.0})};
    return kFunctions;
}

/// The cubic with these values and derivatives at 0 and 1.
VectorXd cubic(double value0, double slope0, double value1, double slope1) {
    return value0 * hermite()[0] + slope0 * hermite()[1] + value1 * hermite()[2] +
           slope1 * hermite()[3];
}

VectorXd product(const VectorXd& a, const VectorXd& b) {
    VectorXd result = VectorXd::Zero(a.size() + b.size() - 1);
    for (Eigen::Index i = 0; i < a.size(); ++i) {
        result.segment(i, b.size()) += a[i] * b;
    }
    return result;
}

/// a x + b y as series of a point.
PlaneSeries combine(const Series<1>& a, const Vector2d& x, const Series<1>& b, const Vector2d& y) {
    return {x.x() * a + y.x() * b, x.y() * a + y.y() * b};
}

PlaneSeries scaled(const Series<1>& factor, const PlaneSeries& p) {
    return {factor * p[0], factor * p[1]};
}

void add(PlaneSeries& sum, const PlaneSeries& p) {
    sum[0] += p[0];
    sum[1] += p[1];
}

}  // namespace

QuadMap::QuadMap(const Star& star) : star_(star) {
    const double c = std::cos(star.alpha());
    const double end = star.inner() + star.mu(0.0);
    reach_ = star.f_y() + star.inner() * std::sin(star.alpha());
    pull_ = reach_ / std::sin(star.alpha());
    // g(0) = 0, g(1) = end, g'(1) = pull.
    spoke_ = coefficients({0.0, 2.0 * end - pull_, pull_ - end});
    const VectorXd speed = coefficients({spoke_[1], 2.0 * spoke_[2]});
    blend_ = c * coefficients({1.0, -2.0, 1.0});
    along_ = product(blend_, speed);
    // The twist at O is symmetric: it points between the spokes.
    across_ = cubic(speed[0] * std::sin(star.alpha()), along_[1] * std::tan(star.alpha() / 2.0),
                    reach_, 0.0);
    // Their derivatives by the series at the ends.
    for (const int b : {0, 2}) {
        const auto all = curves(variable(b / 2.0, 0, 1), b == 0 ? 1.0 : -1.0);
        for (std::size_t a = 0; a < 4; ++a) {
            const auto first = static_cast<std::size_t>(b);
            corner_[a][first] = {all[a][0].term(0, 0)[0], all[a][1].term(0, 0)[0]};
            corner_[a][first + 1] = {all[a][0].term(1, 0)[0], all[a][1].term(1, 0)[0]};
        }
    }
}

/// What is given along the borders as functions of t: the points and the derivatives across, at v =
/// 0 and at v = 1. In the frame of spoke m + 1, read backwards: for u = 0 and u = 1 they are the
/// mirror images.
std::array<PlaneSeries, 4> QuadMap::curves(const Series<1>& t, double towards) const {
    // For u = 0: v is w = v_(m+1), across towards spoke m.
    const double c = std::cos(star_.alpha());
    const double s = std::sin(star_.alpha());
    const Vector2d w(c, s);
    const Vector2d back(s, -c);
    const Series<1> zero(t.order());
    const double y = reach_ * t.term(0, 0)[0];
    constexpr double kBeside = 1e-9;
    const VectorXd mu = star_.mu_series(y, y + towards * kBeside * reach_, t.order());
    Series<1> x = polynomial(mu, reach_ * increment(t));
    x.term(0, 0)[0] += star_.inner();
    return {combine(polynomial(spoke_, t), w, zero, back),
            combine(polynomial(along_, t), w, polynomial(across_, t), back),
            combine(x, Vector2d::UnitX(), reach_ * t, Vector2d::UnitY()),
            combine(constant(pull_, t.order()), Vector2d::UnitX(), zero, Vector2d::UnitY())};
}

PlaneSeries QuadMap::expand(int m, const Vector2d& at, const Vector2d& towards, int order) const {
    const Series<1> u = variable(at.x(), 0, order);
    const Series<1> v = variable(at.y(), 1, order);
    const auto of_u = curves(v, towards.y());  // F(0,v), F_u(0,v), F(1,v), F_u(1,v)
    const auto mirrored = curves(u, towards.x());
    const double c = std::cos(star_.alpha());
    const double s = std::sin(star_.alpha());
    std::array<Series<1>, 4> in_u;
    std::array<Series<1>, 4> in_v;
    for (std::size_t a = 0; a < 4; ++a) {
        in_u[a] = polynomial(hermite()[a], u);
        in_v[a] = polynomial(hermite()[a], v);
    }
    PlaneSeries sum = {Series<1>(order), Series<1>(order)};
    for (std::size_t a = 0; a < 4; ++a) {
        add(sum, scaled(in_u[a], of_u[a]));
        // The mirror between the spokes takes (1, 0) to (c, s).
        const PlaneSeries other = {c * mirrored[a][0] + s * mirrored[a][1],
                                   s * mirrored[a][0] - c * mirrored[a][1]};
        add(sum, scaled(in_v[a], other));
        for (std::size_t b = 0; b < 4; ++b) {
            const Series<1> both = in_u[a] * in_v[b];
            sum[0] -= corner_[a][b].x() * both;
            sum[1] -= corner_[a][b].y() * both;
        }
    }
    const Vector2d x = star_.from_side(m, Vector2d::UnitX());
    const Vector2d y = star_.from_side(m, Vector2d::UnitY());
    return combine(sum[0], x, sum[1], y);
}

Vector2d QuadMap::at(int m, const Vector2d& at) const {
    const PlaneSeries p = expand(m, at, Vector2d::Ones(), 0);
    return {p[0].term(0, 0)[0], p[1].term(0, 0)[0]};
}

}  // namespace suture::manifold

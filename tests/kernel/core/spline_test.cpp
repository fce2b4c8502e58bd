#include "suture/base/tolerance.h"
#include "suture/spline/knots.h"
#include "suture/spline/surface.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace suture {
namespace {

using Eigen::Vector3d;

/// Degrees 4 x 2, 7 x 5 poles, uneven knots with a double one; rational if asked.
SplineSurface random_surface(bool rational, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    SplineSurface s;
    s.degree_u = 4;
    s.degree_v = 2;
    s.knots_u = {0, 0, 0, 0, 0, 0.3, 0.3, 2, 2, 2, 2, 2};
    s.knots_v = {-1, -1, -1, -0.2, 0.9, 1, 1, 1};
    s.poles.resize(3, s.count_u() * s.count_v());
    for (Eigen::Index k = 0; k < s.poles.size(); ++k) {
        s.poles.data()[k] = number(generator);
    }
    s.weights.resize(rational ? s.poles.cols() : 0);
    for (Eigen::Index k = 0; k < s.weights.size(); ++k) {
        s.weights[k] = 1.0 + 0.4 * number(generator);
    }
    return s;
}

/// The Cox-de Boor recursion as it is defined: the second way.
double cox_de_boor(const std::vector<double>& t, int i, int p, double x, double last) {
    const auto at = [&](int k) { return t[static_cast<std::size_t>(k)]; };
    if (p == 0) {
        return (at(i) <= x && x < at(i + 1)) || (x == last && at(i) < at(i + 1) && x == at(i + 1));
    }
    double sum = 0.0;
    if (at(i + p) > at(i)) {
        sum += (x - at(i)) / (at(i + p) - at(i)) * cox_de_boor(t, i, p - 1, x, last);
    }
    if (at(i + p + 1) > at(i + 1)) {
        sum += (at(i + p + 1) - x) / (at(i + p + 1) - at(i + 1)) *
               cox_de_boor(t, i + 1, p - 1, x, last);
    }
    return sum;
}

Vector3d by_definition(const SplineSurface& s, double u, double v) {
    Vector3d sum = Vector3d::Zero();
    double weight = 0.0;
    for (int j = 0; j < s.count_v(); ++j) {
        for (int i = 0; i < s.count_u(); ++i) {
            const double w = s.rational() ? s.weights[s.index(i, j)] : 1.0;
            const double N = w * cox_de_boor(s.knots_u, i, s.degree_u, u, 2.0) *
                             cox_de_boor(s.knots_v, j, s.degree_v, v, 1.0);
            sum += N * s.poles.col(s.index(i, j));
            weight += N;
        }
    }
    return sum / weight;
}

class SplineSurfaceTest : public testing::TestWithParam<bool> {};

TEST_P(SplineSurfaceTest, EqualsTheRecursiveDefinition) {
    const SplineSurface s = random_surface(GetParam(), 1);
    for (double u = 0.0; u <= 2.0; u += 0.1) {
        for (double v = -1.0; v <= 1.0; v += 0.1) {
            EXPECT_LT((evaluate(s, u, v).point - by_definition(s, u, v)).norm(), 1e-13);
        }
    }
    EXPECT_LT((evaluate(s, 2.0, 1.0).point - by_definition(s, 2.0, 1.0)).norm(), 1e-13);
}

TEST_P(SplineSurfaceTest, DerivativesEqualFiniteDifferences) {
    const SplineSurface s = random_surface(GetParam(), 2);
    const double h = 1e-5;
    const double u = 1.13;
    const double v = 0.31;
    const SurfaceJet jet = evaluate(s, u, v);
    const auto at = [&](double a, double b) { return evaluate(s, a, b); };
    EXPECT_LT((jet.u - (at(u + h, v).point - at(u - h, v).point) / (2 * h)).norm(), 1e-8);
    EXPECT_LT((jet.v - (at(u, v + h).point - at(u, v - h).point) / (2 * h)).norm(), 1e-8);
    EXPECT_LT((jet.uu - (at(u + h, v).u - at(u - h, v).u) / (2 * h)).norm(), 1e-7);
    EXPECT_LT((jet.uv - (at(u, v + h).u - at(u, v - h).u) / (2 * h)).norm(), 1e-7);
    EXPECT_LT((jet.vv - (at(u, v + h).v - at(u, v - h).v) / (2 * h)).norm(), 1e-7);
}

TEST_P(SplineSurfaceTest, ExtendedKeepsTheSurfaceAndContinuesTheOuterPolynomials) {
    const SplineSurface s = random_surface(GetParam(), 3);
    const SplineSurface longer = extended(s, -0.2, 2.1, -1.15, 1.3);
    EXPECT_EQ(longer.knots_u.front(), -0.2);
    EXPECT_EQ(longer.knots_v.back(), 1.3);
    EXPECT_EQ(longer.poles.cols(), s.poles.cols());
    for (double u = -0.2; u <= 2.1; u += 0.05) {
        for (double v = -1.15; v <= 1.3; v += 0.05) {
            // evaluate() continues the outermost polynomials by itself: the second way.
            EXPECT_LT((evaluate(longer, u, v).point - evaluate(s, u, v).point).norm(), 1e-10)
                << u << " " << v;
        }
    }
}

TEST_P(SplineSurfaceTest, ExtendedToItsOwnDomainIsTheSameToTheBit) {
    const SplineSurface s = random_surface(GetParam(), 4);
    const SplineSurface same = extended(s, 0.5, 1.5, -0.5, 0.5);
    EXPECT_EQ(same.knots_u, s.knots_u);
    EXPECT_EQ(same.knots_v, s.knots_v);
    EXPECT_LT((same.poles - s.poles).norm(), 1e-14);
}

TEST_P(SplineSurfaceTest, ExtendedPutsLooseEndKnotsToTheEnds) {
    SplineSurface s = random_surface(GetParam(), 7);
    s.knots_u = {-1, -0.5, -0.2, -0.1, 0, 0.3, 0.3, 2, 2.1, 2.5, 3, 4};
    const SplineSurface clamped = extended(s, 0.0, 0.0, 0.0, 0.0);
    EXPECT_EQ(clamped.knots_u.front(), 0.0);
    EXPECT_EQ(clamped.knots_u.back(), 2.0);
    for (double u = 0.0; u <= 2.0; u += 0.05) {
        EXPECT_LT((evaluate(clamped, u, 0.2).point - evaluate(s, u, 0.2).point).norm(), 1e-12);
    }
}

TEST_P(SplineSurfaceTest, RestrictedKeepsTheSurfaceOnASmallerDomain) {
    const SplineSurface s = random_surface(GetParam(), 8);
    struct Part {
        double u0, u1, v0, v1;
    };
    for (const Part& p :
         {Part{0.1, 1.3, -0.5, 0.95}, Part{0.3, 0.7, -0.2, 0.9}, Part{0.05, 0.2, 0.1, 0.3},
          Part{0.0, 0.3, -1.0, -0.2}, Part{-5.0, 5.0, 0.9, 3.0}}) {
        const SplineSurface r = restricted(s, p.u0, p.u1, p.v0, p.v1);
        const double u0 = std::max(p.u0, 0.0);
        const double u1 = std::min(p.u1, 2.0);
        const double v1 = std::min(p.v1, 1.0);
        EXPECT_EQ(r.knots_u.front(), u0);
        EXPECT_EQ(r.knots_u[4], u0);
        EXPECT_EQ(r.knots_u.back(), u1);
        EXPECT_EQ(r.knots_v[2], p.v0);
        EXPECT_EQ(r.knots_v.back(), v1);
        ASSERT_EQ(r.poles.cols(), r.count_u() * r.count_v());
        for (double f = 0.0; f <= 1.0; f += 0.1) {
            const double u = u0 + f * (u1 - u0);
            const double v = v1 + f * f * (p.v0 - v1);
            EXPECT_LT((evaluate(r, u, v).point - evaluate(s, u, v).point).norm(), 1e-12);
        }
    }
}

TEST_P(SplineSurfaceTest, TransposedExchangesUAndV) {
    const SplineSurface s = random_surface(GetParam(), 5);
    const SplineSurface t = transposed(s);
    EXPECT_EQ(t.degree_u, 2);
    EXPECT_LT((evaluate(t, 0.4, 1.7).point - evaluate(s, 1.7, 0.4).point).norm(), 1e-14);
    EXPECT_LT((evaluate(t, 0.4, 1.7).u - evaluate(s, 1.7, 0.4).v).norm(), 1e-13);
}

TEST_P(SplineSurfaceTest, RepeatedRunsThroughItsPeriodAgainAndAgain) {
    SplineSurface s = random_surface(GetParam(), 6);
    for (int j = 0; j < s.count_v(); ++j) {
        s.poles.col(s.index(s.count_u() - 1, j)) = s.poles.col(s.index(0, j));
        if (s.rational()) {
            s.weights[s.index(s.count_u() - 1, j)] = s.weights[s.index(0, j)];
        }
    }
    const SplineSurface r = repeated_u(s, 3, 1);
    EXPECT_EQ(r.knots_u.front(), -2.0);
    EXPECT_EQ(r.knots_u.back(), 4.0);
    ASSERT_EQ(r.poles.cols(), r.count_u() * r.count_v());
    for (double u = 0.01; u < 2.0; u += 0.17) {
        for (double v = -0.9; v < 1.0; v += 0.3) {
            const Vector3d truth = evaluate(s, u, v).point;
            EXPECT_LT((evaluate(r, u - 2.0, v).point - truth).norm(), 1e-12);
            EXPECT_LT((evaluate(r, u, v).point - truth).norm(), 1e-12);
            EXPECT_LT((evaluate(r, u + 2.0, v).point - truth).norm(), 1e-12);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(PolynomialAndRational, SplineSurfaceTest, testing::Bool());

TEST(FindSpan, StaysInTheDomainAndSkipsEmptySpans) {
    const std::vector<double> knots = {0, 0, 0, 1, 1, 2, 2, 2};
    EXPECT_EQ(find_span(knots, 2, -5.0), 2);
    EXPECT_EQ(find_span(knots, 2, 0.0), 2);
    EXPECT_EQ(find_span(knots, 2, 1.0), 4);
    EXPECT_EQ(find_span(knots, 2, 2.0), 4);
    EXPECT_EQ(find_span(knots, 2, 9.0), 4);
}

}  // namespace
}  // namespace suture

#include "suture/fill/mvs/variation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <gtest/gtest.h>

#include <cmath>

namespace suture::mvs {
namespace {

// grad II by its definition in coordinates, in the orthonormal frame (A G A^T)^(-1/2) A: the one
// that turns least when the surface changes from where A G A^T = I.
Eigen::Vector4d by_definition(const Derivatives& X, const Eigen::Matrix2d& A) {
    const auto first = [&](int i) { return Eigen::Vector3d(X.col(i)); };
    const auto second = [&](int i, int j) { return Eigen::Vector3d(X.col(2 + i + j)); };
    const auto third = [&](int i, int j, int k) { return Eigen::Vector3d(X.col(5 + i + j + k)); };
    const Eigen::Vector3d cross = first(0).cross(first(1));
    const Eigen::Vector3d n = cross.normalized();
    Eigen::Matrix2d g;
    g << first(0).dot(first(0)), first(0).dot(first(1)), first(1).dot(first(0)),
        first(1).dot(first(1));
    const Eigen::Matrix2d inverse = g.inverse();
    const auto christoffel = [&](int l, int i, int j) {
        return inverse(l, 0) * first(0).dot(second(i, j)) +
               inverse(l, 1) * first(1).dot(second(i, j));
    };
    const auto covariant = [&](int i, int j, int k) {
        double value = n.dot(third(i, j, k));
        for (int l = 0; l < 2; ++l) {
            value -= christoffel(l, i, j) * n.dot(second(l, k)) +
                     christoffel(l, k, i) * n.dot(second(l, j)) +
                     christoffel(l, k, j) * n.dot(second(i, l));
        }
        return value;
    };
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(A * g * A.transpose());
    const Eigen::Matrix2d frame = eigen.operatorInverseSqrt() * A;
    constexpr int kComponents[4][3] = {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    constexpr double kMultiplicity[4] = {1.0, 3.0, 3.0, 1.0};
    Eigen::Vector4d result = Eigen::Vector4d::Zero();
    for (int t = 0; t < 4; ++t) {
        for (int code = 0; code < 8; ++code) {
            const int i = code & 1;
            const int j = code >> 1 & 1;
            const int k = code >> 2;
            result[t] += frame(kComponents[t][0], i) * frame(kComponents[t][1], j) *
                         frame(kComponents[t][2], k) * covariant(i, j, k);
        }
        result[t] *= std::sqrt(kMultiplicity[t] * cross.norm());
    }
    return result;
}

Eigen::Matrix2d gram_schmidt(const Derivatives& X) {
    const double a = 1.0 / X.col(0).norm();
    const double shear = a * X.col(0).dot(X.col(1));
    const double height = (X.col(1) - shear * a * X.col(0)).norm();
    Eigen::Matrix2d A;
    A << a, 0.0, -shear * a / height, 1.0 / height;
    return A;
}

Derivatives some_derivatives(int which) {
    Derivatives X;
    for (int k = 0; k < X.size(); ++k) {
        X.data()[k] = std::sin(1.7 * (k + 1) + 2.3 * which) + 0.2 * std::cos(5.1 * k * which);
    }
    return X;
}

TEST(CurvatureVariation, FollowsItsDefinition) {
    for (int which = 1; which <= 5; ++which) {
        const Derivatives X = some_derivatives(which);
        const Eigen::Vector4d expected = by_definition(X, gram_schmidt(X));
        EXPECT_LT((curvature_variation(X) - expected).norm(), 1e-11 * expected.norm());
        const CurvatureVariation linearised = linearised_curvature_variation(X);
        EXPECT_LT((linearised.residual - expected).norm(), 1e-11 * expected.norm());
    }
}

TEST(CurvatureVariation, DerivativesMatchDifferences) {
    constexpr double kStep = 1e-5;
    for (int which = 1; which <= 5; ++which) {
        const Derivatives X = some_derivatives(which);
        const Eigen::Matrix2d A = gram_schmidt(X);
        const CurvatureVariation linearised = linearised_curvature_variation(X);
        const double size = linearised.jacobian.norm();
        for (int k = 0; k < 27; ++k) {
            Derivatives plus = X;
            Derivatives minus = X;
            plus.data()[k] += kStep;
            minus.data()[k] -= kStep;
            const Eigen::Vector4d slope =
                (by_definition(plus, A) - by_definition(minus, A)) / (2.0 * kStep);
            EXPECT_LT((linearised.jacobian.row(k).transpose() - slope).norm(), 1e-7 * size) << k;
        }
    }
}

// A sphere in longitude u and latitude v, and a graph whose curvature does vary.
TEST(CurvatureVariation, VanishesOnASphereAndNotOnACubic) {
    const double u = 0.3;
    const double v = 0.4;
    const double r = 2.0;
    const Eigen::Vector3d e(std::cos(u), std::sin(u), 0.0);
    const Eigen::Vector3d f(-std::sin(u), std::cos(u), 0.0);
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    const double c = std::cos(v);
    const double s = std::sin(v);
    Derivatives X;
    X << r * c * f, r * (-s * e + c * z), -r * c * e, -r * s * f, -r * (c * e + s * z), -r * c * f,
        r * s * e, -r * c * f, r * (s * e - c * z);
    EXPECT_LT(curvature_variation(X).norm(), 1e-14);
    Derivatives cubic = Derivatives::Zero();  // z = x^3 / 6 at the origin
    cubic.col(0) = Eigen::Vector3d::UnitX();
    cubic.col(1) = Eigen::Vector3d::UnitY();
    cubic.col(5) = Eigen::Vector3d::UnitZ();
    EXPECT_NEAR(curvature_variation(cubic).norm(), 1.0, 1e-15);
}

}  // namespace
}  // namespace suture::mvs

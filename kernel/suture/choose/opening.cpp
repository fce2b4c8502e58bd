#include "suture/choose/opening.h"

#include "suture/base/tolerance.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace suture {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 16;

/// How far from the opening's plane a cross tangent still lies in it.
constexpr double kInPlane = radians(1.0);

/// Twice the area that the border encloses seen along the normal; islands count against it.
double turned_area(const Hole& hole, const Opening& opening) {
    double area = 0.0;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            for (int k = 0; k < kSamples; ++k) {
                const RibbonPoint p = ribbon.at((k + 0.5) / kSamples);
                area += opening.normal.dot((p.point - opening.centre).cross(p.tangent)) / kSamples;
            }
        }
    }
    return area;
}

/// Angle between a cross tangent and the opening's plane.
double steepness_of(const Vector3d& inward, const Opening& opening) {
    return std::asin(std::min(1.0, std::abs(opening.normal.dot(inward.normalized()))));
}

}  // namespace

Opening opening_of(const Hole& hole) {
    std::vector<Vector3d> points;
    Opening opening;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            for (int k = 0; k < kSamples; ++k) {
                points.push_back(ribbon.at(static_cast<double>(k) / kSamples).point);
                opening.centre += points.back();
            }
        }
    }
    opening.centre /= static_cast<double>(points.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Vector3d& p : points) {
        covariance += (p - opening.centre) * (p - opening.centre).transpose();
    }
    opening.normal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
    for (const Vector3d& p : points) {
        opening.height = std::max(opening.height, std::abs(opening.normal.dot(p - opening.centre)));
    }
    if (turned_area(hole, opening) < 0.0) {
        opening.normal = -opening.normal;
    }
    return opening;
}

bool lies_in_opening(const Ribbon& ribbon, const Opening& opening) {
    for (int k = 0; k < kSamples; ++k) {
        const RibbonPoint p = ribbon.at((k + 0.5) / kSamples);
        const Vector3d into = opening.normal.cross(p.tangent).normalized();
        if (into.dot(p.inward.normalized()) > -std::cos(kInPlane)) {
            return false;
        }
    }
    return true;
}

std::pair<double, double> steepness_along(const Ribbon& ribbon, const Opening& opening) {
    std::pair<double, double> steepness(kPi / 2.0, 0.0);
    for (int k = 0; k < kSamples; ++k) {
        const double steep = steepness_of(ribbon.at((k + 0.5) / kSamples).inward, opening);
        steepness = {std::min(steepness.first, steep), std::max(steepness.second, steep)};
    }
    return steepness;
}

}  // namespace suture

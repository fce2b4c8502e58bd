#include "suture/fill/recognise/refine.h"

#include "suture/fill/recognise/form.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suture::recognise {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kSteps = 25;
/// Steps that come down by less lead nowhere.
constexpr double kSlow = 0.99;

/// Directions in which the points' noise would be amplified by more than this are left alone; the
/// least and the most singular value against the largest.
constexpr double kAmplified = 1e3;
constexpr double kLeastCut = 1e-8;
constexpr double kMostCut = 1e-3;

/// The derivatives of the distance by the sizes of a form.
std::vector<double> by_sizes(const Surface& form, const Vector3d& p) {
    const auto meridian = [&](const Frame& frame) -> std::pair<double, double> {
        const Vector3d d = p - frame.origin;
        const double h = d.dot(frame.z);
        return {(d - h * frame.z).norm(), h};
    };
    if (const auto* cone = std::get_if<Cone>(&form)) {
        const auto [rho, h] = meridian(cone->frame);
        const double c = std::cos(cone->half_angle);
        const double s = std::sin(cone->half_angle);
        return {-c, -(rho - cone->radius) * s - h * c};
    }
    if (const auto* torus = std::get_if<Torus>(&form)) {
        const auto [rho, h] = meridian(torus->frame);
        const double a = rho - torus->major;
        const double q = std::max(std::hypot(a, h), std::numeric_limits<double>::min());
        return {-a / q, -1.0};
    }
    if (std::holds_alternative<Plane>(form)) {
        return {};
    }
    return {-1.0};
}

/// The motions that are free: turns about the border's middle (first three of a column), shifts
/// (last three).
MatrixXd free_motions(const Surface& form, const Hold& hold) {
    const Frame& frame = frame_of(form);
    if (hold.axis) {
        MatrixXd motions = MatrixXd::Zero(6, 1);
        motions.col(0).tail<3>() = frame.z;
        return motions;
    }
    if (hold.direction) {
        MatrixXd motions = MatrixXd::Zero(6, 3);
        motions.bottomRows<3>().setIdentity();
        return motions;
    }
    return MatrixXd::Identity(6, 6);
}

void move(Surface& form, const VectorXd& motion) {
    Frame& frame = frame_of(form);
    const Vector3d turn = motion.head<3>();
    const double angle = turn.norm();
    if (angle > 0.0) {
        const Eigen::AngleAxisd rotation(angle, turn / angle);
        frame.origin = rotation * frame.origin;
        frame.z = (rotation * frame.z).normalized();
        const Vector3d x = rotation * frame.x;
        frame.x = (x - frame.z * frame.z.dot(x)).normalized();
        frame.y = frame.z.cross(frame.x);
    }
    frame.origin += motion.tail<3>();
}

/// What does not change the form: the reference point moves to the middle of the border.
void settle(Surface& form) {
    Frame& frame = frame_of(form);
    const double h = -frame.origin.dot(frame.z);
    if (std::holds_alternative<Cylinder>(form)) {
        frame.origin += h * frame.z;
    } else if (auto* cone = std::get_if<Cone>(&form)) {
        frame.origin += h * frame.z;
        cone->radius += h * std::tan(cone->half_angle);
    } else if (std::holds_alternative<Plane>(form)) {
        frame.origin = frame.z * frame.z.dot(frame.origin);
    }
}

/// Free sizes, by index.
std::vector<std::size_t> free_sizes(Surface& form, const Hold& hold) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < sizes_of(form).size(); ++i) {
        if (i >= hold.sizes.size() || !hold.sizes[i]) {
            result.push_back(i);
        }
    }
    return result;
}

}  // namespace

double rms(const Surface& form, const Border& border) {
    double sum = 0.0;
    for (Eigen::Index k = 0; k < border.points.cols(); ++k) {
        const double d = distance_to(form, border.points.col(k)).value;
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(border.points.cols()));
}

double middle(const Surface& form, const Border& border) {
    std::vector<double> off;
    off.reserve(static_cast<std::size_t>(border.count()));
    for (Eigen::Index k = 0; k < border.points.cols(); ++k) {
        off.push_back(std::abs(distance_to(form, border.points.col(k)).value));
    }
    const auto half = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
    std::nth_element(off.begin(), half, off.end());
    return *half;
}

namespace {

/// Huber's function of the distances: their squares up to `knee`, beyond it they count singly.
double cost(const Surface& form, const Border& border, double knee) {
    double sum = 0.0;
    for (Eigen::Index k = 0; k < border.points.cols(); ++k) {
        const double d = std::abs(distance_to(form, border.points.col(k)).value);
        sum += d < knee ? 0.5 * d * d / knee : d - 0.5 * knee;
    }
    return sum;
}

/// One step of Gauss and Newton.
Surface step(Surface form, const Border& border, const Hold& hold, double knee) {
    const Eigen::Index n = border.points.cols();
    const double cut = std::clamp(kAmplified * border.noise, kLeastCut, kMostCut);
    const MatrixXd motions = free_motions(form, hold);
    const std::vector<std::size_t> sizes = free_sizes(form, hold);
    const auto unknowns = motions.cols() + static_cast<Eigen::Index>(sizes.size());
    MatrixXd J(n, unknowns);
    VectorXd f(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const Vector3d p = border.points.col(k);
        const Distance d = distance_to(form, p);
        const double weight = std::sqrt(knee / std::max(std::abs(d.value), knee));
        Eigen::Matrix<double, 1, 6> by_motion;
        by_motion << -p.cross(d.normal).transpose(), -d.normal.transpose();
        J.row(k).head(motions.cols()) = weight * by_motion * motions;
        const std::vector<double> own = by_sizes(form, p);
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            J(k, motions.cols() + static_cast<Eigen::Index>(i)) = weight * own[sizes[i]];
        }
        f[k] = weight * d.value;
    }
    Eigen::JacobiSVD<MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(cut);
    const VectorXd x = svd.solve(-f);
    move(form, motions * x.head(motions.cols()));
    const std::vector<double*> values = sizes_of(form);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        *values[sizes[i]] += x[motions.cols() + static_cast<Eigen::Index>(i)];
    }
    settle(form);
    return form;
}

/// Steps as long as they come down.
Surface descend(Surface form, const Border& border, const Hold& hold, double knee) {
    double least = cost(form, border, knee);
    for (int k = 0; k < kSteps; ++k) {
        const Surface next = step(form, border, hold, knee);
        const double now = cost(next, border, knee);
        if (!(now < least)) {
            break;
        }
        const bool done = now > kSlow * least || middle(next, border) < border.rounding;
        least = now;
        form = next;
        if (done) {
            break;
        }
    }
    return form;
}

}  // namespace

Surface refine(Surface form, const Border& border, const Hold& hold) {
    settle(form);
    constexpr double kSquares = 1e3;  // larger than any distance
    form = descend(std::move(form), border, hold, kSquares);
    return descend(std::move(form), border, hold, border.noise);
}

}  // namespace suture::recognise

#include "suture/fill/concentric/height.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::concentric {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kQuadratic = 6;

double phi(const Vector2d& d) {
    const double r2 = d.squaredNorm();
    return r2 * r2 * std::sqrt(r2);
}
Vector2d gradient_of_phi(const Vector2d& d) {
    const double r = d.norm();
    return 5.0 * r * r * r * d;
}
Matrix2d hessian_of_phi(const Vector2d& d) {
    const double r = d.norm();
    return 5.0 * r * (r * r * Matrix2d::Identity() + 3.0 * d * d.transpose());
}

/// 1, x, y, x^2, x y, y^2 and their gradients.
VectorXd quadratic(const Vector2d& x) {
    VectorXd q(kQuadratic);
    q << 1.0, x.x(), x.y(), x.x() * x.x(), x.x() * x.y(), x.y() * x.y();
    return q;
}
MatrixXd gradient_of_quadratic(const Vector2d& x) {
    MatrixXd g(2, kQuadratic);
    g << 0.0, 1.0, 0.0, 2.0 * x.x(), x.y(), 0.0,  //
        0.0, 0.0, 1.0, 0.0, x.x(), 2.0 * x.y();
    return g;
}

/// Samples of all sides at first, and at most; of one side at least.
constexpr int kFirstSamples = 96;
constexpr int kMostSamples = 384;
constexpr int kLeastOfSide = 6;

/// How far the field may miss the neighbours, as a share of the wanted angle. Beyond that, more
/// samples would follow the errors of the model's own edges.
constexpr double kShare = 1.0;

/// Neighbours whose normals differ by more at a corner cannot both be met there.
constexpr double kSameNormal = radians(0.05);

HeightSample sample_of(const Ribbon& ribbon, const Boundary& boundary, double s, bool tangent) {
    const RibbonPoint p = ribbon.at(s);
    const Vector3d local = boundary.coordinates(p.point);
    HeightSample sample{local.head<2>(), local.z()};
    if (tangent) {
        const Frame& frame = boundary.frame;
        const Vector2d gradient(-p.normal.dot(frame.x), -p.normal.dot(frame.y));
        sample.direction = Vector2d(p.inward.dot(frame.x), p.inward.dot(frame.y)).normalized();
        sample.slope = sample.direction.dot(gradient) / p.normal.dot(frame.z);
    }
    return sample;
}

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Where along a side the field is to have the neighbour's tangent plane.
struct Wanted {
    double from = 0.0;
    double to = 1.0;
    [[nodiscard]] bool at(double s) const { return s >= from && s <= to; }
};

/// Not where position alone is wanted, and not beside a corner where the neighbours' normals
/// differ: there the field would bend sharply to come near both.
std::vector<Wanted> wanted_of(const Hole& hole) {
    const auto& ribbons = hole.loops.front().ribbons;
    std::vector<Wanted> all;
    all.reserve(ribbons.size());
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        const Ribbon& before = ribbons[(i + ribbons.size() - 1) % ribbons.size()];
        const Ribbon& after = ribbons[(i + 1) % ribbons.size()];
        const auto differ = [](const Ribbon& a, const Ribbon& b) {
            return std::min(a.continuity, b.continuity) >= Continuity::G1 &&
                   angle_between(a.at(1.0).normal, b.at(0.0).normal) > kSameNormal;
        };
        Wanted wanted{differ(before, ribbons[i]) ? kFade : 0.0,
                      differ(ribbons[i], after) ? 1.0 - kFade : 1.0};
        all.push_back(ribbons[i].continuity >= Continuity::G1 ? wanted : Wanted{1.0, 0.0});
    }
    return all;
}

/// Denser towards the ends by a factor of ten: an interpolant is worst near the corners. Still
/// denser samples would take the errors of the model's own edges for slopes.
double graded(double x) {
    return 0.1 * x + 0.9 * x * x * (3.0 - 2.0 * x);
}

double length_of(const Ribbon& ribbon) {
    constexpr int kChords = 16;
    double length = 0.0;
    for (int k = 0; k < kChords; ++k) {
        length += ribbon.at((k + 0.5) / kChords).tangent.norm() / kChords;
    }
    return length;
}

/// How many samples each side gets of so many.
std::vector<int> shares(const Hole& hole, int samples) {
    std::vector<double> lengths;
    double all = 0.0;
    for (const Ribbon& ribbon : hole.loops.front().ribbons) {
        lengths.push_back(length_of(ribbon));
        all += lengths.back();
    }
    std::vector<int> counts;
    counts.reserve(lengths.size());
    for (const double length : lengths) {
        counts.push_back(std::max(kLeastOfSide, static_cast<int>(samples * length / all)));
    }
    return counts;
}

/// The largest angle by which a field misses the tangent planes that are wanted, half way between
/// samples and at the corners.
double missed_angle(const HeightField& field, const Hole& hole, const Boundary& boundary,
                    const std::vector<int>& counts, const std::vector<Wanted>& wanted) {
    const Frame& frame = boundary.frame;
    double largest = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        for (int k = 0; k <= counts[i]; ++k) {
            const double s = graded(static_cast<double>(k) / counts[i]);
            if (wanted[i].at(s)) {
                const RibbonPoint p = hole.loops.front().ribbons[i].at(s);
                const Vector2d slope = field.gradient(boundary.coordinates(p.point).head<2>());
                const Vector3d normal = frame.z - slope.x() * frame.x - slope.y() * frame.y;
                largest = std::max(largest, angle_between(normal, p.normal));
            }
        }
    }
    return largest;
}

}  // namespace

HeightField HeightField::over(const Hole& hole, const Boundary& boundary,
                              const Tolerance& tolerance) {
    const std::vector<Wanted> wanted = wanted_of(hole);
    std::optional<HeightField> best;
    double least = INFINITY;
    for (int samples = kFirstSamples; samples <= kMostSamples; samples *= 2) {
        const std::vector<int> counts = shares(hole, samples);
        std::vector<HeightSample> all;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            for (int k = 0; k < counts[i]; ++k) {
                const double s = graded((k + 0.5) / counts[i]);
                all.push_back(
                    sample_of(hole.loops.front().ribbons[i], boundary, s, wanted[i].at(s)));
            }
        }
        HeightField field(std::move(all));
        const double missed = missed_angle(field, hole, boundary, counts, wanted);
        if (missed < least || !best) {
            best = std::move(field);
            least = missed;
        }
        if (least <= kShare * tolerance.angular) {
            break;
        }
    }
    return std::move(*best);
}

HeightField::HeightField(std::vector<HeightSample> samples) : samples_(std::move(samples)) {
    Vector2d low = samples_.front().at;
    Vector2d high = low;
    for (const HeightSample& sample : samples_) {
        low = low.cwiseMin(sample.at);
        high = high.cwiseMax(sample.at);
    }
    centre_ = 0.5 * (low + high);
    scale_ = std::max((high - low).maxCoeff(), 1e-300);
    const auto n = static_cast<int>(samples_.size());
    const int size = 2 * n + kQuadratic;
    MatrixXd A = MatrixXd::Zero(size, size);
    VectorXd b = VectorXd::Zero(size);
    for (HeightSample& sample : samples_) {
        sample.at = local(sample.at);
        sample.height /= scale_;
    }
    for (int i = 0; i < n; ++i) {
        const HeightSample& to = samples_[static_cast<std::size_t>(i)];
        for (int j = 0; j < n; ++j) {
            const HeightSample& from = samples_[static_cast<std::size_t>(j)];
            const Vector2d d = to.at - from.at;
            A(i, j) = phi(d);
            A(i, n + j) = -from.direction.dot(gradient_of_phi(d));
            A(n + i, j) = to.direction.dot(gradient_of_phi(d));
            A(n + i, n + j) = -to.direction.dot(hessian_of_phi(d) * from.direction);
        }
        A.row(i).tail(kQuadratic) = quadratic(to.at).transpose();
        A.row(n + i).tail(kQuadratic) = to.direction.transpose() * gradient_of_quadratic(to.at);
        A.col(i).tail(kQuadratic) = quadratic(to.at);
        A.col(n + i).tail(kQuadratic) = gradient_of_quadratic(to.at).transpose() * to.direction;
        b[i] = to.height;
        b[n + i] = to.slope;
        if (to.direction.isZero()) {
            A(n + i, n + i) = 1.0;  // no slope is asked for there
            b[n + i] = 0.0;
        }
    }
    const Eigen::PartialPivLU<MatrixXd> solver(A);
    weights_ = solver.solve(b);
    weights_ += solver.solve(b - A * weights_);
}

double HeightField::height(const Vector2d& x) const {
    const auto n = static_cast<int>(samples_.size());
    const Vector2d at = local(x);
    double sum = quadratic(at).dot(weights_.tail(kQuadratic));
    for (int j = 0; j < n; ++j) {
        const HeightSample& from = samples_[static_cast<std::size_t>(j)];
        sum += weights_[j] * phi(at - from.at) -
               weights_[n + j] * from.direction.dot(gradient_of_phi(at - from.at));
    }
    return sum * scale_;
}

Vector2d HeightField::gradient(const Vector2d& x) const {
    const auto n = static_cast<int>(samples_.size());
    const Vector2d at = local(x);
    Vector2d sum = gradient_of_quadratic(at) * weights_.tail(kQuadratic);
    for (int j = 0; j < n; ++j) {
        const HeightSample& from = samples_[static_cast<std::size_t>(j)];
        sum += weights_[j] * gradient_of_phi(at - from.at) -
               weights_[n + j] * (hessian_of_phi(at - from.at) * from.direction);
    }
    return sum;
}

double HeightField::least_distance(const ConcentricCurve& axis) const {
    double least = INFINITY;
    for (const Stop& stop : axis.stops) {
        for (const HeightSample& sample : samples_) {
            least = std::min(least, (local(axis.node(stop)) - sample.at).norm());
        }
    }
    return least * scale_;
}

}  // namespace suture::concentric

#include "suture/fill/recognise/starts.h"

#include "suture/base/tolerance.h"
#include "suture/fill/recognise/form.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>

namespace suture::recognise {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Singular values below this share of the largest are none.
constexpr double kRank = 1e-10;

/// More sides than this: pairs of neighbouring sides only.
constexpr std::size_t kAllPairs = 8;

/// A closed curve or an arc counts as circular within this share of the hole's size.
constexpr double kCircular = 1e-4;

/// Points with the normals that are there.
struct Cloud {
    Matrix3Xd points, normals;
};

Cloud cloud_of(const Border& border, const std::vector<std::size_t>& sides) {
    Cloud cloud;
    const auto n = static_cast<Eigen::Index>(sides.size()) * Border::kSamples;
    cloud.points.resize(3, n);
    cloud.normals.resize(3, n);
    Eigen::Index next = 0;
    for (const std::size_t side : sides) {
        const int first = border.sides[side].first;
        cloud.points.middleCols<Border::kSamples>(next) =
            border.points.middleCols<Border::kSamples>(first);
        cloud.normals.middleCols<Border::kSamples>(next) =
            border.normals.middleCols<Border::kSamples>(first);
        next += Border::kSamples;
    }
    return cloud;
}

Matrix3Xd centred(const Matrix3Xd& m) {
    return m.colwise() - Vector3d(m.rowwise().mean());
}

/// Eigenvectors of a symmetric matrix, the smallest eigenvalue's first.
Matrix3d axes_of(const Matrix3d& S) {
    return Eigen::SelfAdjointEigenSolver<Matrix3d>(S).eigenvectors();
}

/// centre and radius of p = centre + radius n by least squares; radius signed.
template <class Points>
std::pair<Eigen::VectorXd, double> centre_by_normals(const Points& p, const Points& n) {
    const Eigen::VectorXd p0 = p.rowwise().mean();
    const Eigen::VectorXd n0 = n.rowwise().mean();
    const auto dn = (n.colwise() - n0).eval();
    const double variance = dn.squaredNorm();
    const double radius =
        variance > 0.0 ? (p.colwise() - p0).cwiseProduct(dn).sum() / variance : 0.0;
    return {p0 - radius * n0, radius};
}

/// Kasa's circle or sphere: |p|^2 = 2 p.c + k.
template <class Points>
std::pair<Eigen::VectorXd, double> centre_by_points(const Points& p) {
    const Eigen::Index d = p.rows();
    MatrixXd A(p.cols(), d + 1);
    A << 2.0 * p.transpose(), VectorXd::Ones(p.cols());
    const VectorXd x = A.colPivHouseholderQr().solve(p.colwise().squaredNorm().transpose());
    const VectorXd c = x.head(d);
    return {c, std::sqrt(std::max(x[d] + c.squaredNorm(), 0.0))};
}

Sphere sphere_of(const VectorXd& centre, double radius) {
    return {{centre, Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()}, std::abs(radius)};
}

/// In the plane across a frame's axis.
Eigen::Matrix2Xd across(const Frame& frame, const Matrix3Xd& m) {
    Eigen::Matrix2Xd result(2, m.cols());
    result << frame.x.transpose() * m, frame.y.transpose() * m;
    return result;
}

/// (rho, height) about a frame's axis, and normals in that half plane.
struct Profile {
    Eigen::Matrix2Xd points, normals;
};

Profile profile_of(const Frame& frame, const Cloud& cloud) {
    Profile profile{Eigen::Matrix2Xd(2, cloud.points.cols()),
                    Eigen::Matrix2Xd(2, cloud.points.cols())};
    for (Eigen::Index k = 0; k < cloud.points.cols(); ++k) {
        const Vector3d d = cloud.points.col(k) - frame.origin;
        const double h = d.dot(frame.z);
        const Vector3d radial = d - h * frame.z;
        const double rho = radial.norm();
        const Vector3d e = rho > 0.0 ? Vector3d(radial / rho) : frame.x;
        const Vector3d n = cloud.normals.col(k);
        profile.points.col(k) << rho, h;
        profile.normals.col(k) << n.dot(e), n.dot(frame.z);
    }
    return profile;
}

class Collector {
  public:
    explicit Collector(const Border& border) : border_(border) {}

    Starts take() { return std::move(starts_); }

    void by_normals(const std::vector<std::size_t>& sides) {
        const Cloud cloud = cloud_of(border_, sides);
        const auto [centre, radius] = centre_by_normals(cloud.points, cloud.normals);
        add(sphere_of(centre, radius));
        const Matrix3d N = cloud.normals * cloud.normals.transpose();
        const Matrix3d axes = axes_of(N);
        add_plane(axes.col(2));
        along({Vector3d::Zero(), axes.col(1), axes.col(2), axes.col(0)}, cloud);
        cone_by_normals(cloud);
        about(axis_by_normals(cloud), cloud);
    }

    void plane_by_points() {
        const Matrix3Xd p = centred(border_.points);
        add_plane(axes_of(p * p.transpose()).col(0));
    }

    void sphere_by_points() {
        const auto [centre, radius] = centre_by_points(border_.points);
        add(sphere_of(centre, radius));
    }

    /// A cylinder along a frame's axis.
    void along(Frame frame, const Cloud& cloud) {
        frame.y = frame.z.cross(frame.x);
        const auto add_cylinder = [&](const VectorXd& c, double radius) {
            Cylinder cylinder{frame, std::abs(radius)};
            cylinder.frame.origin = frame.x * c[0] + frame.y * c[1];
            add(cylinder);
        };
        const auto [n_centre, n_radius] =
            centre_by_normals(across(frame, cloud.points), across(frame, cloud.normals));
        add_cylinder(n_centre, n_radius);
        const auto [p_centre, p_radius] = centre_by_points(across(frame, border_.points));
        add_cylinder(p_centre, p_radius);
    }

    /// Surfaces of revolution about a frame's axis.
    void about(const Frame& frame, const Cloud& cloud) {
        const auto add_torus = [&](const VectorXd& c, double radius) {
            Torus torus{frame, c[0], std::abs(radius)};
            torus.frame.origin += c[1] * frame.z;
            add(torus);
        };
        const Profile profile = profile_of(frame, cloud);
        const auto [n_centre, n_radius] = centre_by_normals(profile.points, profile.normals);
        add_torus(n_centre, n_radius);
        const Profile all = profile_of(frame, {border_.points, border_.normals});
        const auto [p_centre, p_radius] = centre_by_points(all.points);
        add_torus(p_centre, p_radius);
        const Vector2d mean = all.points.rowwise().mean();
        const Eigen::Matrix2Xd d = all.points.colwise() - mean;
        const Eigen::Matrix2d S = d * d.transpose();
        const Vector2d line =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(S).eigenvectors().col(1);
        Frame place = frame;
        place.origin += mean.y() * frame.z;
        add(Cylinder{place, mean.x()});
        add_cone(place, mean.x(), std::atan2(line.x(), line.y()));
    }

  private:
    const Border& border_;
    Starts starts_;

    void add(const Surface& form) {
        if (!sensible(form)) {
            return;
        }
        constexpr std::size_t kPlace[] = {0, 2, 3, 1, 4};  // in the order of the variant
        starts_[kPlace[form.index()]].push_back(form);
    }

    void add_plane(const Vector3d& normal) {
        add(Plane{frame_along(border_.points.rowwise().mean(), normal)});
    }

    void add_cone(Frame frame, double radius, double half_angle) {
        half_angle = std::remainder(half_angle, kPi);
        if (half_angle < 0.0) {
            frame.z = -frame.z;
            frame.y = -frame.y;
            half_angle = -half_angle;
        }
        add(Cone{frame, radius, half_angle});
    }

    /// The normals of a cone lie on a circle of the Gauss sphere, about its axis; its tangent
    /// planes meet in the apex.
    void cone_by_normals(const Cloud& cloud) {
        const Matrix3Xd d = centred(cloud.normals);
        const Vector3d axis = axes_of(d * d.transpose()).col(0);
        const VectorXd heights =
            cloud.points.cwiseProduct(cloud.normals).colwise().sum().transpose();
        const Vector3d apex = cloud.normals.transpose().colPivHouseholderQr().solve(heights);
        Frame frame = frame_along(apex, axis);
        const Vector3d middle = border_.points.rowwise().mean();
        const double height = (middle - apex).dot(frame.z);
        const double sine = std::abs((frame.z.transpose() * cloud.normals).mean());
        const double half_angle = std::asin(std::min(sine, 1.0));
        if (height < 0.0) {
            frame = frame_along(apex, -frame.z);
        }
        frame.origin += std::abs(height) * frame.z;
        add(Cone{frame, std::abs(height) * std::tan(half_angle), half_angle});
    }

    static Frame axis_by_normals(const Cloud& cloud) {
        const Matrix3Xd& A = cloud.normals;
        Matrix3Xd B(3, A.cols());
        for (Eigen::Index k = 0; k < A.cols(); ++k) {
            B.col(k) = cloud.points.col(k).cross(A.col(k));
        }
        const Matrix3d AA = A * A.transpose();
        const Matrix3d AB = A * B.transpose();
        const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(AA);
        Vector3d inverse = Vector3d::Zero();
        for (int i = 0; i < 3; ++i) {
            if (eigen.eigenvalues()[i] > kRank * eigen.eigenvalues()[2]) {
                inverse[i] = 1.0 / eigen.eigenvalues()[i];
            }
        }
        const Matrix3d pseudo =
            eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
        const Matrix3d S = B * B.transpose() - AB.transpose() * pseudo * AB;
        const Vector3d c = axes_of(S).col(0);
        const Vector3d moment = -pseudo * AB * c;
        return frame_along(c.cross(moment), c);
    }
};

/// The axis of a side that is an arc of a circle.
std::vector<Frame> circle_axes(const Border& border) {
    std::vector<Frame> axes;
    for (const Side& side : border.sides) {
        const Matrix3Xd p = border.points.middleCols<Border::kSamples>(side.first);
        const Matrix3Xd d = centred(p);
        const Vector3d normal = axes_of(d * d.transpose()).col(0);
        const double off_plane = (normal.transpose() * d).cwiseAbs().maxCoeff();
        Frame frame = frame_along(p.rowwise().mean(), normal);
        const Eigen::Matrix2Xd q = across(frame, d);
        const auto [c, radius] = centre_by_points(q);
        const double off_circle =
            ((q.colwise() - Vector2d(c)).colwise().norm().array() - radius).abs().maxCoeff();
        if (off_plane < kCircular && off_circle < kCircular && radius < 10.0) {
            frame.origin += c[0] * frame.x + c[1] * frame.y;
            axes.push_back(frame);
        }
    }
    return axes;
}

/// Each line or direction once.
std::vector<Frame> distinct(const std::vector<Frame>& frames, bool lines) {
    constexpr double kSame = 1e-6;
    std::vector<Frame> result;
    for (const Frame& frame : frames) {
        const bool known = std::any_of(result.begin(), result.end(), [&](const Frame& other) {
            const Vector3d apart = frame.origin - other.origin;
            return frame.z.cross(other.z).norm() < kSame &&
                   (!lines || frame.z.cross(apart).norm() < kSame);
        });
        if (!known) {
            result.push_back(frame);
        }
    }
    return result;
}

/// All sides; all but one; single ones; pairs.
std::vector<std::vector<std::size_t>> subsets(std::size_t n) {
    std::vector<std::vector<std::size_t>> result(1);
    for (std::size_t i = 0; i < n; ++i) {
        result.front().push_back(i);
    }
    for (std::size_t i = 0; n > 1 && i < n; ++i) {
        result.push_back({i});
        if (n > 2) {
            std::vector<std::size_t> others = result.front();
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
            result.push_back(others);
        }
        for (std::size_t j = i + 1; n > 3 && j < n; ++j) {
            if (n <= kAllPairs || j == i + 1) {
                result.push_back({i, j});
            }
        }
    }
    return result;
}

/// From the middle of one of two loops to that of the other: the axis of a bore.
std::vector<Frame> bore_axes(const Border& border) {
    std::array<Vector3d, 2> middles = {Vector3d::Zero(), Vector3d::Zero()};
    std::array<int, 2> counts = {0, 0};
    for (const Side& side : border.sides) {
        if (side.loop > 1) {
            return {};
        }
        const auto loop = static_cast<std::size_t>(side.loop);
        middles[loop] += border.points.middleCols<Border::kSamples>(side.first).rowwise().sum();
        counts[loop] += Border::kSamples;
    }
    if (counts[1] == 0) {
        return {};
    }
    const Vector3d from = middles[0] / counts[0];
    const Vector3d way = middles[1] / counts[1] - from;
    return way.norm() > kCircular ? std::vector{frame_along(from, way.normalized())}
                                  : std::vector<Frame>();
}

}  // namespace

std::vector<Frame> neighbour_axes(const Border& border) {
    std::vector<Frame> axes;
    for (const Side& side : border.sides) {
        const auto& support = side.ribbon->support;
        if (support && closed_form(support->surface)) {
            axes.push_back(frame_of(border.to_local(support->surface)));
        }
    }
    return axes;
}

Starts starts_for(const Border& border) {
    Collector collector(border);
    collector.plane_by_points();
    for (const std::vector<std::size_t>& sides : subsets(border.sides.size())) {
        collector.by_normals(sides);
    }
    collector.sphere_by_points();
    const Cloud all{border.points, border.normals};
    std::vector<Frame> axes = neighbour_axes(border);
    for (const Frame& frame : distinct(axes, /*lines=*/false)) {
        collector.along(frame, all);
    }
    const std::vector<Frame> circles = circle_axes(border);
    axes.insert(axes.begin(), circles.begin(), circles.end());
    for (const Frame& frame : distinct(axes, /*lines=*/true)) {
        collector.about(frame, all);
    }
    return collector.take();
}

Starts rim_starts(const Border& border) {
    Collector collector(border);
    const Cloud all{border.points, border.normals};
    for (const Frame& frame : bore_axes(border)) {
        collector.along(frame, all);
        collector.about(frame, all);
    }
    return collector.take();
}

}  // namespace suture::recognise

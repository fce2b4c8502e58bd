#include "suture/fill/recognise/form.h"

#include "suture/base/contract.h"
#include "suture/base/tolerance.h"

#include <Eigen/Geometry>

#include <cmath>

namespace suture::recognise {
namespace {

using Eigen::Vector3d;

/// A point in cylindrical coordinates about a frame's axis.
struct Meridian {
    double rho, height;
    Vector3d e;  ///< radial, unit

    Meridian(const Frame& frame, const Vector3d& point) {
        const Vector3d d = point - frame.origin;
        height = d.dot(frame.z);
        const Vector3d radial = d - height * frame.z;
        rho = radial.norm();
        e = rho > 0.0 ? Vector3d(radial / rho) : frame.x;
    }
};

Distance distance(const Plane& plane, const Vector3d& p) {
    return {(p - plane.frame.origin).dot(plane.frame.z), plane.frame.z};
}
Distance distance(const Sphere& sphere, const Vector3d& p) {
    const Vector3d d = p - sphere.frame.origin;
    const double rho = d.norm();
    return {rho - sphere.radius, rho > 0.0 ? Vector3d(d / rho) : sphere.frame.z};
}
Distance distance(const Cylinder& cylinder, const Vector3d& p) {
    const Meridian m(cylinder.frame, p);
    return {m.rho - cylinder.radius, m.e};
}
Distance distance(const Cone& cone, const Vector3d& p) {
    const Meridian m(cone.frame, p);
    const double c = std::cos(cone.half_angle);
    const double s = std::sin(cone.half_angle);
    return {(m.rho - cone.radius) * c - m.height * s, c * m.e - s * cone.frame.z};
}
Distance distance(const Torus& torus, const Vector3d& p) {
    const Meridian m(torus.frame, p);
    const double a = m.rho - torus.major;
    const double q = std::hypot(a, m.height);
    return {q - torus.minor,
            q > 0.0 ? Vector3d((a * m.e + m.height * torus.frame.z) / q) : Vector3d(m.e)};
}
template <class Other>
Distance distance(const Other& /*surface*/, const Vector3d& /*p*/) {
    throw ContractViolation("only closed forms have a distance in closed form");
}

/// A torus whose major radius is below this share of the minor one imitates a sphere. Between this
/// and 1 it meets itself, and the outside of it is a fillet's all the same.
constexpr double kLeastMajor = 1e-3;

/// Larger than this, against the hole: a plane or a cylinder that is called something else.
constexpr double kLargest = 100.0;

/// Between this and its complement the half angle of a cone.
constexpr double kHalfAngle = radians(0.2);

}  // namespace

Distance distance_to(const Surface& form, const Vector3d& point) {
    return std::visit([&](const auto& f) { return distance(f, point); }, form);
}

std::vector<double*> sizes_of(Surface& form) {
    if (auto* cylinder = std::get_if<Cylinder>(&form)) {
        return {&cylinder->radius};
    }
    if (auto* cone = std::get_if<Cone>(&form)) {
        return {&cone->radius, &cone->half_angle};
    }
    if (auto* sphere = std::get_if<Sphere>(&form)) {
        return {&sphere->radius};
    }
    if (auto* torus = std::get_if<Torus>(&form)) {
        return {&torus->major, &torus->minor};
    }
    return {};
}

Frame& frame_of(Surface& form) {
    return std::visit(
        [](auto& f) -> Frame& {
            if constexpr (requires { f.frame; }) {
                return f.frame;
            } else {
                throw ContractViolation("only closed forms have a frame");
            }
        },
        form);
}

const Frame& frame_of(const Surface& form) {
    return frame_of(const_cast<Surface&>(form));  // NOLINT: it is not changed
}

Frame frame_along(const Vector3d& origin, const Vector3d& z) {
    Frame frame;
    frame.origin = origin;
    frame.z = z.normalized();
    frame.x = frame.z.unitOrthogonal();
    frame.y = frame.z.cross(frame.x);
    return frame;
}

bool sensible(const Surface& form) {
    if (!frame_of(form).origin.allFinite() || !frame_of(form).z.allFinite()) {
        return false;
    }
    if (const auto* sphere = std::get_if<Sphere>(&form)) {
        return sphere->radius > 0.0 && sphere->radius < kLargest;
    }
    if (const auto* cylinder = std::get_if<Cylinder>(&form)) {
        return cylinder->radius > 0.0 && cylinder->radius < kLargest;
    }
    if (const auto* cone = std::get_if<Cone>(&form)) {
        const double a = std::abs(cone->half_angle);
        return a > kHalfAngle && a < kPi / 2.0 - kHalfAngle && std::abs(cone->radius) < kLargest;
    }
    if (const auto* torus = std::get_if<Torus>(&form)) {
        return torus->minor > 0.0 && torus->major > kLeastMajor * torus->minor &&
               torus->major < kLargest;
    }
    return true;
}

int complexity(const Surface& form) {
    constexpr int kParameters[] = {3, 5, 6, 4, 7, 1000};  // in the order of the variant
    return kParameters[form.index()];
}

}  // namespace suture::recognise

#pragma once

#include "support/trim_of.h"
#include "suture/base/tolerance.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"
#include "suture/model/surface.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

/// Round windows cut out of a surface in closed form, as ribbons that know their support.
namespace suture::windows {

/// Turned, moved, of any handedness of the world: a frame with nothing special about it.
inline Frame tilted(double scale = 1.0, double angle = 0.7) {
    const Eigen::AngleAxisd turn(angle, Eigen::Vector3d(1, -2, 0.5).normalized());
    return {scale * Eigen::Vector3d(3, -1, 2), turn * Eigen::Vector3d::UnitX(),
            turn * Eigen::Vector3d::UnitY(), turn * Eigen::Vector3d::UnitZ()};
}

struct Window {
    Eigen::Vector2d centre;
    Eigen::Vector2d radius;
    int sides = 3;
    bool reversed = false;  ///< the material's outside is -(X_u x X_v)
};

/// One side of a window.
inline Ribbon ribbon_on(const Surface& surface, const Window& w, int side) {
    // With the normal reversed the hole lies to the left when the window is walked clockwise.
    const double sign = w.reversed ? -1.0 : 1.0;
    const auto uv = [w, side, sign](double s) -> Eigen::Vector2d {
        const double phi = sign * 2.0 * kPi * (side + s) / w.sides;
        return w.centre + w.radius.cwiseProduct(Eigen::Vector2d(std::cos(phi), std::sin(phi)));
    };
    const auto velocity = [w, side, sign](double s) -> Eigen::Vector2d {
        const double phi = sign * 2.0 * kPi * (side + s) / w.sides;
        return sign * 2.0 * kPi / w.sides *
               w.radius.cwiseProduct(Eigen::Vector2d(-std::sin(phi), std::cos(phi)));
    };
    Ribbon ribbon;
    ribbon.edge = side + 1;
    ribbon.face = side + 1;
    ribbon.support = Support{surface, w.reversed, uv};
    ribbon.at = [surface, uv, velocity, sign](double s) {
        const Eigen::Vector2d at = uv(s);
        const SurfaceJet jet = evaluate(surface, at.x(), at.y());
        RibbonPoint p;
        p.point = jet.point;
        p.normal = sign * jet.u.cross(jet.v).normalized();
        p.tangent = jet.u * velocity(s).x() + jet.v * velocity(s).y();
        p.inward = p.normal.cross(p.tangent).normalized();
        Eigen::Matrix<double, 3, 2> J;
        J << jet.u, jet.v;
        Eigen::Matrix2d II;
        II << p.normal.dot(jet.uu), p.normal.dot(jet.uv), p.normal.dot(jet.uv),
            p.normal.dot(jet.vv);
        const Eigen::Matrix<double, 3, 2> dual = J * (J.transpose() * J).inverse();
        p.curvature = dual * II * dual.transpose();
        return p;
    };
    return ribbon;
}

inline double diameter_of(const Hole& hole) {
    Eigen::AlignedBox3d box;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            for (int k = 0; k <= 64; ++k) {
                box.extend(ribbon.at(k / 64.0).point);
            }
        }
    }
    return box.diagonal().norm();
}

inline Hole window_in(const Surface& surface, const Window& window) {
    Hole hole;
    auto& loop = hole.loops.emplace_back();
    for (int side = 0; side < window.sides; ++side) {
        loop.ribbons.push_back(ribbon_on(surface, window, side));
    }
    hole.diameter = diameter_of(hole);
    return hole;
}

/// The largest distance between the ribbons and where a patch's trimming curves put them, and the
/// largest angle between the normals there.
struct Fit {
    double gap = 0.0;
    double angle = 0.0;
};

inline Fit fit_of(const Hole& hole, const Patch& patch) {
    Fit fit;
    for (std::size_t l = 0; l < hole.loops.size(); ++l) {
        for (std::size_t i = 0; i < hole.loops[l].ribbons.size(); ++i) {
            for (int k = 0; k <= 40; ++k) {
                const RibbonPoint p = hole.loops[l].ribbons[i].at(k / 40.0);
                const Eigen::Vector2d uv = test::trim_of(patch, l, i)(k / 40.0);
                const SurfaceJet jet = evaluate(patch.surface, uv.x(), uv.y());
                const Eigen::Vector3d n =
                    (patch.reversed ? -1.0 : 1.0) * jet.u.cross(jet.v).normalized();
                fit.gap = std::max(fit.gap, (jet.point - p.point).norm());
                fit.angle =
                    std::max(fit.angle, std::atan2(n.cross(p.normal).norm(), n.dot(p.normal)));
            }
        }
    }
    return fit;
}

/// The largest jump of the trimming curves from one edge to the next: 0 for closed wires.
inline double largest_jump(const Patch& patch) {
    double jump = 0.0;
    for (const std::vector<EdgeUse>& wire : patch.wires) {
        for (std::size_t i = 0; i < wire.size(); ++i) {
            const EdgeUse& use = wire[i];
            const EdgeUse& next = wire[(i + 1) % wire.size()];
            if (!use.pole_after) {
                const Eigen::Vector2d end = use.at(use.backwards ? 0.0 : 1.0);
                jump = std::max(jump, (next.at(next.backwards ? 1.0 : 0.0) - end).norm());
            }
        }
    }
    return jump;
}

}  // namespace suture::windows

#include "suture/fill/tube/quality.h"

#include "suture/fill/tube/directions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::tube {
namespace {

using Eigen::Vector3d;

constexpr int kAcross = 6;  // samples a patch
constexpr int kAround = 3;

Vector3d normal_at(const Net& net, double u, int interval, double v) {
    const SurfaceJet jet = evaluate(net, u, interval, v);
    return jet.u.cross(jet.v);
}

/// Places across the tube, the pole excluded and the border included.
std::vector<double> places_across(const Net& net) {
    std::vector<double> places;
    for (int span = kDegreeU; span < net.rows(); ++span) {
        const double low = net.knots_u[static_cast<std::size_t>(span)];
        const double high = net.knots_u[static_cast<std::size_t>(span) + 1];
        for (int k = 1; k <= kAcross; ++k) {
            places.push_back(low + (high - low) * k / kAcross);
        }
    }
    return places;
}

}  // namespace

std::vector<Crease> measure_creases(const Net& net) {
    const std::vector<double> places = places_across(net);
    std::vector<Crease> creases;
    for (const Ring::Double& corner : net.ring.doubles()) {
        Crease crease;
        crease.column = corner.column;
        // The empty interval is the one before the column; its neighbours end and begin there.
        const int before = net.ring.wrapped(corner.column - 2);
        const int after = net.ring.wrapped(corner.column);
        const double end = net.ring.start(before) + net.ring.interval(before);
        const double begin = net.ring.start(after);
        for (const double u : places) {
            const double angle =
                angle_between(normal_at(net, u, before, end), normal_at(net, u, after, begin));
            // At the border itself the neighbours alone decide.
            if (u < net.border() && angle > crease.angle) {
                crease.angle = angle;
                crease.u = u;
            }
        }
        creases.push_back(crease);
    }
    return creases;
}

Fold measure_fold(const Net& net, const Vector3d& normal) {
    const std::vector<double> places = places_across(net);
    Fold fold;
    for (int k = 0; k < net.columns(); ++k) {
        const double g = net.ring.interval(k);
        for (int q = 0; q < kAround && g > 0.0; ++q) {
            const double v = net.ring.start(k) + g * (q + 0.5) / kAround;
            Vector3d last = normal;
            for (const double u : places) {
                const Vector3d here = normal_at(net, u, k, v);
                const double turn = angle_between(last, here);
                if (!(turn <= fold.turn)) {
                    fold.turn = turn;
                    fold.u = u;
                    fold.v = v;
                    fold.interval = k;
                }
                last = here;
            }
        }
    }
    return fold;
}

double pole_deviation(const Net& net, const Vector3d& normal, double u) {
    double worst = 0.0;
    for (int k = 0; k < net.columns(); ++k) {
        const double g = net.ring.interval(k);
        for (int q = 0; q < kAround && g > 0.0; ++q) {
            const double v = net.ring.start(k) + g * (q + 0.5) / kAround;
            worst = std::max(worst, angle_between(normal_at(net, u, k, v), normal));
        }
    }
    return worst;
}

}  // namespace suture::tube

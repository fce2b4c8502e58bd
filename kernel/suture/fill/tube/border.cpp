#include "suture/fill/tube/border.h"

#include "suture/fill/tube/directions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace suture::tube {

using Eigen::Vector3d;

Border::Border(RibbonLoop around, Radials radials, const Vector3d& pole, double length, double u)
    : loop_(std::move(around)), radials_(std::move(radials)), pole_(pole), u_(u), starts_{0.0} {
    const RibbonLoop& loop = loop_;
    double total = 0.0;
    for (const Ribbon& ribbon : loop.ribbons) {
        courses_.emplace_back(ribbon);
        total += courses_.back().length();
    }
    for (const Course& course : courses_) {
        starts_.push_back(starts_.back() + length * course.length() / total);
    }
    starts_.back() = length;
    const auto n = loop.ribbons.size();
    bends_.assign(n, {Vector3d::Zero(), Vector3d::Zero()});
    for (std::size_t i = 0; i < n; ++i) {
        if (joins_smoothly(loop.ribbons[i])) {
            continue;
        }
        const auto bend = [&](std::size_t next, double s) -> Vector3d {
            if (!joins_smoothly(loop.ribbons[next])) {
                return Vector3d::Zero();
            }
            const RibbonPoint there = loop.ribbons[next].at(s);
            return radials_.outward(static_cast<int>(next), s, there).normalized() -
                   (there.point - pole).normalized();
        };
        bends_[i] = {bend((i + n - 1) % n, 1.0), bend((i + 1) % n, 0.0)};
    }
    shifts_.resize(n);
    for (int side = 0; side < sides(); ++side) {
        bring_together(side);
    }
}

double Border::s_of(int side, double v) const {
    return course(side).s_of(course(side).length() * v / extent(side));
}

double Border::v_of(int side, double s) const {
    return extent(side) * course(side).length_of(s) / course(side).length();
}

Vector3d Border::outward(int side, double s, const RibbonPoint& at) const {
    const Vector3d radial = radials_.outward(side, s, at);
    if (joins_smoothly(ribbon(side))) {
        return radial / u_;
    }
    const auto& [first, last] = bends_[static_cast<std::size_t>(side)];
    const Vector3d away = (at.point - pole_).normalized();
    return (away + (1.0 - s) * first + s * last).normalized() * (radial.norm() / u_);
}

BorderPoint Border::at(int side, double v) const {
    const double s = s_of(side, v);
    const RibbonPoint at = ribbon(side).at(s);
    const double by_v = course(side).length() / (extent(side) * course(side).speed_of(s));  // ds/dv
    BorderPoint result{at.point,
                       at.point,
                       outward(side, s, at),
                       at.normal,
                       by_v * at.tangent,
                       has_layout() ? radials_.in_plane(side, s) : Eigen::Vector2d(0.0, 0.0)};
    const double t = v / extent(side);
    const double late = t * t * (3.0 - 2.0 * t);
    const double slope = 6.0 * t * (1.0 - t) / extent(side);
    const auto& [first, last] = shifts_[static_cast<std::size_t>(side)];
    result.point += (1.0 - late) * first.point + late * last.point;
    result.tangent += slope * (last.point - first.point);
    result.outward += (1.0 - late) * first.outward + late * last.outward;
    result.plane += (1.0 - late) * first.plane + late * last.plane;
    return result;
}

void Border::bring_together(int side) {
    const int before = (side + sides() - 1) % sides();
    const BorderPoint a = at(before, extent(before));
    const BorderPoint b = at(side, 0.0);
    // The outward tangent should be in both tangent planes. What it is off by turns the normal the
    // more, the less it leads away from the border; so that side counts more. Where only one of the
    // two is to be met tangentially, it alone counts.
    const auto leads_away = [](const BorderPoint& at) {
        return at.outward.normalized().cross(at.tangent.normalized()).norm();
    };
    double share = leads_away(b) / (leads_away(a) + leads_away(b));
    if (joins_smoothly(ribbon(before)) != joins_smoothly(ribbon(side))) {
        share = joins_smoothly(ribbon(before)) ? 1.0 : 0.0;
    }
    const Vector3d point = 0.5 * (a.point + b.point);
    const Vector3d outward = share * a.outward + (1.0 - share) * b.outward;
    const Eigen::Vector2d plane = 0.5 * (a.plane + b.plane);
    shifts_[static_cast<std::size_t>(before)][1] = {point - a.point, outward - a.outward,
                                                    plane - a.plane};
    shifts_[static_cast<std::size_t>(side)][0] = {point - b.point, outward - b.outward,
                                                  plane - b.plane};
}

double Border::turn(int side) const {
    const int before = (side + sides() - 1) % sides();
    return angle_between(ribbon(before).at(1.0).tangent, ribbon(side).at(0.0).tangent);
}

bool Border::is_sharp(int side, const Tolerance& tolerance) const {
    const int before = (side + sides() - 1) % sides();
    const Vector3d a = at(before, extent(before)).tangent;
    const Vector3d b = at(side, 0.0).tangent;
    // What is below that is not seen by any measure of the border.
    constexpr double kUnseen = 0.1;
    return (a - b).norm() > kUnseen * tolerance.angular * std::min(a.norm(), b.norm());
}

}  // namespace suture::tube

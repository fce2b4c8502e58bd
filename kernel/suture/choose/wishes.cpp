#include "suture/choose/wishes.h"

#include "suture/choose/opening.h"
#include "suture/fill/fill.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace suture {
namespace {

using Eigen::Vector3d;

/// Out of flatness, as a fraction of the diameter, that still counts as a planar opening.
constexpr double kPlanar = 1e-6;

/// Out of flatness, as a fraction of the diameter, up to which the best plane says how the
/// neighbours stand on the opening.
constexpr double kShallow = 0.1;

/// Cross tangents steeper than this on a planar opening mean an opening, not a missing skin: half
/// way between a skin that lies in the plane and a duct that stands on it.
constexpr double kSteep = radians(45.0);

/// Neighbours whose normals differ by less than this at a corner are one smooth surrounding, as
/// faces that a translator has moved a little still are.
constexpr double kSmoothCorner = radians(10.0);

/// A neighbour whose cross tangent points further than this away from the middle of the hole
/// leads away from it.
constexpr double kAway = radians(65.0);

/// Normals that differ by less are the same at a corner: what files of good quality have.
constexpr double kSameNormal = radians(0.1);

/// Curvatures that differ by less, as a share of the larger one, are the same at a corner; half of
/// what the default profile calls G2.
constexpr double kSameCurvature = 0.01;

/// Sides within the tolerance are steps in a border if they make up no more of it than this.
constexpr double kStepShare = 0.01;

/// A bend over the whole hole of less than this is no curvature, in radians.
constexpr double kFlat = 1e-3;

/// Side by side, in the order of the loops.
template <class Predicate>
std::vector<bool> sides_where(const Hole& hole, Predicate&& holds) {
    std::vector<bool> sides;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            sides.push_back(holds(ribbon));
        }
    }
    return sides;
}

/// Length of the polygon through a few points of a side, model units.
double length_of(const Ribbon& ribbon) {
    constexpr int kChords = 8;
    double length = 0.0;
    Vector3d before = ribbon.at(0.0).point;
    for (int k = 1; k <= kChords; ++k) {
        const Vector3d point = ribbon.at(static_cast<double>(k) / kChords).point;
        length += (point - before).norm();
        before = point;
    }
    return length;
}

/// Which sides are steps within the tolerance in a border that is otherwise much longer: where they
/// lead, and so their cross tangents, tells nothing of the opening.
std::vector<bool> steps_in(const Hole& hole, double tolerance) {
    double border = 0.0;
    double steps = 0.0;
    std::vector<bool> small = sides_where(hole, [&](const Ribbon& ribbon) {
        const double length = length_of(ribbon);
        border += length;
        steps += length <= tolerance ? length : 0.0;
        return length <= tolerance;
    });
    if (steps > kStepShare * border) {
        small.assign(small.size(), false);
    }
    return small;
}

/// The smallest angle between a cross tangent and the opening's plane, of the sides that are no
/// steps and whose neighbours do not lie in it.
double least_steepness(const Hole& hole, const Opening& opening, double tolerance) {
    const std::vector<bool> steps = steps_in(hole, tolerance);
    double least = kPi / 2.0;
    std::size_t side = 0;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            if (steps[side++] || is_free(ribbon) || lies_in_opening(ribbon, opening)) {
                continue;
            }
            least = std::min(least, steepness_along(ribbon, opening).first);
        }
    }
    return least;
}

double mismatch(const Ribbon& before, const Ribbon& after) {
    if (is_free(before) || is_free(after)) {
        return 0.0;  // a curve has no normal of its own
    }
    const Vector3d a = before.at(1.0).normal;
    const Vector3d b = after.at(0.0).normal;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// How far the side's cross tangent points away from the middle of the hole.
double awayness(const Ribbon& ribbon, const Vector3d& centre) {
    const RibbonPoint middle = ribbon.at(0.5);
    const Vector3d towards = centre - middle.point;
    return std::atan2(middle.inward.cross(towards).norm(), middle.inward.dot(towards));
}

/// Where two ribbons meet.
struct Joint {
    const Ribbon& before;
    const Ribbon& after;
};

/// Why no surface can have the curvature of both neighbours there; empty if one can.
std::string curvature_conflict(const Joint& joint, double diameter) {
    if (is_free(joint.before) || is_free(joint.after)) {
        return "the curve beside it, whose own curvature no face has to have";
    }
    if (mismatch(joint.before, joint.after) > kSameNormal) {
        return fmt::format("the normals of faces {} and {} differ by {:.2g} deg where they meet",
                           joint.before.face, joint.after.face,
                           degrees(mismatch(joint.before, joint.after)));
    }
    const Eigen::Matrix3d a = joint.before.at(1.0).curvature;
    const Eigen::Matrix3d b = joint.after.at(0.0).curvature;
    const double largest = std::max(a.norm(), b.norm());
    const double difference = (a - b).norm();
    if (difference <= std::max(kSameCurvature * largest, kFlat / diameter)) {
        return {};
    }
    return fmt::format("the curvatures of faces {} and {} differ by {:.3g} % where they meet",
                       joint.before.face, joint.after.face,
                       100.0 * std::min(1.0, difference / largest));
}

/// By how much any face with this border is sharp to the side's neighbour where the side meets the
/// next one: both border curves lie in its tangent plane there, and the next one leaves the
/// neighbour's. Nothing where the curves run into each other, for then they span no plane.
double border_sharpness(const RibbonPoint& own, const RibbonPoint& next) {
    const double across = own.tangent.normalized().cross(next.tangent.normalized()).norm();
    if (across < std::sin(kSmoothCorner)) {
        return 0.0;
    }
    return std::asin(std::min(1.0, std::abs(own.normal.dot(next.tangent.normalized())) / across));
}

Wish automatic(const RibbonLoop& loop, std::size_t i, const Vector3d& centre, double diameter,
               bool curvature) {
    const std::size_t n = loop.ribbons.size();
    const Ribbon& ribbon = loop.ribbons[i];
    const Joint start{loop.ribbons[(i + n - 1) % n], ribbon};
    const Joint end{ribbon, loop.ribbons[(i + 1) % n]};
    const double worst =
        std::max(mismatch(start.before, start.after), mismatch(end.before, end.after));
    const double away = awayness(ribbon, centre);
    if (worst > kSmoothCorner && away > kAway) {
        return {Continuity::G0,
                fmt::format("face {} leads away from the hole by {:.0f} deg and meets its "
                            "neighbours at {:.0f} deg",
                            ribbon.face, degrees(away), degrees(worst))};
    }
    const double sharp = std::min(border_sharpness(ribbon.at(0.0), start.before.at(1.0)),
                                  border_sharpness(ribbon.at(1.0), end.after.at(0.0)));
    if (sharp > kSmoothCorner) {
        return {Continuity::G0,
                fmt::format("at both ends of it the border leaves the plane of face {} by {:.0f} "
                            "deg or more: no face within it is tangent there",
                            ribbon.face, degrees(sharp)),
                /*hoped=*/false,
                /*own=*/false,
                /*given_up=*/false,
                /*wall=*/false,
                /*sharp=*/true};
    }
    if (!curvature) {
        return {Continuity::G1, "auto: tangent to the neighbour", /*hoped=*/false, /*own=*/true};
    }
    for (const Joint& joint : {start, end}) {
        if (const std::string conflict = curvature_conflict(joint, diameter); !conflict.empty()) {
            return {Continuity::G1, "auto: tangent only, for " + conflict, /*hoped=*/false,
                    /*own=*/true};
        }
    }
    return {Continuity::G2, "auto: the neighbours' curvatures agree at both ends", /*hoped=*/true,
            /*own=*/true};
}

/// What to ask a method for at most: `auto` has methods for everything, and OCCT's filling is not
/// asked for more than tangency unless the user does.
Continuity highest_of(const std::string& method) {
    for (const FillMethod& row : fill_methods()) {
        if (row.id == method) {
            return row.highest;
        }
    }
    return method == "auto" ? Continuity::G2 : Continuity::G1;
}

/// What an opening asks for along one of its sides; nothing for a skin to be continued.
std::optional<Wish> wish_of_opening(const Ribbon& ribbon, const Opening& opening, bool planar,
                                    double steepness) {
    if (steepness > kSteep) {
        return Wish{
            Continuity::G0,
            fmt::format("the neighbours stand on the opening at {:.0f} deg or more, as walls do",
                        degrees(steepness))};
    }
    if (planar && lies_in_opening(ribbon, opening)) {
        return Wish{Continuity::G0,
                    fmt::format("face {} lies in the planar opening itself", ribbon.face)};
    }
    return std::nullopt;
}

/// What the request says of one side.
std::optional<Wish> asked(const Ribbon& ribbon, const FillRequest& request) {
    if (is_free(ribbon)) {
        return Wish{Continuity::G0, ribbon.edge == 0
                                        ? "a curve that was made to close the border"
                                        : fmt::format("edge {} has no face", ribbon.edge)};
    }
    const auto own = request.edge_continuity.find(ribbon.edge);
    if (own != request.edge_continuity.end()) {
        return Wish{own->second, "as asked for this edge"};
    }
    if (request.continuity) {
        return Wish{*request.continuity, "as asked"};
    }
    if (request.supports.contains(ribbon.edge)) {
        return Wish{Continuity::G1, fmt::format("tangent to face {}, its support", ribbon.face)};
    }
    return std::nullopt;
}

}  // namespace

std::vector<Wish> wishes_for(const Hole& hole, const FillRequest& request) {
    const Opening opening = opening_of(hole);
    const bool planar = opening.height <= kPlanar * hole.diameter;
    const bool shallow = opening.height <= kShallow * hole.diameter;
    const double steepness =
        shallow ? least_steepness(hole, opening, request.tolerance.linear) : 0.0;
    const Continuity highest = highest_of(request.method);
    std::vector<Wish> wishes;
    for (const RibbonLoop& loop : hole.loops) {
        for (std::size_t i = 0; i < loop.ribbons.size(); ++i) {
            const Ribbon& ribbon = loop.ribbons[i];
            std::optional<Wish> wish = asked(ribbon, request);
            if (!wish && highest == Continuity::G0) {
                wish = Wish{Continuity::G0, "the method joins in position only"};
            }
            if (!wish) {
                wish = wish_of_opening(ribbon, opening, planar, steepness);
            }
            wishes.push_back(wish ? *wish
                                  : automatic(loop, i, opening.centre, hole.diameter,
                                              highest >= Continuity::G2));
        }
    }
    return wishes;
}

std::vector<bool> steep_sides(const Hole& hole) {
    const Opening opening = opening_of(hole);
    return sides_where(hole, [&](const Ribbon& ribbon) {
        return steepness_along(ribbon, opening).second > kSteep;
    });
}

std::vector<bool> odd_sides(const Hole& hole, double angle) {
    std::vector<bool> odd;
    for (const RibbonLoop& loop : hole.loops) {
        const std::size_t n = loop.ribbons.size();
        // Whether the normals miss each other where side i begins.
        const auto missed = [&](std::size_t i) {
            return mismatch(loop.ribbons[(i + n - 1) % n], loop.ribbons[i % n]) > angle;
        };
        for (std::size_t i = 0; i < n; ++i) {
            odd.push_back(n > 2 && missed(i) && missed(i + 1) && !missed(i + n - 1) &&
                          !missed(i + 2));
        }
    }
    return odd;
}

std::vector<bool> walls_of(const Hole& hole) {
    const Opening opening = opening_of(hole);
    const bool shallow = opening.height <= kShallow * hole.diameter;
    return sides_where(hole, [&](const Ribbon& ribbon) {
        return shallow && !is_free(ribbon) && steepness_along(ribbon, opening).first > kSteep;
    });
}

}  // namespace suture

#include "suture/fill/recognise/plain.h"

#include "suture/base/tolerance.h"
#include "suture/fill/recognise/form.h"
#include "suture/fill/recognise/refine.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace suture::recognise {
namespace {

using Eigen::Vector3d;

constexpr double kGrowth = 1.15;
/// A number that is met by chance in one of so many cases may cost more: normals and points of a
/// border that is a little inexact all along agree with others as well.
constexpr double kTelling = 1e-3;
constexpr double kGrowthOfTelling = 2.5;
/// Of the coordinates' own rounding: below this a fit is exact.
constexpr double kExact = 8.0;
/// Directions, positions and sizes further away than this are others.
constexpr double kNear = 1e-3;
/// A plain number has to lie nearer than this share of its own step, or it is one by chance.
constexpr double kByChance = 0.01;

/// Two lengths are the same number.
constexpr double kSameNumber = 1e-12;

constexpr double kInch = 25.4;

/// Steps of plain lengths, coarse ones first.
constexpr double kLengths[] = {10.0, 5.0,          1.0,   0.5,         0.25,
                               0.1,  kInch / 16,   0.05,  kInch / 32,  kInch / 64,
                               0.01, kInch / 1000, 0.001, kInch * 1e-4};
constexpr double kAngles[] = {radians(15.0), radians(5.0), radians(1.0), radians(0.5),
                              radians(0.1)};

/// How probable it is that a value lies by chance as near to a multiple of the steps as to this
/// one, the coarsest that it is a multiple of.
double chance_among(double value, double round, std::span<const double> steps) {
    double tried = 0.0;
    for (const double step : steps) {
        tried += 1.0;
        if (std::abs(std::remainder(round, step)) < kSameNumber * round) {
            return std::min(1.0, tried * 2.0 * std::abs(value - round) / step);
        }
    }
    return 1.0;
}

/// The multiples of the steps that lie so near to a value that it is not by chance.
std::vector<double> round_values(double value, std::span<const double> steps) {
    std::vector<double> result;
    for (const double step : steps) {
        const double round = std::round(value / step) * step;
        if (round > 0.0 && std::abs(round - value) < kByChance * step) {
            result.push_back(round);
        }
    }
    return result;
}

class Plain {
  public:
    Plain(const Surface& form, const Border& border)
        : border_(border), form_(form), middle_(middle(form, border)) {
        hold_.sizes.resize(sizes_of(form_).size(), false);
    }

    PlainForm make() {
        if (!std::holds_alternative<Sphere>(form_)) {
            direction();
        }
        for (std::size_t i = 0; i < hold_.sizes.size(); ++i) {
            size(i);
        }
        if (std::holds_alternative<Plane>(form_)) {
            chance_ = turn_chance_;
        }
        return {form_, facts_, chance_};
    }

  private:
    const Border& border_;
    Surface form_;
    double middle_;
    Hold hold_;
    std::vector<std::string> facts_;
    double chance_ = 1.0;
    double turn_chance_ = 1.0;

    bool keep(const Surface& start, const Hold& hold, double growth = kGrowth) {
        const Surface tried = refine(start, border_, hold);
        const double now = middle(tried, border_);
        if (!sensible(tried) || now > std::max(growth * middle_, kExact * border_.rounding)) {
            return false;
        }
        form_ = tried;
        hold_ = hold;
        return true;
    }

    /// The form with another axis, its reference point as near as possible.
    [[nodiscard]] Surface with_axis(const Vector3d& point, const Vector3d& along) const {
        Surface result = form_;
        Frame& frame = frame_of(result);
        const Vector3d z = along.dot(frame.z) < 0.0 ? Vector3d(-along) : along;
        frame = frame_along(point + z * z.dot(frame.origin - point), z);
        return result;
    }

    void direction() {
        const Frame here = frame_of(form_);
        double tried = 0.0;
        // Directions within an angle of a given line are this share of all.
        const auto met = [&](const Vector3d& axis) {
            turn_chance_ = std::min(1.0, tried * 0.5 * axis.cross(here.z).squaredNorm());
        };
        const bool turned = !std::holds_alternative<Plane>(form_);
        for (const Side& side : border_.sides) {
            const auto& support = side.ribbon->support;
            if (!support || !closed_form(support->surface) ||
                std::holds_alternative<Sphere>(support->surface)) {
                continue;
            }
            const Frame axis = frame_of(border_.to_local(support->surface));
            tried += 1.0;
            if (axis.z.cross(here.z).norm() > kNear) {
                continue;
            }
            const bool has_axis = !std::holds_alternative<Plane>(support->surface);
            Hold hold = hold_;
            hold.direction = true;
            if (turned && has_axis && axis.z.cross(here.origin - axis.origin).norm() < kNear) {
                hold.axis = true;
                if (keep(with_axis(axis.origin, axis.z), hold)) {
                    met(axis.z);
                    facts_.push_back(fmt::format("axis that of face {}", side.ribbon->face));
                    return;
                }
                hold.axis = false;
            }
            if (keep(with_axis(here.origin, axis.z), hold)) {
                met(axis.z);
                facts_.push_back(
                    has_axis ? fmt::format("axis parallel to face {}'s", side.ribbon->face)
                             : fmt::format("axis at right angles to face {}", side.ribbon->face));
                return;
            }
        }
        for (const Vector3d& axis : {Vector3d(Vector3d::UnitX()), Vector3d(Vector3d::UnitY()),
                                     Vector3d(Vector3d::UnitZ())}) {
            Hold hold = hold_;
            hold.direction = true;
            tried += 1.0;
            if (axis.cross(here.z).norm() < kNear && keep(with_axis(here.origin, axis), hold)) {
                met(axis);
                return;
            }
        }
    }

    /// Tries a size, in the border's unit.
    bool try_size(std::size_t i, double value, double chance) {
        Surface start = form_;
        double& target = *sizes_of(start)[i];
        if (std::abs(value - target) > kNear * std::abs(target)) {
            return false;
        }
        target = value;
        Hold hold = hold_;
        hold.sizes[i] = true;
        return keep(start, hold, chance < kTelling ? kGrowthOfTelling : kGrowth);
    }

    void size(std::size_t i) {
        const bool angle = std::holds_alternative<Cone>(form_) && i == 1;
        if (std::holds_alternative<Cone>(form_) && i == 0) {
            return;  // it only tells where the reference point lies
        }
        if (!angle && as_neighbour(i)) {
            return;
        }
        const double unit = angle ? 1.0 : border_.size;
        const double value = *sizes_of(form_)[i] * unit;
        const auto steps =
            angle ? std::span<const double>(kAngles) : std::span<const double>(kLengths);
        for (const double round : round_values(value, steps)) {
            const double chance = chance_among(value, round, steps);
            if (try_size(i, round / unit, chance)) {
                chance_ = std::min(chance_, chance);
                return;
            }
        }
    }

    bool as_neighbour(std::size_t i) {
        const double value = *sizes_of(form_)[i];
        double tried = 0.0;
        for (const Side& side : border_.sides) {
            if (!side.ribbon->support) {
                continue;
            }
            Surface other = side.ribbon->support->surface;
            const std::vector<double*> sizes = sizes_of(other);
            for (const double* size : sizes) {
                tried += 1.0;
                // A size that was already met exactly says nothing new, but names its source.
                const double off = std::abs(value - *size / border_.size);
                const double chance = tried * 2.0 * off / value;
                if (!std::holds_alternative<Cone>(other) &&
                    try_size(i, *size / border_.size, chance)) {
                    chance_ = std::min(chance_, chance);
                    facts_.push_back(fmt::format("{} as of face {}",
                                                 sizes_of(form_).size() == 2 && i == 0 ? "R" : "r",
                                                 side.ribbon->face));
                    return true;
                }
            }
        }
        return false;
    }
};

}  // namespace

PlainForm plain(const Surface& form, const Border& border) {
    return Plain(form, border).make();
}

std::optional<double> find_round_length(double length, double slack) {
    for (const double round : round_values(length, kLengths)) {
        if (std::abs(round - length) <= slack) {
            return round;
        }
    }
    return std::nullopt;
}

double chance_of_round(double length, double round) {
    return chance_among(length, round, kLengths);
}

}  // namespace suture::recognise

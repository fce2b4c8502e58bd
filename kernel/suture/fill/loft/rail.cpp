#include "suture/fill/loft/rail.h"

#include "suture/base/contract.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace suture::loft {
namespace {

/// The length of a side is summed over so many pieces.
constexpr int kPieces = 64;

/// Steps of Newton's method from one piece to the parameter; each doubles the digits.
constexpr int kSteps = 6;

/// Gauss's rule of three points, exact to degree 5.
constexpr std::array kGauss{std::pair(-0.7745966692414834, 5.0 / 18.0), std::pair(0.0, 8.0 / 18.0),
                            std::pair(0.7745966692414834, 5.0 / 18.0)};

double length_between(const std::function<RibbonPoint(double)>& side, double from, double to) {
    double length = 0.0;
    for (const auto& [node, weight] : kGauss) {
        const double s = 0.5 * (from + to) + 0.5 * (to - from) * node;
        length += weight * (to - from) * side(s).tangent.norm();
    }
    return length;
}

}  // namespace

double Rail::Side::length_to(double s) const {
    const double place = std::clamp(s, 0.0, 1.0) * kPieces;
    const auto piece = static_cast<std::size_t>(std::min(std::floor(place), kPieces - 1.0));
    const double from = static_cast<double>(piece) / kPieces;
    return lengths[piece] + length_between(at, from, std::clamp(s, 0.0, 1.0));
}

double Rail::Side::at_length(double length) const {
    const auto above = std::ranges::upper_bound(lengths, length);
    const auto piece = std::clamp<std::ptrdiff_t>(above - lengths.begin() - 1, 0, kPieces - 1);
    double s = (static_cast<double>(piece) + 0.5) / kPieces;
    for (int k = 0; k < kSteps; ++k) {
        const double speed = at(s).tangent.norm();
        if (!(speed > 0.0)) {
            break;
        }
        s = std::clamp(s - (length_to(s) - length) / speed, 0.0, 1.0);
    }
    return s;
}

Rail::Rail(const RibbonLoop& loop, std::vector<std::size_t> sides, bool backwards)
    : sides_(std::move(sides)), backwards_(backwards) {
    SUTURE_EXPECTS(!sides_.empty());
    for (const std::size_t index : sides_) {
        Side side{loop.ribbons[index].at, total_, {0.0}};
        for (int k = 0; k < kPieces; ++k) {
            side.lengths.push_back(side.lengths.back() +
                                   length_between(side.at, static_cast<double>(k) / kPieces,
                                                  static_cast<double>(k + 1) / kPieces));
        }
        total_ += side.lengths.back();
        table_.push_back(std::move(side));
    }
}

RibbonPoint Rail::at(double u) const {
    if (u < 0.0 || u > 1.0) {
        u -= std::floor(u);
    }
    if (backwards_) {
        u = 1.0 - u;
    }
    if (table_.size() == 1) {
        return table_.front().at(u);
    }
    const double length = u * total_;
    auto side = std::ranges::find_if(
        table_, [&](const Side& s) { return length <= s.before + s.lengths.back(); });
    side = side == table_.end() ? std::prev(side) : side;
    RibbonPoint point = side->at(side->at_length(length - side->before));
    point.tangent *= total_ / point.tangent.norm();
    return point;
}

double Rail::place_of(std::size_t side, double s) const {
    const auto index = std::ranges::find(sides_, side) - sides_.begin();
    const Side& entry = table_[static_cast<std::size_t>(index)];
    const double u = table_.size() == 1 ? s : (entry.before + entry.length_to(s)) / total_;
    return backwards_ ? 1.0 - u : u;
}

std::vector<double> Rail::joints() const {
    std::vector<double> joints;
    for (const std::size_t side : sides_) {
        joints.push_back(place_of(side, 0.0));
    }
    joints.push_back(place_of(sides_.back(), 1.0));
    std::ranges::sort(joints);
    return joints;
}

}  // namespace suture::loft

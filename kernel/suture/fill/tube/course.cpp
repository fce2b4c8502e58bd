#include "suture/fill/tube/course.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace suture::tube {
namespace {

/// Enough for a side whose speed varies by orders of magnitude: the length need not be exact, only
/// smooth and the same in both directions.
constexpr int kPanels = 128;

/// Up to this ratio of speeds a side keeps its parameter.
constexpr double kEven = 3.0;

constexpr std::array kNodes = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                               0.93056815579702629};
constexpr std::array kWeights = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                 0.17392742256872693};

}  // namespace

Course::Course(const Ribbon& ribbon)
    : at_(ribbon.at), lengths_{0.0}, slowest_(INFINITY), fastest_(0.0), even_(false) {
    for (int k = 0; k < kPanels; ++k) {
        const double from = static_cast<double>(k) / kPanels;
        const double to = static_cast<double>(k + 1) / kPanels;
        lengths_.push_back(lengths_.back() + piece(from, to));
        const double speed = (lengths_.back() - lengths_[lengths_.size() - 2]) * kPanels;
        slowest_ = std::min(slowest_, speed);
        fastest_ = std::max(fastest_, speed);
    }
    even_ = fastest_ < kEven * slowest_;
}

double Course::piece(double from, double to) const {
    double sum = 0.0;
    for (std::size_t q = 0; q < kNodes.size(); ++q) {
        sum += kWeights[q] * at_(from + (to - from) * kNodes[q]).tangent.norm();
    }
    return sum * (to - from);
}

double Course::length_of(double s) const {
    if (even_) {
        return s * length();
    }
    const int panel = std::clamp(static_cast<int>(s * kPanels), 0, kPanels - 1);
    return lengths_[static_cast<std::size_t>(panel)] +
           piece(static_cast<double>(panel) / kPanels, s);
}

double Course::s_of(double length_wanted) const {
    if (even_) {
        return length_wanted / length();
    }
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length_wanted);
    const auto panel = static_cast<double>(after - lengths_.begin() - 1);
    double low = panel / kPanels;
    double high = (panel + 1.0) / kPanels;
    double s = low + (high - low) * (length_wanted - *(after - 1)) / (*after - *(after - 1));
    constexpr int kMostSteps = 60;
    for (int step = 0; step < kMostSteps; ++step) {
        const double off = length_of(s) - length_wanted;
        (off > 0.0 ? high : low) = s;
        const double speed = at_(s).tangent.norm();
        double next = speed > 0.0 ? s - off / speed : 0.5 * (low + high);
        if (!(next > low && next < high)) {
            next = 0.5 * (low + high);
        }
        if (std::abs(next - s) <= 1e-16 + 1e-15 * std::abs(s)) {
            break;
        }
        s = next;
    }
    return s;
}

}  // namespace suture::tube

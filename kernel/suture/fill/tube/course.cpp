#include "suture/fill/tube/course.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace suture::tube {
namespace {

/// Enough for a side whose speed varies by orders of magnitude: the length need not be exact, only
/// smooth and the same in both directions.
constexpr int kPanels = 128;

/// Up to this ratio of speeds a side keeps its parameter: any side, or a quadratic one.
constexpr double kEven = 1.01;
constexpr double kEvenIfQuadratic = 3.0;

bool is_quadratic(const Ribbon& ribbon) {
    return ribbon.curve && ribbon.curve->degree <= 2;
}

constexpr std::array kNodes = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                               0.93056815579702629};
constexpr std::array kWeights = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                 0.17392742256872693};

}  // namespace

Course::Course(const Ribbon& ribbon) : lengths_{0.0} {
    const auto speed = [&](double s) { return ribbon.at(s).tangent.norm(); };
    double slowest = INFINITY;
    double fastest = 0.0;
    speeds_.push_back(speed(0.0));
    for (int k = 0; k < kPanels; ++k) {
        double mean = 0.0;
        for (std::size_t q = 0; q < kNodes.size(); ++q) {
            mean += kWeights[q] * speed((k + kNodes[q]) / kPanels);
        }
        slowest = std::min(slowest, mean);
        fastest = std::max(fastest, mean);
        lengths_.push_back(lengths_.back() + mean / kPanels);
        speeds_.push_back(speed((k + 1.0) / kPanels));
    }
    even_ = fastest < (is_quadratic(ribbon) ? kEvenIfQuadratic : kEven) * slowest;
}

std::pair<std::size_t, double> Course::panel_of(double s) const {
    const int panel = std::clamp(static_cast<int>(s * kPanels), 0, kPanels - 1);
    return {static_cast<std::size_t>(panel), s * kPanels - panel};
}

std::pair<double, double> Course::length_in(std::size_t panel, double t) const {
    const double rise = lengths_[panel + 1] - lengths_[panel];
    // No slope beyond three times the mean: the cubic then rises everywhere.
    const double a = std::min(speeds_[panel] / kPanels, 3.0 * rise);
    const double b = std::min(speeds_[panel + 1] / kPanels, 3.0 * rise);
    const double square = 3.0 * rise - 2.0 * a - b;
    const double cube = a + b - 2.0 * rise;
    return {lengths_[panel] + t * (a + t * (square + t * cube)),
            a + t * (2.0 * square + 3.0 * t * cube)};
}

double Course::length_of(double s) const {
    if (even_) {
        return s * length();
    }
    const auto [panel, t] = panel_of(s);
    return length_in(panel, t).first;
}

double Course::speed_of(double s) const {
    if (even_) {
        return length();
    }
    const auto [panel, t] = panel_of(s);
    return length_in(panel, t).second * kPanels;
}

double Course::s_of(double wanted) const {
    if (even_) {
        return wanted / length();
    }
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, wanted);
    const auto panel = static_cast<std::size_t>(after - lengths_.begin() - 1);
    double low = 0.0;
    double high = 1.0;
    double t = (wanted - lengths_[panel]) / (lengths_[panel + 1] - lengths_[panel]);
    constexpr int kMostSteps = 60;
    for (int step = 0; step < kMostSteps; ++step) {
        const auto [reached, slope] = length_in(panel, t);
        (reached > wanted ? high : low) = t;
        double next = t - (reached - wanted) / slope;
        if (!(next > low && next < high)) {
            next = 0.5 * (low + high);
        }
        const bool done = std::abs(next - t) <= 1e-15;
        t = next;
        if (done) {
            break;
        }
    }
    return (static_cast<double>(panel) + t) / kPanels;
}

}  // namespace suture::tube

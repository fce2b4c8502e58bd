/// Corners at which three to eight fillets of unequal radii meet, convex and concave ones mixed,
/// closed by mvs: the largest angle to the neighbours at parameters that the method does not fit,
/// poles and seconds of CPU. Prints one line for each and the share within 0.01 degrees: by hand,
/// bin/suture_corners.
#include "support/ribbon_zoo.h"
#include "support/trim_of.h"
#include "suture/fill/mvs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace suture;

struct Measured {
    double angle = 0.0;  // degrees
    double gap = 0.0;    // against the hole's diameter
};

Measured measure(const Hole& hole, const FillResult& fill) {
    const auto& surface = std::get<SplineSurface>(fill.patches.front().surface);
    Measured worst;
    const std::vector<Ribbon>& ribbons = hole.loops.front().ribbons;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        for (int k = 0; k <= 301; ++k) {
            const double t = k / 301.0;
            const double s = t * t * (3.0 - 2.0 * t);  // denser at the ends
            const RibbonPoint q = ribbons[i].at(s);
            const Eigen::Vector2d uv = test::trim_of(fill.patches.front(), 0, i)(s);
            const SurfaceJet j = evaluate(surface, uv.x(), uv.y());
            const Eigen::Vector3d n = j.u.cross(j.v).normalized();
            worst.angle = std::max(worst.angle,
                                   degrees(std::atan2(n.cross(q.normal).norm(), n.dot(q.normal))));
            worst.gap = std::max(worst.gap, (j.point - q.point).norm() / hole.diameter);
        }
    }
    return worst;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

}  // namespace

int main() {
    std::vector<double> poles;
    int within = 0;
    int count = 0;
    double slowest = 0.0;
    struct Kind {
        double slope, rise, vary;
    };
    for (const Kind& kind : {Kind{0.6, 0.0, 0.5}, Kind{0.6, 0.0, 1.0}, Kind{0.6, 0.35, 0.5}}) {
        for (int edges = 3; edges <= 8; ++edges) {
            for (const bool tight : {true, false}) {
                const auto corner = zoo::fillet_corner(edges, kind.slope, kind.rise, kind.vary);
                const Hole hole = tight ? corner.tight() : corner.setback(2.7);
                const std::clock_t start = std::clock();
                const auto fill = fill_mvs(hole, {});
                const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
                slowest = std::max(slowest, seconds);
                ++count;
                std::string text = fmt::format("{} edges, rise {}, vary {}, {}: ", edges, kind.rise,
                                               kind.vary, tight ? "tight" : "set back");
                if (fill) {
                    const auto& s = std::get<SplineSurface>(fill->patches.front().surface);
                    const Measured worst = measure(hole, *fill);
                    within += worst.angle <= 0.01 ? 1 : 0;
                    poles.push_back(static_cast<double>(s.poles.cols()));
                    text += fmt::format("{:.3g} deg, gap {:.2g}, {} x {} poles", worst.angle,
                                        worst.gap, s.count_u(), s.count_v());
                } else {
                    text += fill.error().message;
                }
                fmt::print("{}, {:.2f} s\n", text, seconds);
                std::fflush(stdout);
            }
        }
    }
    fmt::print("{} of {} within 0.01 deg, {:.0f} poles in the median, {:.2f} s at most\n", within,
               count, median(poles), slowest);
}

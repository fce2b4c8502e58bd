/// Corners at which three to eight fillets of unequal radii meet, convex and concave ones mixed,
/// closed by mvs: the largest angle to the neighbours at parameters that the method does not fit,
/// poles, what the curvature jumps by inside, and seconds of CPU. Prints one line for each and the
/// share within 0.01 degrees: by hand, suture_corners [work [first [last]]], with the share of
/// mvs's own budget (auto's is 0.3) and the rows to run, from 0 on.
#include "support/trim_of.h"
#include "suture/fill/mvs.h"

#include "bench/corner_list.h"
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
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

// Knots of multiplicity four inside: lines across which the curvature may jump.
std::vector<double> lines_of(const std::vector<double>& knots) {
    std::vector<double> lines;
    for (std::size_t k = 6; k + 9 < knots.size(); ++k) {
        if (knots[k] == knots[k + 3] && knots[k] > knots[k - 1]) {
            lines.push_back(knots[k]);
        }
    }
    return lines;
}

double distance_to(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& q : polygon) {
        least = std::min(least, (q - p).norm());
    }
    return least;
}

bool inside(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
    bool odd = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Eigen::Vector2d a = polygon[k];
        const Eigen::Vector2d b = polygon[(k + 1) % polygon.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) {
            odd = !odd;
        }
    }
    return odd;
}

// The largest jump of normal curvature across knot lines, farther than a tenth of the hole from
// its boundary, against the largest curvature of the neighbours.
double jump_inside(const Hole& hole, const FillResult& fill) {
    constexpr double kFromBoundary = 0.1;
    constexpr double kBeside = 1e-9;
    const auto& surface = std::get<SplineSurface>(fill.patches.front().surface);
    const std::vector<Ribbon>& ribbons = hole.loops.front().ribbons;
    std::vector<Eigen::Vector2d> polygon;
    double bend = 0.0;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        for (int k = 0; k < 100; ++k) {
            polygon.push_back(test::trim_of(fill.patches.front(), 0, i)(k / 100.0));
            bend = std::max(bend, ribbons[i].at(k / 100.0).curvature.norm());
        }
    }
    double worst = 0.0;
    for (const Eigen::Index axis : {0, 1}) {
        const auto& knots = axis == 0 ? surface.knots_u : surface.knots_v;
        const auto& along = axis == 0 ? surface.knots_v : surface.knots_u;
        const double width = knots.back() - knots.front();
        for (const double at : lines_of(knots)) {
            for (int k = 1; k < 400; ++k) {
                Eigen::Vector2d uv;
                uv[axis] = at;
                uv[1 - axis] = along.front() + (along.back() - along.front()) * k / 400.0;
                if (!inside(polygon, uv) ||
                    distance_to(polygon, uv) < kFromBoundary * hole.diameter) {
                    continue;
                }
                std::array<double, 2> bends{};
                for (const int side : {0, 1}) {
                    Eigen::Vector2d beside = uv;
                    beside[axis] += (side == 0 ? -kBeside : kBeside) * width;
                    const SurfaceJet j = evaluate(surface, beside.x(), beside.y());
                    const Eigen::Vector3d n = j.u.cross(j.v).normalized();
                    const Eigen::Vector3d& a = axis == 0 ? j.u : j.v;
                    const Eigen::Vector3d& t = axis == 0 ? j.v : j.u;
                    // The jump is a multiple of the square of the form that vanishes along t.
                    bends[static_cast<std::size_t>(side)] =
                        n.dot(axis == 0 ? j.uu : j.vv) * t.squaredNorm() / a.cross(t).squaredNorm();
                }
                worst = std::max(worst, std::abs(bends[0] - bends[1]) / bend);
            }
        }
    }
    return worst;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
    FillOptions options;
    options.own["work"] = {OptionKind::Number, {argc > 1 ? std::atof(argv[1]) : 0.3}, {}};
    const int first = argc > 2 ? std::atoi(argv[2]) : 0;
    const int last = argc > 3 ? std::atoi(argv[3]) : 1000;
    int row = -1;
    std::vector<double> poles;
    std::vector<double> jumps;
    int within = 0;
    int count = 0;
    double slowest = 0.0;
    for (const bench::Corner& corner : bench::corners()) {
        ++row;
        if (row < first || row > last) {
            continue;
        }
        const auto fillets = corner.fillets();
        const Hole hole = corner.tight ? fillets.tight() : fillets.setback(bench::kSetBack);
        const std::clock_t start = std::clock();
        const auto fill = fill_mvs(hole, options);
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        slowest = std::max(slowest, seconds);
        ++count;
        std::string text = corner.name() + ": ";
        if (fill) {
            const auto& s = std::get<SplineSurface>(fill->patches.front().surface);
            const Measured worst = measure(hole, *fill);
            within += worst.angle <= 0.01 ? 1 : 0;
            poles.push_back(static_cast<double>(s.poles.cols()));
            const double jump = jump_inside(hole, *fill);
            jumps.push_back(jump);
            text += fmt::format("{:.3g} deg, gap {:.2g}, {} x {} poles, jump inside {:.2g} %",
                                worst.angle, worst.gap, s.count_u(), s.count_v(), 100.0 * jump);
        } else {
            text += fill.error().message;
        }
        fmt::print("{}, {:.2f} s\n", text, seconds);
        std::fflush(stdout);
    }
    const auto seen = std::ranges::count_if(jumps, [](double jump) { return jump > 0.02; });
    fmt::print(
        "{} of {} within 0.01 deg, {:.0f} poles in the median, {} with jumps above 2 %, "
        "{:.2f} s at most\n",
        within, count, median(poles), seen, slowest);
}

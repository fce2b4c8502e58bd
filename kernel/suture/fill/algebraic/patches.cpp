#include "suture/fill/algebraic/patches.h"

#include "suture/fill/algebraic/interpolate.h"
#include "suture/fill/algebraic/jets.h"
#include "suture/fill/algebraic/sector_map.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace suture::algebraic {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kDegree = 5;
constexpr int kFewestSpans = 4;
constexpr int kMostSpans = 64;
/// The short end of a sector's square against its long one; narrower where the sheet ends early.
constexpr double kWidth = 0.25;
constexpr double kLeastWidth = 0.01;

/// A sector's patch in unit coordinates.
struct Fitted {
    SplineSurface surface;
    std::shared_ptr<const SectorMap> map;
    FitReport report;
    bool folds = false;
};

class SectorFit {
  public:
    SectorFit(const Problem& problem, const Solution& solution, int sector)
        : problem_(problem),
          solution_(solution),
          sector_(sector),
          sheet_(problem, solution, sector) {}

    [[nodiscard]] Result<Fitted> find(const Unit& unit, const Tolerance& goal,
                                      const Tolerance& limit) const {
        for (double width = kWidth; width >= kLeastWidth; width /= 5.0) {
            const auto map = std::make_shared<const SectorMap>(problem_, solution_, sector_, width);
            for (int spans = kFewestSpans; spans <= kMostSpans; spans *= 2) {
                Fitted fitted;
                fitted.map = map;
                fitted.surface = interpolate(
                    [&](double u, double v) { return point((*map)(u, v)); }, kDegree, spans);
                if (!fitted.surface.poles.allFinite()) {
                    break;
                }
                measure(fitted, unit, spans);
                const auto within = [&](const Tolerance& t) {
                    return fitted.report.distance <= t.linear && fitted.report.angle <= t.angular;
                };
                const bool last = spans * 2 > kMostSpans;
                if (within(goal) || (last && !fitted.folds && within(limit))) {
                    return fitted;
                }
                if (last) {
                    return refuse(fitted, limit);
                }
            }
        }
        return fail(ErrorCode::Refused, "the sheet of {} ends inside its sector", name());
    }

  private:
    const Problem& problem_;
    const Solution& solution_;
    int sector_;
    Sheet sheet_;

    [[nodiscard]] std::string name() const {
        const Sector& s = solution_.partition.sectors[static_cast<std::size_t>(sector_)];
        return s.side >= 0 ? fmt::format("the cell at side {}", s.side + 1)
                           : fmt::format("cell {}", s.cell + 1);
    }
    [[nodiscard]] Vector3d point(const Vector3d& b) const {
        return sheet_.at(b, sheet_.guess(b)).value_or(Vector3d::Constant(NAN));
    }
    [[nodiscard]] tl::unexpected<Error> refuse(const Fitted& fitted, const Tolerance& limit) const {
        if (fitted.folds) {
            return fail(ErrorCode::Refused, "the patch of {} folds", name());
        }
        return fail(ErrorCode::Refused,
                    "the patch of {} is {:.3g} and {:.3g} deg off its polynomial with {} spans, "
                    "more than {:.3g} and {:.3g} deg",
                    name(), fitted.report.distance, degrees(fitted.report.angle),
                    fitted.report.spans, limit.linear, degrees(limit.angular));
    }

    /// Between the sites, inside the sector.
    void measure(Fitted& fitted, const Unit& unit, int spans) const {
        const int steps = 3 * spans + 1;
        fitted.report = {0.0, 0.0, spans};
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; j <= steps; ++j) {
                const double u = static_cast<double>(i) / steps;
                const double v = static_cast<double>(j) / steps;
                const Vector3d b = (*fitted.map)(u, v);
                if (std::min(b[0], b[1]) < 0.0) {
                    continue;
                }
                const SurfaceJet jet = evaluate(fitted.surface, u, v);
                const ValueAndGradient g = evaluate(sheet_.polynomial(), jet.point);
                const Vector3d normal = jet.u.cross(jet.v);
                const double angle =
                    std::atan2(normal.cross(g.gradient).norm(), normal.dot(g.gradient));
                fitted.folds = fitted.folds || normal.dot(g.gradient) <= 0.0;
                fitted.report.distance = std::max(
                    fitted.report.distance, unit.size * std::abs(g.value) / g.gradient.norm());
                fitted.report.angle = std::max(fitted.report.angle, angle);
            }
        }
    }
};

/// The faces' common edges and vertices.
class Assembly {
  public:
    explicit Assembly(const Partition& partition) : partition_(partition) {}

    /// The wire of a sector's patch.
    std::vector<EdgeUse> wire(const Sector& sector, const std::shared_ptr<const SectorMap>& map) {
        std::vector<EdgeUse> uses;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t next = (c + 1) % 3;
            EdgeUse use;
            if (c == 0 && sector.side >= 0) {
                use.loop = 0;
                use.index = sector.side;
                use.at = [](double s) { return Vector2d(s, 0.0); };
            } else {
                use.backwards = sector.rays[c] > sector.rays[next];
                const auto from = static_cast<Eigen::Index>(use.backwards ? next : c);
                const auto to = static_cast<Eigen::Index>(use.backwards ? c : next);
                use.index = edge(sector.rays[c], sector.rays[next]);
                use.at = [map, from, to](double s) {
                    return map->inverse((1.0 - s) * Vector3d::Unit(from) + s * Vector3d::Unit(to));
                };
            }
            uses.push_back(use);
        }
        return uses;
    }

    [[nodiscard]] std::vector<InnerEdge> edges() const { return edges_; }

  private:
    const Partition& partition_;
    std::map<std::pair<int, int>, int> numbers_;
    std::vector<InnerEdge> edges_;

    [[nodiscard]] Node node(int ray) const {
        return ray < partition_.sides ? Node{0, ray} : Node{-1, ray - partition_.sides};
    }
    int edge(int a, int b) {
        const auto key = std::minmax(a, b);
        const auto [found, added] = numbers_.try_emplace(key, static_cast<int>(edges_.size()));
        if (added) {
            edges_.push_back({node(key.first), node(key.second)});
        }
        return found->second;
    }
};

}  // namespace

Result<FillResult> make_patches(const Problem& problem, const Solution& solution, const Unit& unit,
                                const Tolerance& goal, const Tolerance& limit,
                                const Progress& progress, FitReport& report) {
    FillResult result;
    const Partition& partition = solution.partition;
    Assembly assembly(partition);
    result.inner_vertices.resize(static_cast<std::size_t>(partition.rays - partition.sides));
    for (std::size_t s = 0; s < partition.sectors.size(); ++s) {
        if (progress.cancelled()) {
            return fail(ErrorCode::Cancelled, "stopped while filling");
        }
        const Sector& sector = partition.sectors[s];
        auto fitted = SectorFit(problem, solution, static_cast<int>(s)).find(unit, goal, limit);
        if (!fitted) {
            return tl::unexpected(fitted.error());
        }
        for (int c = 0; c < 3; ++c) {
            const int ray = sector.rays[static_cast<std::size_t>(c)];
            if (ray >= partition.sides) {
                const Vector2d uv = fitted->map->inverse(Vector3d::Unit(c));
                result.inner_vertices[static_cast<std::size_t>(ray - partition.sides)] =
                    unit.out(evaluate(fitted->surface, uv.x(), uv.y()).point);
            }
        }
        report.distance = std::max(report.distance, fitted->report.distance);
        report.angle = std::max(report.angle, fitted->report.angle);
        report.spans = std::max(report.spans, fitted->report.spans);
        Patch patch;
        patch.exact = false;
        patch.fit_error = fitted->report.distance;
        patch.wires = {assembly.wire(sector, fitted->map)};
        fitted->surface.poles = (unit.size * fitted->surface.poles).colwise() + unit.origin;
        patch.surface = std::move(fitted->surface);
        result.patches.push_back(std::move(patch));
    }
    result.inner_edges = assembly.edges();
    return result;
}

}  // namespace suture::algebraic

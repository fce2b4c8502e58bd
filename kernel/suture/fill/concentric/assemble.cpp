#include "suture/fill/concentric/assemble.h"

#include "suture/base/contract.h"
#include "suture/fill/concentric/sweep.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace suture::concentric {
namespace {

using Eigen::Vector2d;

/// Of an edge of the axis that one face has on both sides, OCCT's STEP reader finds out which
/// pcurve is the forward one by their distance from the domain's right border. Both are on that
/// border; so one is moved away from it: the forward one, which OCCT's writer puts second.
constexpr double kAside = 1e-12;

/// All sides as one curve on [first, first + count].
SplineCurve joined_sides(const Boundary& boundary, int first) {
    SplineCurve all;
    for (const SplineCurve& side : boundary.sides) {
        all.degree = std::max(all.degree, side.degree);
    }
    for (int i = first; i < first + boundary.count(); ++i) {
        const int turns = i / boundary.count();
        const auto& side = boundary.sides[static_cast<std::size_t>(i % boundary.count())];
        SplineCurve raised = elevated(side, all.degree);
        for (double& knot : raised.knots) {
            knot += turns * boundary.count();
        }
        if (all.knots.empty()) {
            all = raised;
            continue;
        }
        Eigen::MatrixXd poles(3, all.count() + raised.count() - 1);
        poles << all.poles, raised.poles.rightCols(raised.count() - 1);
        all.knots.pop_back();
        all.knots.insert(all.knots.end(), raised.knots.begin() + raised.degree + 1,
                         raised.knots.end());
        all.poles = std::move(poles);
    }
    return all;
}

/// The courses over a range: all on the turn that meets it.
std::vector<Course> over(const std::vector<Course>& all, double period, double from, double to) {
    std::vector<Course> found;
    for (Course course : all) {
        const double turns = std::floor((0.5 * (course.from + course.to) - from) / period) * period;
        course.from -= turns;
        course.to -= turns;
        for (const double shift : {0.0, -period}) {
            const Course part{std::max(course.from + shift, from), std::min(course.to + shift, to),
                              course.start, course.end};
            if (part.to - part.from > kSameParameter) {
                found.push_back(part);
            }
        }
    }
    std::sort(found.begin(), found.end(),
              [](const Course& a, const Course& b) { return a.from < b.from; });
    return found;
}

/// The ends of courses moved to knots of the side that they are next to, and to the range's ends.
void tidy(std::vector<Course>& courses, const std::vector<double>& knots) {
    SUTURE_EXPECTS(!courses.empty());
    for (std::size_t k = 0; k < courses.size(); ++k) {
        const auto at =
            std::lower_bound(knots.begin(), knots.end(), courses[k].from - kSameParameter);
        if (at != knots.end() && *at < courses[k].from + kSameParameter) {
            courses[k].from = *at;
        }
        if (k > 0) {
            courses[k - 1].to = courses[k].from;
        }
    }
    courses.front().from = knots.front();
    courses.back().to = knots.back();
}

/// A region's face has t as u, and as v the boundary's parameter backwards. OCCT integrates a face
/// along u at once but along v edge by edge: so its areas and volumes are exact although the face
/// is only C0 across the spokes that lead to nodes of the axis.
SplineSurface spokes_along_u(const SplineSurface& surface) {
    SplineSurface turned = transposed(surface);
    const int rows = turned.count_u();
    const int n = turned.count_v();
    const Eigen::Matrix3Xd poles = turned.poles;
    for (int j = 0; j < n; ++j) {
        turned.poles.middleCols(j * rows, rows) = poles.middleCols((n - 1 - j) * rows, rows);
    }
    std::reverse(turned.knots_v.begin(), turned.knots_v.end());
    for (double& knot : turned.knots_v) {
        knot = -knot;
    }
    return turned;
}

/// The same line in the boundary's parameter and t.
TrimCurve line(const Vector2d& from, const Vector2d& to) {
    return [=](double share) -> Vector2d {
        const Vector2d at = (1.0 - share) * from + share * to;
        return {at.y(), -at.x()};
    };
}

/// Numbers the vertices and edges that regions share.
class Assembly {
  public:
    Assembly(const std::vector<Region>& regions, const std::function<Eigen::Vector3d(int)>& vertex)
        : vertex_(vertex) {
        for (const Region& region : regions) {
            sides_ += region.count;
            seams_[region.first] = static_cast<int>(result_.inner_edges.size());
            result_.inner_edges.push_back({{0, region.first}, node(region.courses.front().start)});
        }
    }

    void add(const Region& region, const SplineSurface& surface, int last_corner) {
        std::vector<EdgeUse> wire;
        for (int side = region.first; side < region.first + region.count; ++side) {
            wire.push_back({0, side % sides_, false, line({side, 0.0}, {side + 1, 0.0}), false});
        }
        const double to = region.first + region.count;
        wire.push_back({-1, seams_.at(last_corner), false, line({to, 0.0}, {to, 1.0}), false});
        for (auto course = region.courses.rbegin(); course != region.courses.rend(); ++course) {
            if (course->start == course->end) {
                wire.back().pole_after = true;
            } else {
                wire.push_back(along_axis(*course));
            }
        }
        const double from = region.first;
        wire.push_back({-1, seams_.at(region.first), true, line({from, 0.0}, {from, 1.0}), false});
        Patch patch;
        patch.surface = spokes_along_u(surface);
        patch.wires = {std::move(wire)};
        result_.patches.push_back(std::move(patch));
    }

    [[nodiscard]] FillResult take() { return std::move(result_); }

  private:
    const std::function<Eigen::Vector3d(int)>& vertex_;
    FillResult result_;
    int sides_ = 0;             ///< of the hole
    std::map<int, int> seams_;  ///< by the corner where they start
    std::map<int, int> vertices_;
    /// An edge of the axis, and the face that walked it first.
    struct AxisEdge {
        int index = 0;
        std::size_t face = 0;
    };
    std::map<std::pair<int, int>, AxisEdge> edges_;

    Node node(int number) {
        const auto [at, is_new] =
            vertices_.try_emplace(number, static_cast<int>(result_.inner_vertices.size()));
        if (is_new) {
            result_.inner_vertices.push_back(vertex_(number));
        }
        return {-1, at->second};
    }

    /// A course is walked against its own direction: the interior lies below.
    EdgeUse along_axis(const Course& course) {
        const std::size_t face = result_.patches.size();
        const auto [at, is_new] =
            edges_.try_emplace(std::minmax(course.start, course.end),
                               AxisEdge{static_cast<int>(result_.inner_edges.size()), face});
        const auto& [index, first_face] = at->second;
        if (is_new) {
            result_.inner_edges.push_back({node(course.start), node(course.end)});
            return {-1, index, true, line({course.from, 1.0}, {course.to, 1.0}), false};
        }
        const double along = face == first_face ? 1.0 - kAside : 1.0;
        return {-1, index, false, line({course.to, along}, {course.from, along}), false};
    }
};

}  // namespace

std::vector<Region> regions_of(const Boundary& boundary, ConcentricCurve& axis,
                               std::optional<int> single) {
    std::vector<Region> regions;
    if (single) {
        regions.push_back({*single, boundary.count(), joined_sides(boundary, *single), {}});
    } else {
        for (int i = 0; i < boundary.count(); ++i) {
            regions.push_back({i, 1, boundary.sides[static_cast<std::size_t>(i)], {}});
        }
    }
    for (int i = 0; i < boundary.count(); ++i) {
        insert_node(axis, i);
    }
    const std::vector<Course> all = courses(axis);
    for (Region& region : regions) {
        region.courses = over(all, axis.period, region.first, region.first + region.count);
        tidy(region.courses, region.side.knots);
    }
    return regions;
}

void collapse_rests(SplineCurve& row, const std::vector<Course>& courses,
                    const std::function<Eigen::Vector3d(int node)>& vertex) {
    for (const Course& course : courses) {
        for (int k = 0; course.start == course.end && k < row.count(); ++k) {
            const auto first = row.knots.begin() + k + 1;
            if (*first >= course.from && *(first + row.degree - 1) <= course.to) {
                row.poles.col(k) = vertex(course.start);
            }
        }
    }
}

FillResult assemble(const std::vector<Region>& regions,
                    const std::function<SplineSurface(const Region&)>& surface,
                    const std::function<Eigen::Vector3d(int node)>& vertex) {
    Assembly assembly(regions, vertex);
    for (std::size_t k = 0; k < regions.size(); ++k) {
        assembly.add(regions[k], surface(regions[k]), regions[(k + 1) % regions.size()].first);
    }
    return assembly.take();
}

}  // namespace suture::concentric

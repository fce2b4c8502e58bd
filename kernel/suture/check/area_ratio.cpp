#include "suture/check/area_ratio.h"

#include "suture/check/surface_tree.h"
#include "suture/occ/guard.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace suture {

namespace {

constexpr int kEdgePoints = 24;
constexpr std::size_t kLoopPoints = 72;
constexpr int kRings = 10;
constexpr int kSweeps = 60;
// Points of a grid over a face, in each direction, until so many lie inside.
constexpr int kGrid = 24;
constexpr int kFinestGrid = 192;
constexpr int kFewestPoints = 400;

using Polyline = std::vector<Eigen::Vector3d>;

Eigen::Vector3d to_eigen(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}

double area_of(const TopoDS_Face& face) {
    const SurfaceTree tree(face, 0);
    const ParameterBox& box = tree.cell(0).uv;
    double area = 0.0;
    int inside = 0;
    for (int n = kGrid; n <= kFinestGrid && inside < kFewestPoints; n *= 2) {
        area = 0.0;
        inside = 0;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                const double u = box.low[0] + (i + 0.5) / n * box.size(0);
                const double v = box.low[1] + (j + 0.5) / n * box.size(1);
                if (tree.domain().contains(u, v)) {
                    const SurfacePoint point = tree.at(u, v);
                    area += point.du.cross(point.dv).norm() * box.size(0) * box.size(1) / n / n;
                    ++inside;
                }
            }
        }
    }
    return area;
}

/// The edges that one of the faces uses once, as they stand in it.
std::vector<Polyline> border_edges(const std::vector<TopoDS_Face>& faces) {
    TopTools_IndexedDataMapOfShapeListOfShape uses;
    for (const TopoDS_Face& face : faces) {
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
            const TopoDS_Shape& edge = it.Current();
            if (BRep_Tool::Degenerated(TopoDS::Edge(edge)) ||
                (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED)) {
                continue;
            }
            if (!uses.Contains(edge)) {
                uses.Add(edge, TopTools_ListOfShape());
            }
            uses.ChangeFromKey(edge).Append(edge);
        }
    }
    std::vector<Polyline> result;
    for (int i = 1; i <= uses.Extent(); ++i) {
        if (uses(i).Extent() != 1) {
            continue;
        }
        const TopoDS_Edge& edge = TopoDS::Edge(uses(i).First());
        const BRepAdaptor_Curve curve(edge);
        Polyline& points = result.emplace_back();
        for (int k = 0; k <= kEdgePoints; ++k) {
            const double s = static_cast<double>(k) / kEdgePoints;
            points.push_back(to_eigen(
                curve.Value((1.0 - s) * curve.FirstParameter() + s * curve.LastParameter())));
        }
        if (edge.Orientation() == TopAbs_REVERSED) {
            std::ranges::reverse(points);
        }
    }
    return result;
}

/// Each edge is followed by the one that starts nearest to its end.
std::vector<Polyline> loops_of(std::vector<Polyline> edges) {
    std::vector<Polyline> loops;
    while (!edges.empty()) {
        Polyline loop = std::move(edges.back());
        edges.pop_back();
        while (true) {
            const auto gap = [&](const Polyline& edge) {
                return (edge.front() - loop.back()).norm();
            };
            const auto next = std::ranges::min_element(edges, {}, gap);
            if (next == edges.end() || gap(*next) >= (loop.front() - loop.back()).norm()) {
                break;
            }
            loop.insert(loop.end(), next->begin(), next->end());
            edges.erase(next);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// So many points, evenly along a closed polyline.
Polyline resampled(const Polyline& loop) {
    std::vector<double> length = {0.0};
    for (std::size_t i = 0; i < loop.size(); ++i) {
        length.push_back(length.back() + (loop[(i + 1) % loop.size()] - loop[i]).norm());
    }
    Polyline result;
    std::size_t i = 0;
    for (std::size_t k = 0; k < kLoopPoints; ++k) {
        const double at = length.back() * static_cast<double>(k) / kLoopPoints;
        while (i + 2 < length.size() && length[i + 1] <= at) {
            ++i;
        }
        const double step = length[i + 1] - length[i];
        const double s = step > 0.0 ? (at - length[i]) / step : 0.0;
        result.push_back((1.0 - s) * loop[i] + s * loop[(i + 1) % loop.size()]);
    }
    return result;
}

double triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    return 0.5 * (b - a).cross(c - a).norm();
}

double strip(const Polyline& a, const Polyline& b) {
    double area = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const std::size_t next = (k + 1) % a.size();
        area += triangle(a[k], a[next], b[k]) + triangle(b[k], a[next], b[next]);
    }
    return area;
}

/// The rings of a fan over a loop, the loop itself first, relaxed; the last is the middle.
double fan(const Polyline& loop) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : loop) {
        middle += p / static_cast<double>(loop.size());
    }
    std::vector<Polyline> rings;
    for (int r = 0; r < kRings; ++r) {
        Polyline& ring = rings.emplace_back();
        for (const Eigen::Vector3d& p : loop) {
            ring.push_back(p + static_cast<double>(r) / kRings * (middle - p));
        }
    }
    rings.emplace_back(loop.size(), middle);
    const std::size_t count = loop.size();
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (std::size_t r = 1; r < kRings; ++r) {
            // The weights of the Laplace equation in polar coordinates, radius 1 at the loop: with
            // step h inwards, (1 +- h / (2 rho)), and (h / (rho dphi))^2 around.
            const double h = 1.0 / kRings;
            const double rho = 1.0 - static_cast<double>(r) * h;
            const double around =
                std::pow(h * static_cast<double>(count) / (2.0 * std::numbers::pi * rho), 2);
            const double outer = 1.0 + 0.5 * h / rho;
            const double inner = 1.0 - 0.5 * h / rho;
            for (std::size_t k = 0; k < count; ++k) {
                rings[r][k] =
                    (outer * rings[r - 1][k] + inner * rings[r + 1][k] +
                     around * (rings[r][(k + 1) % count] + rings[r][(k + count - 1) % count])) /
                    (outer + inner + 2.0 * around);
            }
        }
    }
    double area = 0.0;
    for (std::size_t r = 0; r < kRings; ++r) {
        area += strip(rings[r], rings[r + 1]);
    }
    return area;
}

/// Between two loops, which run opposite ways, the shortest way round.
double band(const Polyline& a, Polyline b) {
    double least = std::numeric_limits<double>::infinity();
    for (const bool turned : {false, true}) {
        if (turned) {
            std::ranges::reverse(b);
        }
        for (std::size_t k = 0; k < b.size(); ++k) {
            std::rotate(b.begin(), b.begin() + 1, b.end());
            least = std::min(least, strip(a, b));
        }
    }
    return least;
}

}  // namespace

Result<AreaRatio> measure_area_ratio(const std::vector<TopoDS_Face>& faces) {
    if (faces.empty()) {
        return fail(ErrorCode::Usage, "there are no faces to measure");
    }
    return occ::guarded("measuring the area", [&] {
        AreaRatio result;
        for (const TopoDS_Face& face : faces) {
            result.area += area_of(face);
        }
        std::vector<Polyline> loops;
        for (const Polyline& loop : loops_of(border_edges(faces))) {
            loops.push_back(resampled(loop));
        }
        result.loops = static_cast<int>(loops.size());
        double discs = 0.0;
        double bands = 0.0;
        for (std::size_t i = 0; i < loops.size(); ++i) {
            discs += fan(loops[i]);
            bands += i > 0 ? band(loops[i - 1], loops[i]) : 0.0;
        }
        result.spanning = std::max(discs, bands);
        return result;
    });
}

}  // namespace suture

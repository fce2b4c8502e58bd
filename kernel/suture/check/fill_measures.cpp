#include "suture/check/fill_measures.h"

#include "suture/check/measure_free_edge.h"
#include "suture/check/measure_support.h"
#include "suture/check/point_distance.h"
#include "suture/occ/guard.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <set>

namespace suture {
namespace {

/// The edges of a fill's new faces, each once; edges without length bound nothing.
std::set<int> edges_of_faces(const FillPlace& place, const occ::Numbering& numbering) {
    std::set<int> edges;
    for (const int face : place.faces) {
        if (face == 0) {
            continue;
        }
        for (const TopoDS_Edge& edge : occ::edges_of(numbering.faces(face))) {
            if (!BRep_Tool::Degenerated(edge)) {
                edges.insert(numbering.of(edge));
            }
        }
    }
    return edges;
}

EdgeFacts facts_of(int number, const occ::Numbering& numbering) {
    const TopoDS_Edge edge = TopoDS::Edge(numbering.edges(number));
    const BRepAdaptor_Curve curve(edge);
    const gp_Pnt middle = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
    return {number, BRep_Tool::Tolerance(edge), {middle.X(), middle.Y(), middle.Z()}};
}

/// Those of the numbers that are wanted.
std::vector<EdgeFacts> facts_of(const std::vector<int>& numbers, const std::set<int>& wanted,
                                const occ::Numbering& numbering) {
    std::vector<EdgeFacts> result;
    for (const int number : numbers) {
        if (wanted.contains(number)) {
            result.push_back(facts_of(number, numbering));
        }
    }
    return result;
}

/// The figures of a side, with angle and curvature against its support instead of its neighbour.
EdgeContinuity against_support(EdgeContinuity side, const TopoDS_Face& support,
                               const FillPlace& place, const occ::Numbering& numbering) {
    if (side.edge == 0) {
        return side;
    }
    const auto uses = find_edge_uses(numbering, {side.edge});
    for (const EdgeInFace& use : uses[static_cast<std::size_t>(side.edge - 1)]) {
        if (std::ranges::count(place.faces, use.face) == 0) {
            continue;
        }
        auto figures = occ::guarded("measuring the edge against its support", [&] {
            return measure_support(TopoDS::Edge(numbering.edges(side.edge)),
                                   TopoDS::Face(numbering.faces(use.face)), use, support);
        });
        if (figures) {
            figures->edge = side.edge;
            figures->faces = side.faces;
            figures->max_gap = side.max_gap;
            figures->edge_gap = side.edge_gap;
            figures->gap_at = side.gap_at;
            figures->gap_along = side.gap_along;
            return std::move(*figures);
        }
        side.samples = 0;
        side.note = figures.error().message;
    }
    return side;
}

FillMeasures measures_of(const FillPlace& place, const std::set<int>& own,
                         const ContinuityReport& report, const occ::Numbering& numbering) {
    FillMeasures measures;
    const auto measured = [&](int number) {
        const auto found =
            std::lower_bound(report.edges.begin(), report.edges.end(), number,
                             [](const EdgeContinuity& e, int wanted) { return e.edge < wanted; });
        const bool is_there = found != report.edges.end() && found->edge == number;
        EdgeContinuity edge = is_there ? *found : EdgeContinuity();
        edge.edge = number;
        return edge;
    };
    const auto measured_side = [&](std::size_t i) {
        const int number = place.sides[i];
        const bool free =
            std::binary_search(report.free_edges.begin(), report.free_edges.end(), number);
        EdgeContinuity side = free ? measure_free_edge(number, numbering) : measured(number);
        return place.supports.empty() || place.supports[i].IsNull()
                   ? side
                   : against_support(std::move(side), place.supports[i], place, numbering);
    };
    std::set<int> all = own;
    std::set<int> inner = own;
    for (std::size_t i = 0; i < place.sides.size(); ++i) {
        const int side = place.sides[i];
        measures.sides.push_back(measured_side(i));
        inner.erase(side);
        if (side > 0) {
            all.insert(side);
        }
    }
    measures.open_edges = facts_of(report.free_edges, all, numbering);
    measures.crowded_edges = facts_of(report.non_manifold, all, numbering);
    for (const int edge : inner) {
        // An edge between two faces; what is open is told as such.
        if (EdgeContinuity figures = measured(edge); figures.samples > 0) {
            measures.inner.push_back(std::move(figures));
        }
    }
    for (const int edge : own) {
        measures.edges.push_back(facts_of(edge, numbering));
    }
    measures.lost_faces = static_cast<int>(std::count(place.faces.begin(), place.faces.end(), 0));
    return measures;
}

/// A face lies on another one that is nearer than two fits of one surface are: so many times the
/// tolerance, but at least and at most these parts of the hole's diameter.
constexpr double kOnSurface = 10.0;
constexpr double kOnSurfaceLeast = 1e-4;
constexpr double kOnSurfaceMost = 1e-2;

/// The new faces that were found.
std::vector<int> found_faces(const FillPlace& place) {
    std::vector<int> faces = place.faces;
    std::erase(faces, 0);
    return faces;
}

/// The knot lines of all new faces, by the numbers of the shape.
Result<std::vector<KnotLine>> creases_of(const std::vector<FillPlace>& places,
                                         const occ::Numbering& numbering,
                                         const Progress& progress) {
    const BRep_Builder builder;
    TopoDS_Compound new_faces;
    builder.MakeCompound(new_faces);
    std::vector<int> numbers;
    for (const FillPlace& place : places) {
        for (const int face : place.faces) {
            if (face > 0 && std::find(numbers.begin(), numbers.end(), face) == numbers.end()) {
                builder.Add(new_faces, numbering.faces(face));
                numbers.push_back(face);
            }
        }
    }
    auto lines = measure_face_knots(new_faces, progress);
    if (lines) {
        for (KnotLine& line : *lines) {
            line.face = numbers[static_cast<std::size_t>(line.face - 1)];
        }
    }
    return lines;
}

/// What is measured of the new faces as a whole.
Result<void> measure_faces(const FillPlace& place, const occ::Numbering& numbering,
                           FillMeasures& measures) {
    std::vector<TopoDS_Face> faces;
    for (const int face : found_faces(place)) {
        faces.push_back(TopoDS::Face(numbering.faces(face)));
    }
    if (!faces.empty()) {
        auto area = measure_area_ratio(faces);
        if (!area) {
            return tl::unexpected(area.error());
        }
        measures.area = *area;
    }
    for (const ThroughPoint& wanted : place.through) {
        const PointMiss miss = measure_miss(wanted, faces);
        if (miss.distance > measures.through) {
            measures.through = miss.distance;
            measures.through_at = wanted.point;
        }
        if (miss.angle > measures.through_angle) {
            measures.through_angle = miss.angle;
            measures.through_angle_at = wanted.point;
        }
    }
    return {};
}

}  // namespace

Result<std::vector<FillMeasures>> measure_fills(const TopoDS_Shape& shape,
                                                const occ::Numbering& numbering,
                                                const std::vector<FillPlace>& places,
                                                const Profile& profile, const Progress& progress) {
    std::vector<std::set<int>> own;
    std::set<int> wanted;
    for (const FillPlace& place : places) {
        own.push_back(edges_of_faces(place, numbering));
        wanted.insert(own.back().begin(), own.back().end());
        wanted.insert(place.sides.begin(), place.sides.end());
    }
    wanted.erase(0);
    // No edges would mean all of them.
    const Result<ContinuityReport> report =
        wanted.empty()
            ? ContinuityReport()
            : measure_continuity(shape, profile, {wanted.begin(), wanted.end()}, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    const auto creases = creases_of(places, numbering, progress);
    if (!creases) {
        return tl::unexpected(creases.error());
    }
    return occ::guarded("measuring the new faces", [&]() -> Result<std::vector<FillMeasures>> {
        std::vector<FillMeasures> result;
        for (std::size_t i = 0; i < places.size(); ++i) {
            FillMeasures measures = measures_of(places[i], own[i], *report, numbering);
            auto folds = find_folds(shape, found_faces(places[i]), progress);
            if (!folds) {
                return tl::unexpected(folds.error());
            }
            measures.folds = std::move(*folds);
            for (const KnotLine& line : *creases) {
                const auto& faces = places[i].faces;
                if (std::find(faces.begin(), faces.end(), line.face) != faces.end()) {
                    measures.creases.push_back(line);
                }
            }
            if (auto done = measure_faces(places[i], numbering, measures); !done) {
                return tl::unexpected(done.error());
            }
            result.push_back(std::move(measures));
        }
        return result;
    });
}

Result<void> measure_clashes(const TopoDS_Shape& shape, const FillPlace& place, double diameter,
                             const Tolerance& tolerance, const Progress& progress,
                             FillMeasures& measures) {
    const double on_surface = std::clamp(kOnSurface * tolerance.linear, kOnSurfaceLeast * diameter,
                                         kOnSurfaceMost * diameter);
    auto report = find_clashes(shape, found_faces(place), tolerance.linear, on_surface, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    measures.clashes = std::move(report->clashes);
    measures.overlays = std::move(report->overlays);
    return {};
}

}  // namespace suture

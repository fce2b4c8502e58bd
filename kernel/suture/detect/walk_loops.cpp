#include "suture/detect/walk_loops.h"

#include "suture/base/tolerance.h"
#include "suture/detect/use_geometry.h"

#include <Eigen/Geometry>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace suture {

namespace {

TopoDS_Vertex vertex_at(const Coedge& use, bool at_start) {
    return at_start ? TopExp::FirstVertex(use.edge, Standard_True)
                    : TopExp::LastVertex(use.edge, Standard_True);
}

/// A step before the turning is known: `turning` holds the angle that the fan of faces fills.
using FanStep = LoopStep;

/// Where the faces do not lead on (an open wire), any other free edge that begins in the vertex.
UseEnd find_by_vertex(const ShellGraph& graph, const TopoDS_Vertex& vertex, int component,
                      const std::vector<bool>& visited) {
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        const Coedge& use = graph.uses[i];
        if (!use.free || visited[i] || graph.component[use.face] != component) {
            continue;
        }
        for (const bool at_start : {false, true}) {
            if (!vertex.IsNull() && vertex.IsSame(vertex_at(use, at_start))) {
                return {i, at_start};
            }
        }
    }
    return {};
}

RawLoop walk_from(const ShellGraph& graph, int start, std::vector<bool>& visited) {
    RawLoop loop;
    const int component = graph.component[graph.uses[start].face];
    // against the use, so that the material is on the right
    UseEnd leaving{start, graph.sign[graph.uses[start].face] > 0};
    while (true) {
        visited[leaving.use] = true;
        const Coedge& use = graph.uses[leaving.use];
        FanStep step{leaving.use, !leaving.at_start, vertex_at(use, leaving.at_start), kPi};
        const Fan fan = walk_fan(graph, leaving);
        UseEnd entering = fan.last;
        if (entering.use >= 0) {
            step.turning = fan.angle;
        } else {
            entering = find_by_vertex(graph, step.end, component, visited);
        }
        loop.steps.push_back(step);
        if (entering.use < 0) {
            const Coedge& first = graph.uses[start];
            loop.closed = !step.end.IsNull() &&
                          step.end.IsSame(vertex_at(first, loop.steps.front().along_use));
            return loop;
        }
        if (visited[entering.use]) {
            loop.closed = entering.use == start;
            return loop;
        }
        leaving = {entering.use, !entering.at_start};
    }
}

/// Two sides of a gap that leave a place at a smaller angle lie on each other there: a crack, whose
/// sides have vertices in the same places all along.
constexpr double kCrack = radians(1.0);

/// A part of a loop smaller than this many tolerances of the place where it begins and ends is an
/// edge too short for its tolerance.
constexpr double kSmallPart = 10.0;

/// The walk along a step: a point at each chord.
Eigen::Vector3d point_at(const ShellGraph& graph, const LoopStep& step, double t) {
    const Coedge& use = graph.uses[step.use];
    return UseGeometry(use.edge, graph.faces[use.face]).at(step.along_use ? t : 1.0 - t).point;
}

bool lie_on_each_other(const ShellGraph& graph, const LoopStep& arriving, const LoopStep& leaving) {
    constexpr double kStep = 1.0 / kChords;
    const Eigen::Vector3d back =
        point_at(graph, arriving, 1.0 - kStep) - point_at(graph, arriving, 1.0);
    const Eigen::Vector3d on = point_at(graph, leaving, kStep) - point_at(graph, leaving, 0.0);
    return std::atan2(back.cross(on).norm(), back.dot(on)) < kCrack;
}

/// Whether the steps from `first` on, as many as given, stay at the place where they begin.
bool stays(const ShellGraph& graph, const std::vector<LoopStep>& steps, std::size_t first,
           std::size_t count, double tolerance) {
    const Eigen::Vector3d place = point_at(graph, steps[first % steps.size()], 0.0);
    for (std::size_t k = 0; k < count; ++k) {
        const LoopStep& step = steps[(first + k) % steps.size()];
        for (const double t : {0.5, 1.0}) {
            if ((point_at(graph, step, t) - place).norm() > kSmallPart * tolerance) {
                return false;
            }
        }
    }
    return true;
}

/// Gaps that touch in a place where each has a vertex of its own: both vertices become one here, so
/// that the loop is cut as if the file had but one.
void unite_touching_ends(const ShellGraph& graph, RawLoop& loop) {
    std::vector<LoopStep>& steps = loop.steps;
    const std::size_t n = steps.size();
    struct Place {
        gp_Pnt point;
        double tolerance;
        std::size_t step;
    };
    std::vector<Place> places;
    for (std::size_t i = 0; i < n && loop.closed; ++i) {
        if (!steps[i].end.IsNull()) {
            places.push_back({BRep_Tool::Pnt(steps[i].end), BRep_Tool::Tolerance(steps[i].end), i});
        }
    }
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return a.point.X() < b.point.X(); });
    double widest = 0.0;
    for (const Place& place : places) {
        widest = std::max(widest, place.tolerance);
    }
    for (std::size_t a = 0; a < places.size(); ++a) {
        for (std::size_t b = a + 1; b < places.size(); ++b) {
            if (places[b].point.X() - places[a].point.X() > widest) {
                break;
            }
            const std::size_t i = std::min(places[a].step, places[b].step);
            const std::size_t j = std::max(places[a].step, places[b].step);
            const double tolerance = std::max(places[a].tolerance, places[b].tolerance);
            if (steps[i].end.IsSame(steps[j].end) ||
                places[a].point.Distance(places[b].point) > tolerance ||
                lie_on_each_other(graph, steps[j], steps[i + 1]) ||
                lie_on_each_other(graph, steps[i], steps[(j + 1) % n]) ||
                stays(graph, steps, i + 1, j - i, tolerance) ||
                stays(graph, steps, j + 1, n - (j - i), tolerance)) {
                continue;
            }
            steps[j].end = steps[i].end;
        }
    }
}

/// Cuts a loop wherever it comes back to a vertex: the parts bound different gaps.
void split_at_vertices(const RawLoop& loop, std::vector<RawLoop>& result) {
    std::vector<LoopStep> open;
    for (const LoopStep& step : loop.steps) {
        open.push_back(step);
        const auto same = [&step](const LoopStep& other) {
            return !step.end.IsNull() && other.end.IsSame(step.end);
        };
        const auto before = std::find_if(open.begin(), open.end() - 1, same);
        if (before != open.end() - 1) {
            result.push_back({{before + 1, open.end()}, true});
            open.erase(before + 1, open.end());
        }
    }
    if (!open.empty()) {
        result.push_back({std::move(open), loop.closed});
    }
}

/// Turns the angle that the faces fill into turning, for the parts of one walk. Where it passed a
/// vertex several times, the angle that the faces leave open is shared equally by the parts.
void measure_turning(std::vector<RawLoop>& loops) {
    TopTools_DataMapOfShapeInteger index_of;
    std::vector<double> filled;
    std::vector<int> fans;
    for (const RawLoop& loop : loops) {
        for (const LoopStep& step : loop.steps) {
            if (step.end.IsNull()) {
                continue;
            }
            if (!index_of.IsBound(step.end)) {
                index_of.Bind(step.end, static_cast<int>(filled.size()));
                filled.push_back(0.0);
                fans.push_back(0);
            }
            const int index = index_of.Find(step.end);
            filled[index] += step.turning;
            ++fans[index];
        }
    }
    for (RawLoop& loop : loops) {
        for (LoopStep& step : loop.steps) {
            const int index = step.end.IsNull() ? -1 : index_of.Find(step.end);
            const double open = index < 0 ? kPi : (2.0 * kPi - filled[index]) / fans[index];
            step.turning = open - kPi;
        }
    }
}

}  // namespace

std::vector<RawLoop> walk_loops(const ShellGraph& graph) {
    std::vector<RawLoop> loops;
    std::vector<bool> visited(graph.uses.size(), false);
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        if (graph.uses[i].free && !visited[i]) {
            RawLoop whole = walk_from(graph, i, visited);
            unite_touching_ends(graph, whole);
            std::vector<RawLoop> parts;
            split_at_vertices(whole, parts);
            measure_turning(parts);
            std::move(parts.begin(), parts.end(), std::back_inserter(loops));
        }
    }
    return loops;
}

}  // namespace suture

#include "suture/sew/sew_shape.h"

#include "suture/detect/seams.h"
#include "suture/detect/shell_graph.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"
#include "suture/sew/bodies.h"
#include "suture/sew/free_edges.h"
#include "suture/sew/match.h"
#include "suture/sew/rebuild.h"
#include "suture/sew/tolerance.h"
#include "suture/sew/walls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suture {

namespace {

int count_free(const ShellGraph& graph) {
    return static_cast<int>(std::count_if(graph.uses.begin(), graph.uses.end(),
                                          [](const Coedge& use) { return use.free; }));
}

/// Faces with a free edge that share none with another face.
int count_loose(const ShellGraph& graph) {
    std::vector<int> size(graph.components, 0);
    std::vector<bool> open(graph.faces.size(), false);
    for (const int component : graph.component) {
        ++size[component];
    }
    for (const Coedge& use : graph.uses) {
        open[use.face] = open[use.face] || use.free;
    }
    int loose = 0;
    for (std::size_t i = 0; i < graph.faces.size(); ++i) {
        loose += open[i] && size[graph.component[i]] == 1 ? 1 : 0;
    }
    return loose;
}

/// Edges that lie near others by their length and were not sewn to them.
std::vector<LeftOpen> left_open(const std::vector<EdgePartner>& partners, double tolerance) {
    std::vector<LeftOpen> left;
    for (const EdgePartner& edge : partners) {
        if (edge.gap > kSeamShare * edge.length) {
            continue;
        }
        const std::string reason =
            edge.gap > tolerance
                ? fmt::format("the gap is wider than {:.3g}, a quarter of the smallest feature",
                              tolerance)
            : edge.folded ? "both faces leave it to the same side: a thin wall"
                          : "no single edge or row of edges runs along it";
        left.push_back({edge.gap, edge.length, reason});
    }
    return left;
}

Result<SewnShape> sew(const TopoDS_Shape& given_shape, double given) {
    SewnShape result;
    const Walls walls = give_walls(given_shape);
    const TopoDS_Shape& shape = walls.shape;
    result.shape = shape;
    result.walls = walls.count;
    result.changed = walls.count > 0;
    const ShellGraph graph = make_shell_graph(shape);
    result.free_edges_after = count_free(graph);
    result.free_edges_before =
        walls.count > 0 ? count_free(make_shell_graph(given_shape)) : result.free_edges_after;
    result.loose_faces = count_loose(graph);
    if (result.free_edges_after == 0) {
        return result;
    }
    Places places;
    const double diagonal = occ::diagonal(shape);
    const std::vector<FreeEdge> edges =
        find_free_edges(shape, graph, kMostAccuracy * diagonal, places);
    const double floor = kLeastTolerance * diagonal;
    const double least = given > 0.0 ? std::min(given, floor) : floor;
    SewMatcher matcher(graph, edges, places);
    matcher.match_whole({least, least});
    std::vector<EdgePartner> partners = find_partners(graph, matcher.unmatched_uses());
    result.tolerance = given > 0.0 ? given : choose_tolerance(partners, floor);
    matcher.match_parts({result.tolerance, given > 0.0 ? given : floor});

    const RebuiltFaces rebuilt = rebuild_faces(graph, edges, places, matcher);
    result.left = left_open(find_partners(graph, matcher.unmatched_uses()), result.tolerance);
    if (rebuilt.pairs + rebuilt.points == 0) {
        return result;
    }
    result.changed = true;
    result.sewn_edges = rebuilt.pairs;
    result.largest_gap = rebuilt.largest_gap;
    for (std::size_t i = 0; i < graph.faces.size(); ++i) {
        if (!graph.faces[i].IsSame(rebuilt.faces[i])) {
            result.replaced.Bind(graph.faces[i], rebuilt.faces[i]);
        }
    }
    result.shape = with_new_bodies(shape, graph, rebuilt.faces, rebuilt.sewn);
    result.free_edges_after = count_free(make_shell_graph(result.shape));
    return result;
}

}  // namespace

Result<SewnShape> sew_shape(const TopoDS_Shape& shape, double tolerance) {
    if (shape.IsNull()) {
        return fail(ErrorCode::Usage, "there is no shape to sew");
    }
    if (!std::isfinite(tolerance) || tolerance < 0.0) {
        return fail(ErrorCode::Usage,
                    "the sewing tolerance must be a positive number, or 0 to choose one, not {}",
                    tolerance);
    }
    return occ::guarded("sewing", [&] { return sew(shape, tolerance); });
}

}  // namespace suture

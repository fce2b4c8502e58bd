#include "suture/edges/chain.h"

#include "suture/detect/use_geometry.h"
#include "suture/edges/chain_ends.h"
#include "suture/edges/connect.h"
#include "suture/edges/orient.h"
#include "suture/edges/supports.h"
#include "suture/edges/walk.h"
#include "suture/occ/convert.h"
#include "suture/occ/guard.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace suture {
namespace {

using Eigen::Vector3d;

/// A sheet's own border is followed across a gap where it leads out of the sheet by at least this:
/// 30 degrees off the rim that was chosen.
constexpr double kLeadsOut = 0.5;

/// The edge in its loop that a chosen edge is.
struct RimPlace {
    std::size_t loop = 0, index = 0;
};

class Chain {
  public:
    Chain(const TopoDS_Shape& shape, const occ::Numbering& numbering,
          const std::vector<BoundaryLoop>& rims, const ChosenBoundary& chosen)
        : numbering_(numbering), rims_(rims), chosen_(chosen) {
        TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, users_);
        for (std::size_t l = 0; l < rims.size(); ++l) {
            for (std::size_t i = 0; i < rims[l].edges.size(); ++i) {
                places_.emplace(rims[l].edges[i].edge_number, RimPlace{l, i});
            }
        }
    }

    Result<std::vector<BoundaryLoop>> run() {
        auto sides = chosen_sides();
        if (!sides) {
            return tl::unexpected(sides.error());
        }
        ends_ = ChainEnds(std::move(*sides), chosen_.reach,
                          [this](std::size_t a, std::size_t b) { return follows(a, b); });
        if (auto joined = ends_.join(); !joined) {
            return tl::unexpected(joined.error());
        }
        for (const auto step : {&Chain::expect_two_sides, &Chain::close}) {
            if (auto done = (this->*step)(); !done) {
                return tl::unexpected(done.error());
            }
        }
        std::vector<BoundaryLoop> loops = walk();
        std::ranges::sort(loops, {}, [](const BoundaryLoop& loop) {
            return std::pair(loop.edges.front().edge_number <= 0, loop.edges.front().edge_number);
        });
        std::ranges::stable_sort(loops, std::ranges::greater(), &BoundaryLoop::length);
        orient_free_loops(loops);
        if (auto leant = lean_on_supports(numbering_, chosen_.supports, chosen_.reach, loops);
            !leant) {
            return tl::unexpected(leant.error());
        }
        return loops;
    }

  private:
    Result<std::vector<BoundaryEdge>> chosen_sides() {
        if (chosen_.edges.empty()) {
            return fail(ErrorCode::Usage, "a boundary needs edges");
        }
        std::vector<BoundaryEdge> sides;
        std::set<int> known;
        for (const int number : chosen_.edges) {
            if (!known.insert(number).second) {
                return fail(ErrorCode::Usage, "edge {} is named twice in one boundary", number);
            }
            const auto side = side_of(number);
            if (!side) {
                return tl::unexpected(side.error());
            }
            sides.push_back(*side);
        }
        return sides;
    }

    Result<BoundaryEdge> side_of(int number) {
        if (number < 1 || number > numbering_.edges.Extent()) {
            return fail(ErrorCode::Usage, "there is no edge {}: the model has {} edges", number,
                        numbering_.edges.Extent());
        }
        if (const auto place = places_.find(number); place != places_.end()) {
            return rims_[place->second.loop].edges[place->second.index];
        }
        const TopoDS_Edge edge = TopoDS::Edge(numbering_.edges(number));
        const int user = users_.FindIndex(edge);
        if (user == 0) {
            return fail(ErrorCode::Usage, "edge {} does not belong to this part of the model",
                        number);
        }
        if (BRep_Tool::Degenerated(edge)) {
            return fail(ErrorCode::Usage, "edge {} has no length: it bounds no face", number);
        }
        std::set<int> faces;
        for (const TopoDS_Shape& face : users_(user)) {
            faces.insert(numbering_.of(TopoDS::Face(face)));
        }
        if (!faces.empty()) {
            return fail(ErrorCode::Usage, "edge {} lies {} {}: no further face can be joined there",
                        number, faces.size() == 1 ? "inside face" : "between the faces",
                        fmt::join(faces, " and "));
        }
        BoundaryEdge side;
        side.edge = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
        side.edge_number = number;
        return side;
    }

    /// A bridge stands on two chains, or on two closed loops.
    Result<void> expect_two_sides() {
        if (!chosen_.two_sides) {
            return {};
        }
        std::set<std::size_t> seen;
        for (const ChainEnd& end : ends_.loose()) {
            ends_.mark(end, seen);
        }
        std::size_t rims = 0;
        for (std::size_t i = 0; i < ends_.sides().size(); ++i) {
            rims += ends_.mark({i, false}, seen) ? 1 : 0;
        }
        const std::size_t chains = ends_.loose().size() / 2;
        if ((chains == 2 && rims == 0) || (chains == 0 && rims == 2)) {
            return {};
        }
        return fail(ErrorCode::Usage,
                    "a bridge stands on two chains of edges or on two closed rims, and these edges "
                    "form {} open and {} closed",
                    chains, rims);
    }

    [[nodiscard]] bool follows(std::size_t before, std::size_t after) const {
        const auto a = places_.find(ends_.sides()[before].edge_number);
        const auto b = places_.find(ends_.sides()[after].edge_number);
        return a != places_.end() && b != places_.end() && a->second.loop == b->second.loop &&
               (a->second.index + 1) % rims_[a->second.loop].edges.size() == b->second.index;
    }

    /// Closes what is still open by curves between the nearest ends, if that is wanted.
    Result<void> close() {
        if (ends_.loose().empty()) {
            return {};
        }
        if (!chosen_.connect) {
            return tl::unexpected(not_closed());
        }
        while (!ends_.loose().empty()) {
            const auto [a, b] = ends_.nearest_ends();
            if (auto added = add_curve(a, b); !added) {
                return added;
            }
        }
        return {};
    }

    Result<void> add_curve(const ChainEnd& a, const ChainEnd& b) {
        const TopoDS_Vertex from = ends_.vertex(a);
        const TopoDS_Vertex to = ends_.vertex(b);
        if (from.IsNull() || to.IsNull()) {
            return fail(ErrorCode::Usage, "edge {} has no end to connect",
                        ends_.sides()[from.IsNull() ? a.side : b.side].edge_number);
        }
        BoundaryEdge curve;
        curve.edge = connect_ends({from, leaving(a, ends_.point(b))},
                                  {to, leaving(b, ends_.point(a))}, chosen_.tension);
        ends_.connect(a, b, curve);
        return {};
    }

    /// The direction in which a curve leaves the end of a chosen edge for another point: out of the
    /// sheet, along the sheet's own border where that leads there; on its support; off a loose
    /// curve straight on, or, of a bridge, straight there.
    [[nodiscard]] Vector3d leaving(const ChainEnd& end, const Vector3d& there) const {
        const BoundaryEdge& side = ends_.sides()[end.side];
        const double s = end.last ? 1.0 : 0.0;
        const auto [here, tangent] = walk_to(side.edge, s);
        const Vector3d along = tangent.normalized();
        if (const auto normal = support_normal(side.edge_number, here)) {
            const Vector3d aside = normal->cross(along).normalized();
            return aside.dot(there - here) < 0.0 ? Vector3d(-aside) : aside;
        }
        if (side.face.IsNull()) {
            return chosen_.two_sides ? Vector3d((there - here).normalized())
                   : end.last        ? along
                                     : Vector3d(-along);
        }
        const UseGeometry use(TopoDS::Edge(side.edge.Reversed()), side.face);
        const Vector3d inward = use.at(1.0 - s).normal.cross(along).normalized();
        const Vector3d border = border_at(side.edge_number, end.last);
        return border.dot(inward) > kLeadsOut ? border : inward;
    }

    /// The normal of an edge's support; none where there is none.
    [[nodiscard]] std::optional<Vector3d> support_normal(int edge, const Vector3d& point) const {
        const auto support = chosen_.supports.find(edge);
        if (support == chosen_.supports.end() || support->second > numbering_.faces.Extent()) {
            return std::nullopt;  // lean_on_supports says so
        }
        const TopoDS_Face face = TopoDS::Face(numbering_.faces(support->second));
        return foot_of(point, BRep_Tool::Surface(face)).normal;
    }

    /// Where the next edge of the rim would go on beyond the corner.
    [[nodiscard]] Vector3d border_at(int number, bool last) const {
        const RimPlace place = places_.at(number);
        const std::vector<BoundaryEdge>& edges = rims_[place.loop].edges;
        const std::size_t n = edges.size();
        return last ? Vector3d(-walk_to(edges[(place.index + 1) % n].edge, 0.0).second.normalized())
                    : walk_to(edges[(place.index + n - 1) % n].edge, 1.0).second.normalized();
    }

    [[nodiscard]] Error not_closed() const {
        std::set<std::size_t> open;
        for (const ChainEnd& end : ends_.loose()) {
            ends_.mark(end, open);
        }
        std::set<int> left;
        for (const std::size_t side : open) {
            left.insert(ends_.sides()[side].edge_number);
        }
        const auto [a, b] = ends_.nearest_ends();
        return {
            ErrorCode::Usage,
            fmt::format("{} {} {} no closed chain: between the ends at {} and {} is a gap of "
                        "{:.4g}, wider than the {:.3g} that closes by itself; --connect "
                        "bridges it",
                        left.size() == 1 ? "edge" : "the edges", fmt::join(left, ", "),
                        left.size() == 1 ? "forms" : "form", ends_.place_of(a), ends_.place_of(b),
                        (ends_.point(a) - ends_.point(b)).norm(), chosen_.reach)};
    }

    /// The closed loops, each from its edge of the smallest number on, as its faces want it.
    [[nodiscard]] std::vector<BoundaryLoop> walk() const {
        const std::vector<BoundaryEdge>& sides = ends_.sides();
        std::vector<BoundaryLoop> loops;
        std::vector<bool> done(sides.size(), false);
        std::vector<std::size_t> order(sides.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        // The largest shell says which way round: smaller sheets are turned over to it.
        std::ranges::sort(order, {}, [&](std::size_t i) {
            const auto place = places_.find(sides[i].edge_number);
            const int faces = place == places_.end() ? 0 : rims_[place->second.loop].shell_faces;
            return std::pair(-faces, sides[i].edge_number);
        });
        for (const std::size_t start : order) {
            BoundaryLoop loop;
            ChainEnd end{start, true};
            while (!done[end.side]) {
                done[end.side] = true;
                loop.edges.push_back(end.last ? sides[end.side] : turned(sides[end.side]));
                end = ends_.mate_of(end).other();
            }
            if (!loop.edges.empty()) {
                begin_at_smallest(loop);
                loops.push_back(measured(std::move(loop), static_cast<int>(loops.size())));
            }
        }
        return loops;
    }

    [[nodiscard]] BoundaryLoop measured(BoundaryLoop loop, int index) const {
        loop.id = static_cast<int>(rims_.size()) + 1 + index;
        const auto rim = places_.find(loop.edges.front().edge_number);
        if (rim != places_.end() && is_whole(loop, rim->second.loop)) {
            std::vector<BoundaryEdge> edges = std::move(loop.edges);
            loop = rims_[rim->second.loop];
            loop.edges = std::move(edges);
        } else {
            measure_size(loop);
        }
        loop.kind = LoopKind::Hole;
        loop.reason = "its edges were chosen";
        loop.corner_reach = chosen_.reach;
        return loop;
    }

    [[nodiscard]] bool is_whole(const BoundaryLoop& loop, std::size_t rim) const {
        return loop.edges.size() == rims_[rim].edges.size() &&
               std::ranges::all_of(loop.edges, [&](const BoundaryEdge& side) {
                   const auto place = places_.find(side.edge_number);
                   return place != places_.end() && place->second.loop == rim;
               });
    }

    const occ::Numbering& numbering_;
    const std::vector<BoundaryLoop>& rims_;
    const ChosenBoundary& chosen_;
    TopTools_IndexedDataMapOfShapeListOfShape users_;
    std::map<int, RimPlace> places_;  ///< by edge number
    ChainEnds ends_;
};

}  // namespace

Result<std::vector<BoundaryLoop>> chain_edges(const TopoDS_Shape& shape,
                                              const occ::Numbering& numbering,
                                              const std::vector<BoundaryLoop>& rims,
                                              const ChosenBoundary& chosen) {
    return occ::guarded("chaining the chosen edges",
                        [&] { return Chain(shape, numbering, rims, chosen).run(); });
}

}  // namespace suture

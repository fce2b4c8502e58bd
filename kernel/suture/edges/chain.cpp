#include "suture/edges/chain.h"

#include "suture/base/contract.h"
#include "suture/detect/use_geometry.h"
#include "suture/edges/connect.h"
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

/// One of the two ends of a chosen edge, as the edge stands in `Chain::sides`.
struct ChainEnd {
    std::size_t side = 0;
    bool last = false;
    auto operator<=>(const ChainEnd&) const = default;
    [[nodiscard]] ChainEnd other() const { return {side, !last}; }
};

/// The edge in its loop that a chosen edge is.
struct RimPlace {
    std::size_t loop = 0, index = 0;
};

bool has_face(const BoundaryLoop& loop) {
    return std::ranges::any_of(loop.edges,
                               [](const BoundaryEdge& side) { return !side.face.IsNull(); });
}

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
        for (const auto step :
             {&Chain::take_sides, &Chain::join_ends, &Chain::expect_two_sides, &Chain::close}) {
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
        return loops;
    }

  private:
    Result<void> take_sides() {
        if (chosen_.edges.empty()) {
            return fail(ErrorCode::Usage, "a boundary needs edges");
        }
        std::set<int> known;
        for (const int number : chosen_.edges) {
            if (!known.insert(number).second) {
                return fail(ErrorCode::Usage, "edge {} is named twice in one boundary", number);
            }
            const auto side = side_of(number);
            if (!side) {
                return tl::unexpected(side.error());
            }
            sides_.push_back(*side);
        }
        return {};
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

    [[nodiscard]] TopoDS_Vertex vertex(const ChainEnd& end) const {
        const TopoDS_Edge& edge = sides_[end.side].edge;
        return end.last ? TopExp::LastVertex(edge, Standard_True)
                        : TopExp::FirstVertex(edge, Standard_True);
    }

    [[nodiscard]] Vector3d point(const ChainEnd& end) const {
        return walk_to(sides_[end.side].edge, end.last ? 1.0 : 0.0).first;
    }

    [[nodiscard]] bool touch(const ChainEnd& a, const ChainEnd& b) const {
        const TopoDS_Vertex one = vertex(a);
        const TopoDS_Vertex two = vertex(b);
        if (!one.IsNull() && !two.IsNull()) {
            const double own = std::max(BRep_Tool::Tolerance(one), BRep_Tool::Tolerance(two));
            return one.IsSame(two) || (point(a) - point(b)).norm() <= std::max(own, chosen_.reach);
        }
        return (point(a) - point(b)).norm() <= chosen_.reach;
    }

    /// Ends that touch, in groups; ends of closed edges are each other's.
    Result<void> join_ends() {
        std::vector<ChainEnd> ends;
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            const ChainEnd first{i, false};
            const ChainEnd last{i, true};
            if (vertex(first).IsNull() || vertex(first).IsSame(vertex(last))) {
                mate(first, last);
                continue;
            }
            ends.push_back(first);
            ends.push_back(last);
        }
        while (!ends.empty()) {
            std::vector<ChainEnd> group = {ends.back()};
            ends.pop_back();
            for (std::size_t k = 0; k < group.size(); ++k) {
                const auto near = std::stable_partition(
                    ends.begin(), ends.end(),
                    [&](const ChainEnd& end) { return !touch(end, group[k]); });
                group.insert(group.end(), near, ends.end());
                ends.erase(near, ends.end());
            }
            if (auto joined = join_group(std::move(group)); !joined) {
                return joined;
            }
        }
        return {};
    }

    /// A bridge stands on two chains, or on two closed loops.
    Result<void> expect_two_sides() {
        if (!chosen_.two_sides) {
            return {};
        }
        std::set<std::size_t> seen;
        for (const ChainEnd& end : loose_) {
            mark(end, seen);
        }
        std::size_t rims = 0;
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            rims += mark({i, false}, seen) ? 1 : 0;
        }
        const std::size_t chains = loose_.size() / 2;
        if ((chains == 2 && rims == 0) || (chains == 0 && rims == 2)) {
            return {};
        }
        return fail(ErrorCode::Usage,
                    "a bridge stands on two chains of edges or on two closed rims, and these edges "
                    "form {} open and {} closed",
                    chains, rims);
    }

    /// Marks all edges of a chain from one of its ends on, of a closed one from anywhere.
    ///
    /// Result  whether any was new.
    bool mark(ChainEnd end, std::set<std::size_t>& seen) const {
        bool any = false;
        while (seen.insert(end.side).second) {
            any = true;
            const auto next = mates_.find(end.other());
            if (next == mates_.end()) {
                break;
            }
            end = next->second;
        }
        return any;
    }

    Result<void> join_group(std::vector<ChainEnd> group) {
        std::ranges::sort(group);
        if (group.size() > 2) {
            follow_rims(group);
        }
        if (group.size() == 1) {
            loose_.push_back(group.front());
        } else if (group.size() == 2) {
            mate(group[0], group[1]);
        } else if (!group.empty()) {
            std::vector<int> numbers;
            for (const ChainEnd& end : group) {
                numbers.push_back(sides_[end.side].edge_number);
            }
            return fail(ErrorCode::Usage,
                        "the edges {} all meet in {}: a border passes a point once",
                        fmt::join(numbers, ", "), place_of(group.front()));
        }
        return {};
    }

    /// Where loops touch in a point, each goes on as the shell's own rim does.
    void follow_rims(std::vector<ChainEnd>& group) {
        for (std::size_t a = 0; a < group.size(); ++a) {
            for (std::size_t b = 0; b < group.size(); ++b) {
                if (group[a].last && !group[b].last && follows(group[a].side, group[b].side)) {
                    mate(group[a], group[b]);
                    const ChainEnd one = group[a];
                    const ChainEnd two = group[b];
                    std::erase_if(group, [&](const ChainEnd& e) { return e == one || e == two; });
                    a = static_cast<std::size_t>(-1);
                    break;
                }
            }
        }
    }

    [[nodiscard]] bool follows(std::size_t before, std::size_t after) const {
        const auto a = places_.find(sides_[before].edge_number);
        const auto b = places_.find(sides_[after].edge_number);
        return a != places_.end() && b != places_.end() && a->second.loop == b->second.loop &&
               (a->second.index + 1) % rims_[a->second.loop].edges.size() == b->second.index;
    }

    void mate(const ChainEnd& a, const ChainEnd& b) {
        mates_[a] = b;
        mates_[b] = a;
    }

    [[nodiscard]] std::string place_of(const ChainEnd& end) const {
        const Vector3d p = point(end);
        return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
    }

    /// Closes what is still open by curves between the nearest ends, if that is wanted.
    Result<void> close() {
        if (loose_.empty()) {
            return {};
        }
        if (!chosen_.connect) {
            return tl::unexpected(not_closed());
        }
        while (!loose_.empty()) {
            const auto [a, b] = nearest_ends();
            if (auto added = add_curve(a, b); !added) {
                return added;
            }
            std::erase_if(loose_, [&](const ChainEnd& e) { return e == a || e == b; });
        }
        return {};
    }

    /// The other end of the open chain that ends here.
    [[nodiscard]] ChainEnd far_end(ChainEnd end) const {
        for (;;) {
            end = end.other();
            const auto next = mates_.find(end);
            if (next == mates_.end()) {
                return end;
            }
            end = next->second;
        }
    }

    /// The two ends of different chains whose connection leaves the least to bridge; of one chain
    /// its own ends.
    [[nodiscard]] std::pair<ChainEnd, ChainEnd> nearest_ends() const {
        std::pair<ChainEnd, ChainEnd> best(loose_.front(), far_end(loose_.front()));
        double least = INFINITY;
        for (const ChainEnd& a : loose_) {
            for (const ChainEnd& b : loose_) {
                if (!(a < b) || (b == far_end(a) && loose_.size() > 2)) {
                    continue;
                }
                double apart = (point(a) - point(b)).norm();
                if (loose_.size() == 4) {  // two chains: both gaps at once, so that none crosses
                    apart += (point(far_end(a)) - point(far_end(b))).norm();
                }
                if (apart < least) {
                    least = apart;
                    best = {a, b};
                }
            }
        }
        return best;
    }

    Result<void> add_curve(const ChainEnd& a, const ChainEnd& b) {
        if (vertex(a).IsNull() || vertex(b).IsNull()) {
            return fail(ErrorCode::Usage, "edge {} has no end to connect",
                        sides_[vertex(a).IsNull() ? a.side : b.side].edge_number);
        }
        BoundaryEdge curve;
        curve.edge =
            connect_ends({vertex(a), leaving(a)}, {vertex(b), leaving(b)}, chosen_.tension);
        sides_.push_back(curve);
        mate(a, {sides_.size() - 1, false});
        mate(b, {sides_.size() - 1, true});
        return {};
    }

    /// The direction in which a curve leaves the end of a chosen edge: out of the sheet, along the
    /// sheet's own border where that leads there; off a loose curve, straight on.
    [[nodiscard]] Vector3d leaving(const ChainEnd& end) const {
        const BoundaryEdge& side = sides_[end.side];
        const double s = end.last ? 1.0 : 0.0;
        const Vector3d along = walk_to(side.edge, s).second.normalized();
        if (side.face.IsNull()) {
            return end.last ? along : Vector3d(-along);
        }
        const UseGeometry use(TopoDS::Edge(side.edge.Reversed()), side.face);
        const Vector3d inward = use.at(1.0 - s).normal.cross(along).normalized();
        const Vector3d border = border_at(side.edge_number, end.last);
        return border.dot(inward) > kLeadsOut ? border : inward;
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
        std::set<int> left;
        for (const ChainEnd& end : loose_) {
            for (ChainEnd at = end;;) {
                left.insert(sides_[at.side].edge_number);
                const auto next = mates_.find(at.other());
                if (next == mates_.end()) {
                    break;
                }
                at = next->second;
            }
        }
        const auto [a, b] = nearest_ends();
        return {ErrorCode::Usage,
                fmt::format("{} {} {} no closed chain: between the ends at {} and {} is a gap of "
                            "{:.4g}, wider than the {:.3g} that closes by itself; --connect "
                            "bridges it",
                            left.size() == 1 ? "edge" : "the edges", fmt::join(left, ", "),
                            left.size() == 1 ? "forms" : "form", place_of(a), place_of(b),
                            (point(a) - point(b)).norm(), chosen_.reach)};
    }

    /// The closed loops, each from its edge of the smallest number on, as its faces want it.
    [[nodiscard]] std::vector<BoundaryLoop> walk() const {
        std::vector<BoundaryLoop> loops;
        std::vector<bool> done(sides_.size(), false);
        std::vector<std::size_t> order(sides_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        // The largest shell says which way round: smaller sheets are turned over to it.
        std::ranges::sort(order, {}, [&](std::size_t i) {
            const auto place = places_.find(sides_[i].edge_number);
            const int faces = place == places_.end() ? 0 : rims_[place->second.loop].shell_faces;
            return std::pair(-faces, sides_[i].edge_number);
        });
        for (const std::size_t start : order) {
            BoundaryLoop loop;
            ChainEnd end{start, true};
            while (!done[end.side]) {
                done[end.side] = true;
                loop.edges.push_back(end.last ? sides_[end.side] : turned(sides_[end.side]));
                end = mates_.at(end).other();
            }
            if (!loop.edges.empty()) {
                begin_at_smallest(loop);
                loops.push_back(measured(std::move(loop), static_cast<int>(loops.size())));
            }
        }
        return loops;
    }

    static void begin_at_smallest(BoundaryLoop& loop) {
        std::ranges::rotate(loop.edges,
                            std::ranges::min_element(loop.edges, {}, [](const BoundaryEdge& side) {
                                return std::pair(side.edge_number == 0, side.edge_number);
                            }));
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

    /// Loops without any face are walked as the others want it: islands against the outer one.
    static void orient_free_loops(std::vector<BoundaryLoop>& loops) {
        const auto faced = std::ranges::find_if(loops, has_face);
        const std::size_t reference =
            faced == loops.end() ? 0 : static_cast<std::size_t>(faced - loops.begin());
        const Vector3d area = area_of(loops[reference]);
        for (std::size_t i = 0; i < loops.size(); ++i) {
            const bool both_islands = i > 0 && reference > 0;
            const double agree = area_of(loops[i]).dot(area);
            if (i == reference || has_face(loops[i]) || agree * (both_islands ? 1 : -1) >= 0.0) {
                continue;
            }
            std::ranges::reverse(loops[i].edges);
            for (BoundaryEdge& side : loops[i].edges) {
                side = turned(side);
            }
            begin_at_smallest(loops[i]);
        }
    }

    const occ::Numbering& numbering_;
    const std::vector<BoundaryLoop>& rims_;
    const ChosenBoundary& chosen_;
    TopTools_IndexedDataMapOfShapeListOfShape users_;
    std::map<int, RimPlace> places_;  ///< by edge number
    std::vector<BoundaryEdge> sides_;
    std::map<ChainEnd, ChainEnd> mates_;
    std::vector<ChainEnd> loose_;
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

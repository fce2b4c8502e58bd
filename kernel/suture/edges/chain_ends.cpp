#include "suture/edges/chain_ends.h"

#include "suture/edges/walk.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>

#include <algorithm>
#include <cmath>

namespace suture {

TopoDS_Vertex ChainEnds::vertex(const ChainEnd& end) const {
    const TopoDS_Edge& edge = sides_[end.side].edge;
    return end.last ? TopExp::LastVertex(edge, Standard_True)
                    : TopExp::FirstVertex(edge, Standard_True);
}

Eigen::Vector3d ChainEnds::point(const ChainEnd& end) const {
    return walk_to(sides_[end.side].edge, end.last ? 1.0 : 0.0).first;
}

bool ChainEnds::touch(const ChainEnd& a, const ChainEnd& b) const {
    const TopoDS_Vertex one = vertex(a);
    const TopoDS_Vertex two = vertex(b);
    if (!one.IsNull() && !two.IsNull()) {
        const double own = std::max(BRep_Tool::Tolerance(one), BRep_Tool::Tolerance(two));
        return one.IsSame(two) || (point(a) - point(b)).norm() <= std::max(own, reach_);
    }
    return (point(a) - point(b)).norm() <= reach_;
}

Result<void> ChainEnds::join() {
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
            const auto near =
                std::stable_partition(ends.begin(), ends.end(),
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

bool ChainEnds::mark(ChainEnd end, std::set<std::size_t>& seen) const {
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

Result<void> ChainEnds::join_group(std::vector<ChainEnd> group) {
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
        return fail(ErrorCode::Usage, "the edges {} all meet in {}: a border passes a point once",
                    fmt::join(numbers, ", "), place_of(group.front()));
    }
    return {};
}

void ChainEnds::follow_rims(std::vector<ChainEnd>& group) {
    for (std::size_t a = 0; a < group.size(); ++a) {
        for (std::size_t b = 0; b < group.size(); ++b) {
            if (group[a].last && !group[b].last && follows_(group[a].side, group[b].side)) {
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

void ChainEnds::mate(const ChainEnd& a, const ChainEnd& b) {
    mates_[a] = b;
    mates_[b] = a;
}

std::string ChainEnds::place_of(const ChainEnd& end) const {
    const Eigen::Vector3d p = point(end);
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

ChainEnd ChainEnds::far_end(ChainEnd end) const {
    for (;;) {
        end = end.other();
        const auto next = mates_.find(end);
        if (next == mates_.end()) {
            return end;
        }
        end = next->second;
    }
}

std::pair<ChainEnd, ChainEnd> ChainEnds::nearest_ends() const {
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

void ChainEnds::connect(const ChainEnd& a, const ChainEnd& b, const BoundaryEdge& curve) {
    sides_.push_back(curve);
    mate(a, {sides_.size() - 1, false});
    mate(b, {sides_.size() - 1, true});
    std::erase_if(loose_, [&](const ChainEnd& end) { return end == a || end == b; });
}

}  // namespace suture

#include "suture/check/face_domain.h"

#include "suture/occ/handle.h"

#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace suture {

namespace {

// Pieces of a loop for each polynomial piece of a pcurve, and for a whole pcurve.
constexpr int kPiecesEach = 8;
constexpr int kFewestPieces = 32;
constexpr int kMostPieces = 256;
// A polyline's middles are off by the curve's deviation but for terms of higher order.
constexpr double kSafety = 1.5;
// Ends of pcurves that are farther from each other than this part of the loops' box are no corner.
constexpr double kCorner = 1e-2;

std::array<double, 2> to_array(const gp_Pnt2d& p) {
    return {p.X(), p.Y()};
}

double distance(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// The segment passes the box widened by `by`: separating axes of both and of the segment.
bool passes(const std::array<double, 2>& a, const std::array<double, 2>& b, double by,
            const ParameterBox& box) {
    for (const std::size_t k : {0U, 1U}) {
        if (std::min(a.at(k), b.at(k)) > box.high.at(k) + by ||
            std::max(a.at(k), b.at(k)) < box.low.at(k) - by) {
            return false;
        }
    }
    const double nx = a[1] - b[1];
    const double ny = b[0] - a[0];
    const double reach =
        std::abs(nx) * (0.5 * box.size(0) + by) + std::abs(ny) * (0.5 * box.size(1) + by);
    return std::abs(nx * (box.middle(0) - a[0]) + ny * (box.middle(1) - a[1])) <= reach;
}

}  // namespace

bool ParameterBox::meets(const ParameterBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1];
}

bool ParameterBox::holds(const ParameterBox& other) const {
    constexpr double kRounding = 1e-9;
    const auto within = [&](std::size_t k) {
        const double margin = kRounding * size(k);
        return other.low.at(k) >= low.at(k) - margin && other.high.at(k) <= high.at(k) + margin;
    };
    return within(0) && within(1);
}

FaceDomain::FaceDomain(const TopoDS_Face& face) {
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer wires(forward, TopAbs_WIRE); wires.More(); wires.Next()) {
        std::vector<std::vector<Piece>> edges;
        for (TopExp_Explorer it(wires.Current(), TopAbs_EDGE); it.More(); it.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
            if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) {
                continue;
            }
            double first = 0.0;
            double last = 0.0;
            const auto curve = BRep_Tool::CurveOnSurface(edge, forward, first, last);
            if (curve.IsNull()) {
                closed_ = false;
                continue;
            }
            const Geom2dAdaptor_Curve pcurve(curve, first, last);
            const bool straight = pcurve.GetType() == GeomAbs_Line;
            const int count = straight ? 1
                                       : std::clamp(kPiecesEach * pcurve.NbIntervals(GeomAbs_CN),
                                                    kFewestPieces, kMostPieces);
            std::vector<Piece>& pieces = edges.emplace_back();
            for (int i = 0; i < count; ++i) {
                const double t = first + (last - first) * i / count;
                const double next = first + (last - first) * (i + 1) / count;
                Piece piece{to_array(pcurve.Value(t)), to_array(pcurve.Value(next)), 0.0};
                if (!straight) {
                    const auto middle = to_array(pcurve.Value(0.5 * (t + next)));
                    piece.deviation =
                        kSafety * distance(middle, {0.5 * (piece.from[0] + piece.to[0]),
                                                    0.5 * (piece.from[1] + piece.to[1])});
                }
                pieces.push_back(piece);
            }
            if (edge.Orientation() == TopAbs_REVERSED) {
                std::ranges::reverse(pieces);
                for (Piece& piece : pieces) {
                    std::swap(piece.from, piece.to);
                }
            }
        }
        add_loop(std::move(edges));
    }
    set_bounds(forward);
}

/// Edges of a wire stand in any order: each end is joined to the nearest start.
void FaceDomain::add_loop(std::vector<std::vector<Piece>> edges) {
    std::erase_if(edges, [](const auto& pieces) { return pieces.empty(); });
    std::vector<char> taken(edges.size(), 0);
    double widest = 0.0;
    double reach = 0.0;
    for (const auto& pieces : edges) {
        const auto& end = pieces.back().to;
        std::size_t nearest = edges.size();
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const double gap = distance(end, edges[k].front().from);
            if (!taken[k] && gap < smallest) {
                smallest = gap;
                nearest = k;
            }
        }
        taken[nearest] = 1;
        widest = std::max(widest, smallest);
        for (const Piece& piece : pieces) {
            reach = std::max(reach, distance(piece.from, edges.front().front().from));
            pieces_.push_back(piece);
        }
        if (smallest > 0.0) {
            pieces_.push_back({end, edges[nearest].front().from, 0.0});
        }
    }
    closed_ = closed_ && widest <= kCorner * reach;
}

void FaceDomain::set_bounds(const TopoDS_Face& face) {
    TopLoc_Location location;
    const occ::Handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
    if (!surface.IsNull()) {
        periods_ = {surface->IsUPeriodic() ? surface->UPeriod() : 0.0,
                    surface->IsVPeriodic() ? surface->VPeriod() : 0.0};
        surface->Bounds(box_.low[0], box_.high[0], box_.low[1], box_.high[1]);
    }
    if (pieces_.empty()) {
        area_ = box_.size(0) * box_.size(1);
        return;
    }
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    box_ = {{kInfinite, kInfinite}, {-kInfinite, -kInfinite}};
    for (const Piece& piece : pieces_) {
        for (const std::size_t k : {0U, 1U}) {
            box_.low.at(k) = std::min({box_.low.at(k), piece.from.at(k) - piece.deviation,
                                       piece.to.at(k) - piece.deviation});
            box_.high.at(k) = std::max({box_.high.at(k), piece.from.at(k) + piece.deviation,
                                        piece.to.at(k) + piece.deviation});
        }
    }
    for (const Piece& piece : pieces_) {
        // Counted from the box's corner: the loops may lie far from the origin.
        area_ += 0.5 * ((piece.from[0] - box_.low[0]) * (piece.to[1] - box_.low[1]) -
                        (piece.to[0] - box_.low[0]) * (piece.from[1] - box_.low[1]));
    }
}

std::vector<int> FaceDomain::all_pieces() const {
    std::vector<int> all(pieces_.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

FaceDomain::Part FaceDomain::classify(const ParameterBox& box, std::vector<int>& near) const {
    std::erase_if(near, [&](int i) {
        const Piece& piece = pieces_[static_cast<std::size_t>(i)];
        return !passes(piece.from, piece.to, piece.deviation, box);
    });
    if (!near.empty() || !closed_) {
        return Part::Border;
    }
    return contains(box.middle(0), box.middle(1)) ? Part::Inside : Part::Outside;
}

bool FaceDomain::contains(double u, double v) const {
    if (pieces_.empty() || !closed_) {
        return u >= box_.low[0] && u <= box_.high[0] && v >= box_.low[1] && v <= box_.high[1];
    }
    bool inside = false;
    for (const Piece& piece : pieces_) {
        if ((piece.from[1] > v) != (piece.to[1] > v)) {
            const double t = (v - piece.from[1]) / (piece.to[1] - piece.from[1]);
            inside ^= piece.from[0] + t * (piece.to[0] - piece.from[0]) > u;
        }
    }
    return inside;
}

std::array<double, 2> FaceDomain::in_period(double u, double v) const {
    std::array<double, 2> result = {u, v};
    for (const std::size_t k : {0U, 1U}) {
        if (periods_.at(k) > 0.0) {
            const double middle = box_.middle(k);
            result.at(k) -= periods_.at(k) * std::round((result.at(k) - middle) / periods_.at(k));
        }
    }
    return result;
}

}  // namespace suture

#include "suture/detect/edge_field.h"

#include "suture/occ/convert.h"

#include <BRepAdaptor_Curve.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace suture {

namespace {

/// Chords an edge is cut into. Their boxes are grown by twice the sag seen at the middle.
constexpr int kPieces = 32;

/// Newton's method from the middle of a chord whose arc is 1/32 of an edge converges in two or
/// three steps; the rest is for edges with uneven parameters.
constexpr int kNewtonSteps = 8;

/// Pieces in a leaf of the tree of boxes.
constexpr int kLeaf = 8;

struct Box {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
    Eigen::Vector3d high = -low;

    void add(const Box& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    [[nodiscard]] double distance(const Eigen::Vector3d& point) const {
        return (low - point).cwiseMax(point - high).cwiseMax(0.0).norm();
    }
};

}  // namespace

/// A tree of boxes over the pieces: node i spans order[begin, end) and has children 2i+1, 2i+2.
struct EdgeField::Index {
    struct Node {
        Box box;
        int begin = 0;
        int end = 0;
    };
    std::vector<BRepAdaptor_Curve> curves;
    std::vector<double> lengths;
    std::vector<Box> boxes;  // of each piece
    std::vector<int> order;
    std::vector<Node> nodes;

    [[nodiscard]] double parameter(int edge, double t) const {
        const BRepAdaptor_Curve& curve = curves[edge];
        return curve.FirstParameter() + t * (curve.LastParameter() - curve.FirstParameter());
    }

    void build(int node, int begin, int end) {
        if (node >= static_cast<int>(nodes.size())) {
            nodes.resize(node + 1);
        }
        Box box;
        for (int i = begin; i < end; ++i) {
            box.add(boxes[order[i]]);
        }
        nodes[node] = {box, begin, end};
        if (end - begin <= kLeaf) {
            return;
        }
        Eigen::Index axis = 0;
        (box.high - box.low).maxCoeff(&axis);
        const int middle = (begin + end) / 2;
        std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                         [this, axis](int a, int b) {
                             return boxes[a].low[axis] + boxes[a].high[axis] <
                                    boxes[b].low[axis] + boxes[b].high[axis];
                         });
        build(2 * node + 1, begin, middle);
        build(2 * node + 2, middle, end);
    }

    [[nodiscard]] NearPoint on_piece(const Eigen::Vector3d& point, int piece) const {
        const int edge = piece / kPieces;
        const BRepAdaptor_Curve& curve = curves[edge];
        const double step = (curve.LastParameter() - curve.FirstParameter()) / kPieces;
        NearPoint best{edge, std::numeric_limits<double>::max(), 0.0};
        double s = parameter(edge, (piece % kPieces + 0.5) / kPieces);
        for (int i = 0; i < kNewtonSteps; ++i) {
            gp_Pnt p;
            gp_Vec d1;
            gp_Vec d2;
            curve.D2(s, p, d1, d2);
            const Eigen::Vector3d away = occ::from_occ(p) - point;
            if (away.norm() < best.distance) {
                best = {edge, away.norm(), s};
            }
            const double slope = away.dot(occ::from_occ(d1));
            const double full = d1.SquareMagnitude() + away.dot(occ::from_occ(d2));
            // the step of steepest descent where the distance is not convex
            const double bend = full > 0.0 ? full : d1.SquareMagnitude();
            if (bend <= 0.0) {
                break;
            }
            const double before = s;
            s += std::clamp(-slope / bend, -step, step);
            s = std::clamp(s, curve.FirstParameter(), curve.LastParameter());
            if (std::abs(s - before) <= 1e-12 * std::abs(step)) {
                break;
            }
        }
        return best;
    }

    void search(int node, const Eigen::Vector3d& point, const std::function<bool(int)>& wanted,
                NearPoint& best) const {
        const Node& here = nodes[node];
        if (here.end - here.begin > kLeaf) {
            int first = 2 * node + 1;
            int second = 2 * node + 2;
            if (nodes[second].box.distance(point) < nodes[first].box.distance(point)) {
                std::swap(first, second);
            }
            for (const int child : {first, second}) {
                if (nodes[child].box.distance(point) <= best.distance) {
                    search(child, point, wanted, best);
                }
            }
            return;
        }
        for (int i = here.begin; i < here.end; ++i) {
            const int piece = order[i];
            if (boxes[piece].distance(point) > best.distance || !wanted(piece / kPieces)) {
                continue;
            }
            const NearPoint near = on_piece(point, piece);
            if (near.distance <= best.distance) {
                best = near;
            }
        }
    }
};

EdgeField::EdgeField(const std::vector<TopoDS_Edge>& edges) : index_(std::make_unique<Index>()) {
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        index_->curves.emplace_back(edges[e]);
        double length = 0.0;
        for (int i = 0; i < kPieces; ++i) {
            const Eigen::Vector3d a = point(e, static_cast<double>(i) / kPieces);
            const Eigen::Vector3d m = point(e, (i + 0.5) / kPieces);
            const Eigen::Vector3d b = point(e, (i + 1.0) / kPieces);
            length += (b - m).norm() + (m - a).norm();
            const Eigen::Vector3d grow =
                Eigen::Vector3d::Constant(2.0 * (m - 0.5 * (a + b)).norm());
            index_->boxes.push_back({a.cwiseMin(b) - grow, a.cwiseMax(b) + grow});
        }
        index_->lengths.push_back(length);
    }
    index_->order.resize(index_->boxes.size());
    std::iota(index_->order.begin(), index_->order.end(), 0);
    index_->build(0, 0, static_cast<int>(index_->order.size()));
}

EdgeField::~EdgeField() = default;

NearPoint EdgeField::nearest(const Eigen::Vector3d& point,
                             const std::function<bool(int edge)>& wanted, double limit) const {
    NearPoint best{-1, limit, 0.0};
    index_->search(0, point, wanted, best);
    return best;
}

Eigen::Vector3d EdgeField::point(int edge, double t) const {
    return occ::from_occ(index_->curves[edge].Value(index_->parameter(edge, t)));
}

double EdgeField::length(int edge) const {
    return index_->lengths[edge];
}

}  // namespace suture

#include "suture/sew/free_edges.h"

#include "suture/occ/convert.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suture {

namespace {

/// Chords for the length of an edge: it is compared with gaps, a percent is enough.
constexpr int kChordsOfLength = 16;

/// Newton's method from a guess of the same share of the parameters.
constexpr int kSteps = 10;

/// In OpenVSP's files compounds repeat the edges of others: each is sewn by itself first.
void collect_groups(const TopoDS_Shape& shape, int group, const TopTools_IndexedMapOfShape& faces,
                    std::vector<int>& group_of, int& groups) {
    for (TopoDS_Iterator child(shape); child.More(); child.Next()) {
        const TopoDS_Shape& part = child.Value();
        if (part.ShapeType() == TopAbs_FACE) {
            group_of[faces.FindIndex(part) - 1] = group;
        } else if (part.ShapeType() < TopAbs_FACE) {
            const int inner = part.ShapeType() == TopAbs_COMPOUND ? groups++ : group;
            collect_groups(part, inner, faces, group_of, groups);
        }
    }
}

double length_of(const FreeEdge& edge) {
    double length = 0.0;
    Eigen::Vector3d before = edge.point(edge.first());
    for (int i = 1; i <= kChordsOfLength; ++i) {
        const Eigen::Vector3d here =
            edge.point(edge.first() + (edge.last() - edge.first()) * i / kChordsOfLength);
        length += (here - before).norm();
        before = here;
    }
    return length;
}

}  // namespace

Eigen::Vector3d FreeEdge::point(double parameter) const {
    return occ::from_occ(curve.Value(parameter));
}

std::vector<FreeEdge> find_free_edges(const TopoDS_Shape& shape, const ShellGraph& graph,
                                      double most, Places& places) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::vector<int> group_of(faces.Extent(), 0);
    int groups = 1;
    collect_groups(shape, 0, faces, group_of, groups);
    TopTools_DataMapOfShapeInteger number_of;
    const auto place_of = [&](const TopoDS_Vertex& vertex) {
        if (const int* known = number_of.Seek(vertex)) {
            return *known;
        }
        const int number = places.add(occ::from_occ(BRep_Tool::Pnt(vertex)), vertex,
                                      std::min(most, BRep_Tool::Tolerance(vertex)));
        number_of.Bind(vertex, number);
        return number;
    };
    std::vector<FreeEdge> edges;
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        const Coedge& use = graph.uses[i];
        const TopoDS_Vertex start = TopExp::FirstVertex(use.edge);
        const TopoDS_Vertex end = TopExp::LastVertex(use.edge);
        if (!use.free || start.IsNull() || end.IsNull() || !BRep_Tool::IsGeometric(use.edge)) {
            continue;
        }
        FreeEdge& edge = edges.emplace_back();
        edge.use = i;
        edge.face = use.face;
        edge.group = group_of[faces.FindIndex(graph.faces[use.face]) - 1];
        edge.curve.Initialize(use.edge);
        edge.length = length_of(edge);
        edge.accuracy =
            std::min(most, std::max({BRep_Tool::Tolerance(use.edge), BRep_Tool::Tolerance(start),
                                     BRep_Tool::Tolerance(end)}));
        edge.ends = {place_of(start), place_of(end)};
    }
    return edges;
}

FootPoint foot_point(const BRepAdaptor_Curve& curve, double first, double last,
                     const Eigen::Vector3d& p, double guess) {
    FootPoint best{guess, std::numeric_limits<double>::max()};
    const double range = last - first;
    double s = std::clamp(guess, first, last);
    for (int i = 0; i < kSteps; ++i) {
        gp_Pnt here;
        gp_Vec d1;
        gp_Vec d2;
        curve.D2(s, here, d1, d2);
        const Eigen::Vector3d away = occ::from_occ(here) - p;
        if (away.norm() < best.distance) {
            best = {s, away.norm()};
        }
        const double slope = away.dot(occ::from_occ(d1));
        const double full = d1.SquareMagnitude() + away.dot(occ::from_occ(d2));
        const double bend = full > 0.0 ? full : d1.SquareMagnitude();
        if (bend <= 0.0) {
            break;
        }
        const double before = s;
        // not farther than an eighth of the range at once: the guess is better than that
        s = std::clamp(s + std::clamp(-slope / bend, -range / 8.0, range / 8.0), first, last);
        if (std::abs(s - before) <= 1e-13 * range) {
            break;
        }
    }
    return best;
}

}  // namespace suture

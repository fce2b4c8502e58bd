#include "suture/detect/loose_faces.h"

#include "suture/detect/edge_field.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <limits>

namespace suture {

namespace {

/// The smallest tolerance that is sewn with, as a share of the model's diagonal: room for numbers
/// written with seven digits, as many IGES files have them.
constexpr double kLeastTolerance = 1e-6;

/// Sewing stays this many times below the smallest feature: the shortest edge, the narrowest slot.
constexpr double kBelowFeatures = 4.0;

/// Above the widest gap that is to be closed, since gaps are measured at some points of an edge.
constexpr double kAboveGaps = 1.25;

/// Inner points of an edge at which others must meet it.
constexpr int kProbes = 9;

std::vector<bool> lies_alone(const ShellGraph& graph) {
    std::vector<int> size(graph.components, 0);
    std::vector<bool> open(graph.faces.size(), false);
    for (const int component : graph.component) {
        ++size[component];
    }
    for (const Coedge& use : graph.uses) {
        open[use.face] = open[use.face] || use.free;
    }
    std::vector<bool> alone;
    for (std::size_t i = 0; i < graph.faces.size(); ++i) {
        alone.push_back(open[i] && size[graph.component[i]] == 1);
    }
    return alone;
}

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

/// An edge that faces of the same group meet from two more sides, all along it.
bool is_junction(const EdgeField& field, const std::vector<int>& face_of_edge,
                 const std::vector<int>& group_of_edge, int edge, double tolerance) {
    for (int i = 0; i < kProbes; ++i) {
        const Eigen::Vector3d p = field.point(edge, (i + 0.5) / kProbes);
        int met = face_of_edge[edge];
        for (int other = 0; other < 2; ++other) {
            const auto wanted = [&](int e) {
                return face_of_edge[e] != face_of_edge[edge] && face_of_edge[e] != met &&
                       group_of_edge[e] == group_of_edge[edge];
            };
            const NearPoint near = field.nearest(p, wanted, tolerance);
            if (near.edge < 0) {
                return false;
            }
            met = face_of_edge[near.edge];
        }
    }
    return true;
}

}  // namespace

Loose find_loose(const TopoDS_Shape& shape, const ShellGraph& graph) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::vector<int> group_of(graph.faces.size(), 0);
    Loose loose;
    loose.groups = 1;
    collect_groups(shape, 0, faces, group_of, loose.groups);
    const std::vector<bool> alone = lies_alone(graph);
    for (std::size_t i = 0; i < graph.faces.size(); ++i) {
        if (alone[i]) {
            loose.faces.push_back({graph.faces[i], group_of[i]});
        }
    }
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        loose.free_edges += graph.uses[i].free ? 1 : 0;
        if (graph.uses[i].free && alone[graph.uses[i].face]) {
            loose.uses.push_back(i);
        }
    }
    return loose;
}

double choose_tolerance(const std::vector<EdgePartner>& partners, double model_diagonal) {
    double feature = std::numeric_limits<double>::max();
    for (const EdgePartner& edge : partners) {
        feature = std::min(feature, edge.length);
        if (!is_fold(edge)) {
            feature = std::min(feature, edge.own_gap);
        }
    }
    const double most = feature / kBelowFeatures;
    double widest = 0.0;
    for (const EdgePartner& edge : partners) {
        if (is_seam(edge) && kAboveGaps * edge.gap <= most) {
            widest = std::max(widest, edge.gap);
        }
    }
    return std::min(most, std::max(kLeastTolerance * model_diagonal, kAboveGaps * widest));
}

void set_membranes_apart(const ShellGraph& graph, double tolerance, Loose& loose) {
    TopTools_IndexedMapOfShape faces;  // numbers them as loose.faces
    for (const LooseFace& face : loose.faces) {
        faces.Add(face.face);
    }
    std::vector<TopoDS_Edge> edges;
    std::vector<int> face_of_edge;
    std::vector<int> group_of_edge;
    for (const int use : loose.uses) {
        edges.push_back(graph.uses[use].edge);
        const int face = faces.FindIndex(graph.faces[graph.uses[use].face]) - 1;
        face_of_edge.push_back(face);
        group_of_edge.push_back(loose.faces[face].group);
    }
    const EdgeField field(edges);
    std::vector<bool> membrane(loose.faces.size(), true);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        const int face = face_of_edge[e];
        membrane[face] =
            membrane[face] && is_junction(field, face_of_edge, group_of_edge, e, tolerance);
    }
    for (std::size_t i = 0; i < membrane.size(); ++i) {
        if (membrane[i]) {
            loose.faces[i].group = loose.groups++;
        }
    }
}

}  // namespace suture

#include "suture/detect/shell_graph.h"

#include "suture/base/contract.h"
#include "suture/base/tolerance.h"
#include "suture/detect/use_geometry.h"

#include <Eigen/Geometry>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

namespace suture {

namespace {

TopoDS_Vertex vertex_of(const Coedge& use, bool at_start) {
    return at_start ? TopExp::FirstVertex(use.edge, Standard_True)
                    : TopExp::LastVertex(use.edge, Standard_True);
}

bool same_vertex(const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
    return a.IsNull() ? b.IsNull() : a.IsSame(b);
}

UseGeometry geometry_of(const ShellGraph& graph, int use) {
    const Coedge& u = graph.uses[use];
    return {u.edge, graph.faces[u.face]};
}

/// Of several uses that could follow `from` around the face, the one that lies next to it in the
/// parameter plane, and among those in one point (the wire touches itself) the one behind the
/// narrowest corner of material.
int nearest_follower(const ShellGraph& graph, int from, const std::vector<int>& candidates) {
    const UseGeometry arriving = geometry_of(graph, from);
    const Eigen::Vector2d end = arriving.uv(1.0);
    std::vector<std::pair<double, int>> by_distance;
    double extent = 0.0;
    for (const int candidate : candidates) {
        const UseGeometry leaving = geometry_of(graph, candidate);
        by_distance.emplace_back((leaving.uv(0.0) - end).norm(), candidate);
        extent = std::max(extent, (leaving.uv(1.0) - leaving.uv(0.0)).norm());
    }
    std::sort(by_distance.begin(), by_distance.end());
    // Parameter values of one point agree far better than to a thousandth of an edge's length.
    const double limit = by_distance.front().first + 1e-3 * extent;
    int best = by_distance.front().second;
    double narrowest = std::numeric_limits<double>::max();
    for (const auto& [distance, candidate] : by_distance) {
        if (distance > limit || graph.uses[candidate].degenerated || graph.uses[from].degenerated) {
            break;
        }
        const double angle = corner_angle(arriving, geometry_of(graph, candidate));
        if (angle < narrowest) {
            narrowest = angle;
            best = candidate;
        }
    }
    return best;
}

/// Links each use of a wire to the one that follows it. Wires need not list their edges in order.
void link_wire(ShellGraph& graph, int begin) {
    const int end = static_cast<int>(graph.uses.size());
    for (int i = begin; i < end; ++i) {
        const TopoDS_Vertex vertex = vertex_of(graph.uses[i], false);
        std::vector<int> candidates;
        for (int j = begin; j < end; ++j) {
            if (graph.uses[j].previous < 0 && same_vertex(vertex, vertex_of(graph.uses[j], true))) {
                candidates.push_back(j);
            }
        }
        if (candidates.empty()) {
            continue;
        }
        const int next =
            candidates.size() == 1 ? candidates.front() : nearest_follower(graph, i, candidates);
        graph.uses[i].next = next;
        graph.uses[next].previous = i;
    }
}

void add_face(ShellGraph& graph, int index) {
    for (TopoDS_Iterator wires(graph.faces[index]); wires.More(); wires.Next()) {
        const int begin = static_cast<int>(graph.uses.size());
        for (TopoDS_Iterator edges(wires.Value()); edges.More(); edges.Next()) {
            const TopoDS_Shape& edge = edges.Value();
            if (edge.ShapeType() != TopAbs_EDGE ||
                (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED)) {
                continue;
            }
            Coedge use;
            use.edge = TopoDS::Edge(edge);
            use.face = index;
            use.degenerated = BRep_Tool::Degenerated(use.edge);
            graph.uses.push_back(use);
        }
        link_wire(graph, begin);
    }
}

/// Into the face, at right angles to the middle of the edge.
Eigen::Vector3d into_face(const ShellGraph& graph, int use) {
    const UseGeometry geometry = geometry_of(graph, use);
    constexpr double kStep = 1.0 / kChords;
    const UsePoint middle = geometry.at(0.5);
    const Eigen::Vector3d along = geometry.at(0.5 + kStep).point - geometry.at(0.5 - kStep).point;
    return middle.normal.cross(along).normalized();
}

/// Mates the uses of an edge, the straightest pair first.
/// Result  the odd one out, or -1.
int mate_straightest(ShellGraph& graph, std::vector<int> uses) {
    while (uses.size() > 1) {
        std::size_t best_a = 0;
        std::size_t best_b = 1;
        double straightest = std::numeric_limits<double>::max();
        for (std::size_t a = 0; uses.size() > 2 && a < uses.size(); ++a) {
            for (std::size_t b = a + 1; b < uses.size(); ++b) {
                const double cosine = into_face(graph, uses[a]).dot(into_face(graph, uses[b]));
                if (cosine < straightest) {
                    straightest = cosine;
                    best_a = a;
                    best_b = b;
                }
            }
        }
        graph.uses[uses[best_a]].mate = uses[best_b];
        graph.uses[uses[best_b]].mate = uses[best_a];
        uses.erase(uses.begin() + static_cast<std::ptrdiff_t>(best_b));
        uses.erase(uses.begin() + static_cast<std::ptrdiff_t>(best_a));
    }
    return uses.empty() ? -1 : uses.front();
}

/// Bodies can have an edge in common: each shell is mated by itself, then what is single in its
/// shell.
void mate_edge(ShellGraph& graph, const std::vector<int>& uses) {
    std::map<int, std::vector<int>> by_shell;
    for (const int use : uses) {
        by_shell[graph.shell[graph.uses[use].face]].push_back(use);
    }
    std::vector<int> single;
    for (const auto& [shell, own] : by_shell) {
        if (own.size() == 1) {
            single.push_back(own.front());
        } else {
            mate_straightest(graph, own);
        }
    }
    const int last = mate_straightest(graph, single);
    if (last >= 0 && single.size() == 1) {
        // Also where the edge has two pcurves on the face's surface: faces on both sides of a
        // seam can share that surface, and this one uses one of them.
        graph.uses[last].free = true;
    }
}

void mate_uses(ShellGraph& graph) {
    TopTools_IndexedMapOfShape edges;
    std::vector<std::vector<int>> uses_of;
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        if (graph.uses[i].degenerated) {
            continue;
        }
        const std::size_t index = edges.Add(graph.uses[i].edge) - 1;
        uses_of.resize(std::max(uses_of.size(), index + 1));
        uses_of[index].push_back(i);
    }
    for (const std::vector<int>& uses : uses_of) {
        mate_edge(graph, uses);
    }
}

/// Faces shell by shell, and those that lie in none, in TopExp's order of what comes first.
void collect_faces(const TopoDS_Shape& shape, ShellGraph& graph) {
    TopTools_IndexedMapOfShape shells;
    TopTools_IndexedMapOfShape solids;
    TopTools_IndexedMapOfShape loose;
    int solid = -1;
    const auto take = [&](const TopoDS_Shape& face, int shell) {
        graph.faces.push_back(TopoDS::Face(face));
        graph.shell.push_back(shell);
        graph.solid.push_back(solid);
    };
    const std::function<void(const TopoDS_Shape&)> visit = [&](const TopoDS_Shape& part) {
        if (part.ShapeType() == TopAbs_FACE) {
            if (!loose.Contains(part)) {
                loose.Add(part);
                take(part, -1);
            }
        } else if (part.ShapeType() == TopAbs_SHELL) {
            if (shells.Contains(part)) {
                return;
            }
            const int number = shells.Add(part);
            TopTools_IndexedMapOfShape faces;
            TopExp::MapShapes(part, TopAbs_FACE, faces);
            for (int i = 1; i <= faces.Extent(); ++i) {
                take(faces(i), number);
            }
        } else if (part.ShapeType() < TopAbs_SHELL) {
            const int around = solid;
            solid = part.ShapeType() == TopAbs_SOLID ? solids.Add(part) : around;
            for (TopoDS_Iterator child(part); child.More(); child.Next()) {
                visit(child.Value());
            }
            solid = around;
        }
    };
    visit(shape);
}

/// Finds the connected shells and turns the faces of each to agree, as far as they can.
void orient_components(ShellGraph& graph) {
    const std::size_t n = graph.faces.size();
    std::vector<std::vector<int>> uses_of(n);
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        uses_of[graph.uses[i].face].push_back(i);
    }
    graph.component.assign(n, -1);
    graph.sign.assign(n, 1);
    for (std::size_t seed = 0; seed < n; ++seed) {
        if (graph.component[seed] >= 0) {
            continue;
        }
        const int id = graph.components++;
        bool orientable = true;
        std::vector<int> members{static_cast<int>(seed)};
        graph.component[seed] = id;
        for (std::size_t k = 0; k < members.size(); ++k) {
            for (const int use : uses_of[members[k]]) {
                const int mate = graph.uses[use].mate;
                if (mate < 0) {
                    continue;
                }
                const int other = graph.uses[mate].face;
                const bool agree =
                    graph.uses[use].edge.Orientation() != graph.uses[mate].edge.Orientation();
                const int sign = graph.sign[members[k]] * (agree ? 1 : -1);
                if (graph.component[other] < 0) {
                    graph.component[other] = id;
                    graph.sign[other] = sign;
                    members.push_back(other);
                } else if (graph.sign[other] != sign) {
                    orientable = false;
                }
            }
        }
        graph.orientable.push_back(orientable);
        int balance = 0;
        for (const int face : members) {
            balance += graph.sign[face];
        }
        for (const int face : members) {
            graph.sign[face] *= balance < 0 ? -1 : 1;
        }
    }
}

}  // namespace

ShellGraph make_shell_graph(const TopoDS_Shape& shape) {
    ShellGraph graph;
    collect_faces(shape, graph);
    for (int i = 0; i < static_cast<int>(graph.faces.size()); ++i) {
        add_face(graph, i);
    }
    mate_uses(graph);
    orient_components(graph);
    return graph;
}

Fan walk_fan(const ShellGraph& graph, UseEnd from) {
    Fan fan;
    UseEnd here = from;
    // Every step is undone by exactly one other, so the walk cannot run into a circle.
    while (true) {
        UseEnd beside = here;
        double pole_angle = 0.0;
        do {
            const Coedge& use = graph.uses[beside.use];
            beside = beside.at_start ? UseEnd{use.previous, false} : UseEnd{use.next, true};
            if (beside.use < 0) {
                return fan;
            }
            if (graph.uses[beside.use].degenerated) {
                pole_angle += geometry_of(graph, beside.use).degenerated_angle();
                beside.at_start = !beside.at_start;
            } else {
                break;
            }
        } while (true);
        if (pole_angle > 0.0) {
            fan.angle += pole_angle;
        } else {
            const int arriving = here.at_start ? beside.use : here.use;
            const int leaving = here.at_start ? here.use : beside.use;
            fan.angle += corner_angle(geometry_of(graph, arriving), geometry_of(graph, leaving));
        }
        const Coedge& use = graph.uses[beside.use];
        if (use.mate < 0) {
            fan.last = beside;
            return fan;
        }
        const Coedge& mate = graph.uses[use.mate];
        const bool same_way = use.edge.Orientation() == mate.edge.Orientation();
        here = {use.mate, same_way ? beside.at_start : !beside.at_start};
    }
}

}  // namespace suture

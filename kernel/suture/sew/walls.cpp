#include "suture/sew/walls.h"

#include "suture/detect/shell_graph.h"

#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopAbs.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <algorithm>
#include <optional>

namespace suture {

namespace {

/// The free edges of a shell, and which way it uses them.
using FreeEdges = TopTools_DataMapOfShapeInteger;

FreeEdges free_edges_of(const ShellGraph& graph, int shell) {
    FreeEdges free;
    for (const Coedge& use : graph.uses) {
        if (use.free && graph.shell[use.face] == shell) {
            free.Bind(use.edge, static_cast<int>(use.edge.Orientation()));
        }
    }
    return free;
}

/// The face with the other side outwards, as a face of its own on the same wires; nothing: it is no
/// wall of the shell.
std::optional<TopoDS_Face> wall_for(const TopoDS_Face& face, const FreeEdges& free) {
    int common = 0;
    int others = 0;
    int same_way = 0;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        if (const int* way = free.Seek(it.Current())) {
            ++common;
            same_way += *way == static_cast<int>(it.Current().Orientation()) ? 1 : 0;
        } else if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) {
            ++others;
        }
    }
    if (common <= others) {
        return std::nullopt;
    }
    const BRep_Builder builder;
    TopoDS_Shape wall = face.EmptyCopied();
    wall.Orientation(TopAbs_FORWARD);
    for (TopoDS_Iterator it(face.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
        builder.Add(wall, it.Value());
    }
    const bool turn = 2 * same_way > common;
    return TopoDS::Face(
        wall.Oriented(turn ? TopAbs::Reverse(face.Orientation()) : face.Orientation()));
}

/// A shell with its side of one wall; nothing: there is none.
std::optional<TopoDS_Shape> with_wall(const ShellGraph& graph, const TopoDS_Shape& shell,
                                      int number) {
    const FreeEdges free = free_edges_of(graph, number);
    // a sheet of one face has no inside
    if (free.IsEmpty() || std::count(graph.shell.begin(), graph.shell.end(), number) < 2) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < graph.faces.size(); ++i) {
        if (graph.shell[i] == number || graph.shell[i] < 0) {
            continue;
        }
        if (const auto wall = wall_for(graph.faces[i], free)) {
            const BRep_Builder builder;
            TopoDS_Shape more = shell.EmptyCopied();
            for (TopoDS_Iterator it(shell, Standard_False); it.More(); it.Next()) {
                builder.Add(more, it.Value());
            }
            builder.Add(more, shell.Orientation() == TopAbs_REVERSED
                                  ? TopoDS::Face(wall->Reversed())
                                  : *wall);
            more.Closed(BRep_Tool::IsClosed(more));
            return more;
        }
    }
    return std::nullopt;
}

}  // namespace

Walls give_walls(const TopoDS_Shape& shape) {
    Walls result{shape, 0};
    for (bool again = true; again;) {
        again = false;
        const ShellGraph graph = make_shell_graph(result.shape);
        TopTools_IndexedMapOfShape shells;  // the graph's numbers
        TopExp::MapShapes(result.shape, TopAbs_SHELL, shells);
        for (int i = 1; shells.Extent() > 1 && i <= shells.Extent() && !again; ++i) {
            if (const auto more = with_wall(graph, shells(i), i)) {
                BRepTools_ReShape exchange;
                exchange.Replace(shells(i), *more);
                result.shape = exchange.Apply(result.shape);
                ++result.count;
                again = true;
            }
        }
    }
    return result;
}

}  // namespace suture

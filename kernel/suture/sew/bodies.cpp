#include "suture/sew/bodies.h"

#include "suture/occ/topology.h"

#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <map>
#include <set>

namespace suture {

namespace {

/// Only the sign of the volume is asked for.
constexpr double kVolumePrecision = 1e-2;

TopoDS_Compound compound_of(const std::vector<TopoDS_Face>& faces, const std::vector<int>& shell) {
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (std::size_t i = 0; i < faces.size();) {
        if (shell[i] < 0) {
            builder.Add(compound, faces[i++]);
            continue;
        }
        TopoDS_Shell together;
        builder.MakeShell(together);
        for (const int number = shell[i]; i < faces.size() && shell[i] == number; ++i) {
            builder.Add(together, faces[i]);
        }
        builder.Add(compound, together);
    }
    return compound;
}

std::vector<NewShell> shells_of(const ShellGraph& graph) {
    const BRep_Builder builder;
    std::vector<NewShell> shells(graph.components);
    std::vector<bool> closed(graph.components, true);
    for (NewShell& next : shells) {
        builder.MakeShell(next.shell);
    }
    for (int i = 0; i < static_cast<int>(graph.faces.size()); ++i) {
        NewShell& own = shells[graph.component[i]];
        const TopoDS_Face& face = graph.faces[i];
        builder.Add(own.shell, graph.sign[i] < 0 ? TopoDS::Face(face.Reversed()) : face);
        own.members.push_back(i);
    }
    for (const Coedge& use : graph.uses) {
        const int component = graph.component[use.face];
        closed[component] = closed[component] && !use.free;
    }
    for (int c = 0; c < graph.components; ++c) {
        shells[c].shell.Closed(closed[c]);
        if (closed[c] && graph.orientable[c]) {
            GProp_GProps volume;
            BRepGProp::VolumeProperties(shells[c].shell, volume, kVolumePrecision);
            if (volume.Mass() < 0.0) {
                shells[c].shell.Reverse();
            }
            shells[c].bounds_solid = true;
        }
    }
    return shells;
}

/// A closed shell as a solid, any other as it is.
TopoDS_Shape body_of(const NewShell& shell) {
    if (!shell.bounds_solid) {
        return shell.shell;
    }
    const BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell.shell);
    return solid;
}

/// What a shape's faces and shells have become.
struct Replacements {
    TopTools_IndexedMapOfShape shells;        ///< of the shape
    std::map<int, TopTools_MapOfShape> gone;  ///< per shell, 0: none: faces in a new shell now
    TopTools_DataMapOfShapeShape other;       ///< faces and whole shells
};

/// A container with what its parts have become; null when nothing is left of it. What holds nothing
/// that has changed is kept as it is.
///
/// Input  shell: the number of the shell that the part lies in, 0: in none.
TopoDS_Shape replaced(const TopoDS_Shape& shape, int shell, const Replacements& now) {
    const auto gone = now.gone.find(shell);
    if (gone != now.gone.end() && gone->second.Contains(shape)) {
        return {};
    }
    if (const TopoDS_Shape* other = now.other.Seek(shape)) {
        return *other;
    }
    if (shape.ShapeType() >= TopAbs_FACE) {
        return shape;
    }
    const BRep_Builder builder;
    TopoDS_Shape copy = shape.EmptyCopied();
    copy.Location(TopLoc_Location());
    copy.Orientation(TopAbs_FORWARD);
    const int inside = shape.ShapeType() == TopAbs_SHELL ? now.shells.FindIndex(shape) : 0;
    bool changed = false;
    bool empty = true;
    for (TopoDS_Iterator child(shape); child.More(); child.Next()) {
        TopoDS_Shape kept = replaced(child.Value(), inside, now);
        changed = changed || kept.IsNull() || !kept.IsSame(child.Value());
        if (kept.IsNull()) {
            continue;
        }
        if (shape.ShapeType() == TopAbs_SOLID && kept.ShapeType() == TopAbs_SOLID) {
            kept = TopoDS_Iterator(kept).Value();  // the body's shell: it has a solid already
        }
        builder.Add(copy, kept);
        empty = false;
    }
    if (!changed) {
        return shape;
    }
    return empty ? TopoDS_Shape() : copy;
}

}  // namespace

std::vector<NewShell> make_shells(const std::vector<TopoDS_Face>& faces,
                                  const std::vector<int>& shell) {
    std::vector<NewShell> shells = shells_of(make_shell_graph(compound_of(faces, shell)));
    std::erase_if(shells, [](const NewShell& next) {
        return next.members.size() == 1 && !next.shell.Closed();
    });
    return shells;
}

TopoDS_Shape with_new_bodies(const TopoDS_Shape& shape, const ShellGraph& graph,
                             const std::vector<TopoDS_Face>& now, const std::vector<bool>& sewn) {
    const std::vector<TopoDS_Face>& before = graph.faces;
    Replacements replacements;
    const TopTools_IndexedMapOfShape& old_shells = replacements.shells;  // the graph's numbers
    TopExp::MapShapes(shape, TopAbs_SHELL, replacements.shells);
    std::vector<TopoDS_Shape> bodies;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!before[i].IsSame(now[i])) {
            replacements.other.Bind(before[i], now[i]);
        }
    }
    for (const NewShell& next : make_shells(now, graph.shell)) {
        if (std::none_of(next.members.begin(), next.members.end(),
                         [&](int face) { return sewn[face]; })) {
            continue;
        }
        std::set<int> owners;
        for (const int face : next.members) {
            owners.insert(graph.shell[face]);
        }
        const int owner = *owners.begin();
        const bool within_itself = owners.size() == 1 && owner >= 0 &&
                                   occ::faces_of(old_shells(owner)).size() == next.members.size();
        if (within_itself) {
            replacements.other.Bind(old_shells(owner), body_of(next));
            continue;
        }
        for (const int face : next.members) {
            replacements.gone[std::max(0, graph.shell[face])].Add(before[face]);
        }
        bodies.push_back(body_of(next));
    }
    const TopoDS_Shape rest = replaced(shape, 0, replacements);
    if (bodies.empty() || (rest.IsNull() && bodies.size() == 1)) {
        return bodies.empty() ? rest : bodies.front();
    }
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    if (!rest.IsNull() && rest.ShapeType() == TopAbs_COMPOUND) {
        for (TopoDS_Iterator child(rest); child.More(); child.Next()) {
            builder.Add(compound, child.Value());
        }
    } else if (!rest.IsNull()) {
        builder.Add(compound, rest);
    }
    for (const TopoDS_Shape& body : bodies) {
        builder.Add(compound, body);
    }
    return compound;
}

}  // namespace suture

#include "suture/detect/sew_loose.h"

#include "suture/detect/edge_field.h"
#include "suture/detect/loose_faces.h"
#include "suture/detect/seams.h"
#include "suture/detect/sew_faces.h"
#include "suture/detect/shell_graph.h"
#include "suture/detect/use_geometry.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace suture {

namespace {

/// Sews the loose faces of each group by themselves. The order of `faces` is kept.
Result<std::vector<LooseFace>> sew_groups(const std::vector<LooseFace>& faces, double tolerance) {
    std::vector<LooseFace> result = faces;
    std::vector<int> groups;
    groups.reserve(faces.size());
    for (const LooseFace& face : faces) {
        groups.push_back(face.group);
    }
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    for (const int group : groups) {
        std::vector<std::size_t> members;
        std::vector<TopoDS_Face> together;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            if (faces[i].group == group) {
                members.push_back(i);
                together.push_back(faces[i].face);
            }
        }
        const Result<SewnFaces> sewn = sew_faces(together, tolerance);
        if (!sewn) {
            return tl::unexpected(sewn.error());
        }
        for (std::size_t k = 0; k < members.size(); ++k) {
            result[members[k]].face = sewn->faces[k];
        }
    }
    return result;
}

TopoDS_Compound compound_of(const std::vector<LooseFace>& faces) {
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const LooseFace& face : faces) {
        builder.Add(compound, face.face);
    }
    return compound;
}

std::vector<int> free_uses_of(const ShellGraph& graph) {
    std::vector<int> uses;
    for (int i = 0; i < static_cast<int>(graph.uses.size()); ++i) {
        if (graph.uses[i].free) {
            uses.push_back(i);
        }
    }
    return uses;
}

/// Gives groups that still have seams between them one common number in `faces`.
/// Result  true if there are such groups.
bool merge_groups(const std::vector<LooseFace>& sewn, double tolerance,
                  std::vector<LooseFace>& faces) {
    const ShellGraph graph = make_shell_graph(compound_of(sewn));
    const std::vector<int> uses = free_uses_of(graph);
    const std::vector<EdgePartner> partners = find_partners(graph, uses);
    bool merged = false;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (partners[i].partner < 0 || partners[i].gap > tolerance) {
            continue;
        }
        const int a = faces[graph.uses[uses[i]].face].group;
        const int b = faces[graph.uses[partners[i].partner].face].group;
        if (a != b) {
            merged = true;
            for (LooseFace& face : faces) {
                face.group = face.group == b ? a : face.group;
            }
        }
    }
    return merged;
}

/// A container without some of its faces; null when nothing is left. What holds none of them is
/// kept as it is.
TopoDS_Shape without(const TopoDS_Shape& shape, const TopTools_MapOfShape& faces) {
    if (shape.ShapeType() >= TopAbs_FACE) {
        return faces.Contains(shape) ? TopoDS_Shape() : shape;
    }
    BRep_Builder builder;
    TopoDS_Shape copy = shape.EmptyCopied();
    copy.Location(TopLoc_Location());
    copy.Orientation(TopAbs_FORWARD);
    bool changed = false;
    bool empty = true;
    for (TopoDS_Iterator child(shape); child.More(); child.Next()) {
        const TopoDS_Shape kept = without(child.Value(), faces);
        changed = changed || kept.IsNull() || !kept.IsEqual(child.Value());
        if (!kept.IsNull()) {
            builder.Add(copy, kept);
            empty = false;
        }
    }
    if (!changed) {
        return shape;
    }
    return empty ? TopoDS_Shape() : copy;
}

/// A closed shell as a solid, any other as it is.
TopoDS_Shape body_of(const NewShell& shell) {
    if (!shell.bounds_solid) {
        return shell.shell;
    }
    BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell.shell);
    return solid;
}

/// The shape with the new shells in place of their loose faces.
void assemble(const TopoDS_Shape& shape, const std::vector<LooseFace>& before,
              const std::vector<NewShell>& shells, SewnShape& result) {
    TopTools_MapOfShape gone;
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const NewShell& shell : shells) {
        std::vector<TopoDS_Face> now = occ::faces_of(shell.shell);
        for (std::size_t k = 0; k < shell.members.size(); ++k) {
            const TopoDS_Face& old = before[shell.members[k]].face;
            gone.Add(old);
            if (!old.IsSame(now[k])) {
                result.replaced.Bind(old, now[k]);
            }
        }
    }
    const TopoDS_Shape rest = without(shape, gone);
    if (rest.IsNull() && shells.size() == 1) {
        result.shape = body_of(shells.front());
        return;
    }
    if (!rest.IsNull() && rest.ShapeType() == TopAbs_COMPOUND) {
        for (TopoDS_Iterator child(rest); child.More(); child.Next()) {
            builder.Add(compound, child.Value());
        }
    } else if (!rest.IsNull()) {
        builder.Add(compound, rest);
    }
    for (const NewShell& shell : shells) {
        builder.Add(compound, body_of(shell));
    }
    result.shape = compound;
}

/// The widest gap of the loose edges that are no longer free.
double largest_closed_gap(const ShellGraph& before, const Loose& loose,
                          const std::vector<EdgePartner>& partners,
                          const std::vector<LooseFace>& sewn) {
    const ShellGraph after = make_shell_graph(compound_of(sewn));
    std::vector<TopoDS_Edge> edges;
    edges.reserve(after.uses.size());
    for (const Coedge& use : after.uses) {
        edges.push_back(use.edge);
    }
    const EdgeField field(edges);
    TopTools_IndexedMapOfShape faces;  // numbers them as `sewn`
    for (const LooseFace& face : loose.faces) {
        faces.Add(face.face);
    }
    double largest = 0.0;
    for (std::size_t i = 0; i < loose.uses.size(); ++i) {
        const Coedge& use = before.uses[loose.uses[i]];
        const int face = faces.FindIndex(before.faces[use.face]) - 1;
        const Eigen::Vector3d middle = UseGeometry(use.edge, before.faces[use.face]).at(0.5).point;
        const auto of_face = [&](int e) {
            return after.uses[e].face == face && !after.uses[e].degenerated;
        };
        const NearPoint near = field.nearest(middle, of_face, std::numeric_limits<double>::max());
        if (near.edge >= 0 && !after.uses[near.edge].free) {
            largest = std::max(largest, partners[i].gap);
        }
    }
    return largest;
}

Result<SewnShape> sew(const TopoDS_Shape& shape, double tolerance) {
    SewnShape result;
    result.shape = shape;
    const ShellGraph graph = make_shell_graph(shape);
    Loose loose = find_loose(shape, graph);
    result.loose_faces = static_cast<int>(loose.faces.size());
    result.free_edges_before = loose.free_edges;
    result.free_edges_after = loose.free_edges;
    if (loose.faces.empty()) {
        return result;
    }
    const std::vector<EdgePartner> partners = find_partners(graph, loose.uses);
    result.tolerance =
        tolerance > 0.0 ? tolerance : choose_tolerance(partners, occ::diagonal(shape));
    set_membranes_apart(graph, result.tolerance, loose);
    Result<std::vector<LooseFace>> sewn = sew_groups(loose.faces, result.tolerance);
    if (sewn && merge_groups(*sewn, result.tolerance, loose.faces)) {
        sewn = sew_groups(loose.faces, result.tolerance);
    }
    if (!sewn) {
        return tl::unexpected(sewn.error());
    }
    std::vector<TopoDS_Face> faces;
    faces.reserve(sewn->size());
    for (const LooseFace& face : *sewn) {
        faces.push_back(face.face);
    }
    const Result<std::vector<NewShell>> shells = make_shells(faces);
    if (!shells) {
        return tl::unexpected(shells.error());
    }
    if (shells->empty()) {
        return result;
    }
    assemble(shape, loose.faces, *shells, result);
    result.changed = true;
    result.free_edges_after = static_cast<int>(free_uses_of(make_shell_graph(result.shape)).size());
    result.largest_gap = largest_closed_gap(graph, loose, partners, *sewn);
    return result;
}

}  // namespace

Result<SewnShape> sew_loose(const TopoDS_Shape& shape, double tolerance) {
    if (shape.IsNull()) {
        return fail(ErrorCode::Usage, "there is no shape to sew");
    }
    if (!std::isfinite(tolerance) || tolerance < 0.0) {
        return fail(ErrorCode::Usage,
                    "the sewing tolerance must be a positive number, or 0 to choose one, not {}",
                    tolerance);
    }
    return occ::guarded("sewing loose faces", [&] { return sew(shape, tolerance); });
}

}  // namespace suture

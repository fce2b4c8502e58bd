#include "suture/detect/sew_faces.h"

#include "suture/detect/shell_graph.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>

namespace suture {

namespace {

/// Only the sign of the volume is asked for.
constexpr double kVolumePrecision = 1e-2;

TopoDS_Compound compound_of(const std::vector<TopoDS_Face>& faces) {
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const TopoDS_Face& face : faces) {
        builder.Add(compound, face);
    }
    return compound;
}

/// The result's version of each face that was given to the sewing.
Result<SewnFaces> collect(const BRepBuilderAPI_Sewing& sewing,
                          const std::vector<TopoDS_Face>& faces, double tolerance) {
    TopTools_IndexedMapOfShape sewn;
    TopExp::MapShapes(sewing.SewedShape(), TopAbs_FACE, sewn);
    SewnFaces result;
    int lost = 0;
    for (const TopoDS_Face& face : faces) {
        const TopoDS_Shape now = sewing.IsModified(face) ? sewing.Modified(face) : face;
        const int index = sewn.FindIndex(now);
        if (index == 0) {
            ++lost;
        } else {
            result.faces.push_back(TopoDS::Face(sewn(index)));
        }
    }
    if (lost > 0) {
        return fail(ErrorCode::Internal, "sewing at {:.3g} lost {} of {} faces", tolerance, lost,
                    faces.size());
    }
    return result;
}

NewShell make_shell(const ShellGraph& graph, int component) {
    BRep_Builder builder;
    NewShell result;
    builder.MakeShell(result.shell);
    bool closed = true;
    for (int i = 0; i < static_cast<int>(graph.faces.size()); ++i) {
        if (graph.component[i] == component) {
            const TopoDS_Face& face = graph.faces[i];
            builder.Add(result.shell, graph.sign[i] < 0 ? TopoDS::Face(face.Reversed()) : face);
            result.members.push_back(i);
        }
    }
    for (const Coedge& use : graph.uses) {
        closed = closed && (graph.component[use.face] != component || !use.free);
    }
    result.shell.Closed(closed);
    if (closed && graph.orientable[component]) {
        GProp_GProps volume;
        BRepGProp::VolumeProperties(result.shell, volume, kVolumePrecision);
        if (volume.Mass() < 0.0) {
            result.shell.Reverse();
        }
        result.bounds_solid = true;
    }
    return result;
}

}  // namespace

Result<SewnFaces> sew_faces(const std::vector<TopoDS_Face>& faces, double tolerance) {
    return occ::guarded("sewing loose faces", [&]() -> Result<SewnFaces> {
        BRepBuilderAPI_Sewing sewing(tolerance);
        for (const TopoDS_Face& face : faces) {
            sewing.Add(face);
        }
        sewing.Perform();
        return collect(sewing, faces, tolerance);
    });
}

Result<std::vector<NewShell>> make_shells(const std::vector<TopoDS_Face>& faces) {
    return occ::guarded("joining sewn faces", [&] {
        const ShellGraph graph = make_shell_graph(compound_of(faces));
        std::vector<NewShell> shells;
        for (int component = 0; component < graph.components; ++component) {
            NewShell shell = make_shell(graph, component);
            if (shell.members.size() > 1 || shell.shell.Closed()) {
                shells.push_back(std::move(shell));
            }
        }
        return shells;
    });
}

}  // namespace suture

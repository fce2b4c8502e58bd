#include "files/bad_faces.h"

#include "suture/occ/guard.h"

#include <fmt/format.h>

#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <cmath>
#include <vector>

namespace suture::io {

namespace {

/// A file with more is damaged as a whole: the note says how many.
constexpr int kMostNotes = 10;

/// Whether an edge has what it needs on a face; one of its two curves gives the other.
bool has_curves(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0.0;
    double last = 0.0;
    const bool in_space = !BRep_Tool::Curve(edge, first, last).IsNull();
    const bool on_face = !BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull();
    if (BRep_Tool::Degenerated(edge)) {
        return on_face;
    }
    if (in_space && on_face) {
        return true;
    }
    const Result<bool> mended = occ::guarded("making a curve", [&] {
        return (in_space && ShapeFix_Edge().FixAddPCurve(edge, face, Standard_False)) ||
               (on_face && BRepLib::BuildCurve3d(edge));
    });
    return mended && *mended;
}

/// A face between two edges can be all rim; with more edges that would be seen elsewhere.
bool has_no_area(const TopoDS_Face& face, const std::vector<TopoDS_Edge>& edges) {
    constexpr double kNothing = 1e-12;  // of the square of its length: rounding
    if (edges.size() != 2 || edges[0].IsSame(edges[1])) {
        return false;
    }
    GProp_GProps length;
    GProp_GProps area;
    BRepGProp::LinearProperties(face, length);
    BRepGProp::SurfaceProperties(face, area);
    return std::abs(area.Mass()) <= kNothing * length.Mass() * length.Mass();
}

/// What is wrong with a face, or nothing.
std::string fault_of(const TopoDS_Face& face, const TopTools_IndexedMapOfShape& edges) {
    if (BRep_Tool::Surface(face).IsNull()) {
        return "has no surface";
    }
    std::vector<TopoDS_Edge> own;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        own.push_back(TopoDS::Edge(it.Current()));
        if (!has_curves(own.back(), face)) {
            return fmt::format("has an edge without a curve, edge {}", edges.FindIndex(own.back()));
        }
    }
    return has_no_area(face, own) ? "has no area: its two edges lie on each other" : "";
}

/// Shells of which no face could be read are nothing, and OCCT's IGES writer fails on them.
TopoDS_Shape without_empty_shells(const TopoDS_Shape& shape) {
    BRepTools_ReShape rest;
    bool changed = false;
    for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
        if (!TopExp_Explorer(shell.Current(), TopAbs_FACE).More()) {
            rest.Remove(shell.Current());
            changed = true;
        }
    }
    return changed ? rest.Apply(shape) : shape;
}

}  // namespace

void leave_out_bad_faces(ModelFile& model) {
    int bad_faces = 0;
    for (const Part& part : model.parts()) {
        TopTools_IndexedMapOfShape faces;
        TopTools_IndexedMapOfShape edges;
        TopExp::MapShapes(part.shape, TopAbs_FACE, faces);
        TopExp::MapShapes(part.shape, TopAbs_EDGE, edges);
        BRepTools_ReShape rest;
        bool changed = false;
        for (int i = 1; i <= faces.Extent(); ++i) {
            const std::string fault = fault_of(TopoDS::Face(faces(i)), edges);
            if (fault.empty()) {
                continue;
            }
            rest.Remove(faces(i));
            changed = true;
            if (++bad_faces <= kMostNotes) {
                model.notes.push_back(
                    fmt::format("face {} of '{}' {}: left out", i, part.name, fault));
            }
        }
        TopoDS_Shape left = changed ? rest.Apply(part.shape) : part.shape;
        if (!left.IsNull()) {
            left = without_empty_shells(left);
        }
        if (left.IsNull() || !left.IsSame(part.shape)) {
            if (left.IsNull()) {
                TopoDS_Compound nothing;
                BRep_Builder().MakeCompound(nothing);
                left = nothing;
            }
            model.replace(part, left, {});
        }
    }
    if (bad_faces > kMostNotes) {
        model.notes.push_back(fmt::format("{} faces were left out in all", bad_faces));
    }
}

}  // namespace suture::io

// OCCT's removal of features and its merging of faces, the only code that calls them: a program,
// because they can crash or hang.
#include "suture/edges/grow_request.h"
#include "suture/occ/isolate.h"
#include "suture/occ/topology.h"

#include <BRepAlgoAPI_Defeaturing.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

namespace suture {
namespace {

Result<std::string> grow(const GrowMessage& request) {
    const occ::Numbering before(request.shape);
    BRepAlgoAPI_Defeaturing removal;
    removal.SetShape(request.shape);
    for (const auto& [face, none] : request.faces) {
        removal.AddFaceToRemove(before.faces(face));
    }
    removal.SetToFillHistory(Standard_True);
    removal.Build();
    if (removal.HasErrors() || !removal.IsDone() || removal.Shape().IsNull()) {
        return fail(ErrorCode::Refused, "OCCT finds no way to let the neighbours meet");
    }
    GrowMessage answer;
    answer.shape = removal.Shape();
    const occ::Numbering after(answer.shape);
    for (const auto& [face, none] : request.faces) {
        if (!removal.IsDeleted(before.faces(face)) || after.faces.Contains(before.faces(face))) {
            return fail(ErrorCode::Refused, "OCCT leaves one of the faces where it is");
        }
    }
    for (int face = 1; face <= before.faces.Extent(); ++face) {
        const TopTools_ListOfShape& images = removal.Modified(before.faces(face));
        const TopoDS_Shape& image = images.IsEmpty() ? before.faces(face) : images.First();
        if (const int number = after.faces.FindIndex(image); number > 0) {
            answer.faces.emplace_back(face, number);
        }
    }
    return packed(answer);
}

/// All edges and vertices of the shape but those of the faces.
TopTools_MapOfShape all_but(const GrowMessage& request, const occ::Numbering& before) {
    TopTools_IndexedMapOfShape theirs;
    for (const auto& [face, none] : request.faces) {
        TopExp::MapShapes(before.faces(face), TopAbs_EDGE, theirs);
        TopExp::MapShapes(before.faces(face), TopAbs_VERTEX, theirs);
    }
    TopTools_MapOfShape others;
    for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_VERTEX}) {
        for (TopExp_Explorer it(request.shape, kind); it.More(); it.Next()) {
            if (!theirs.Contains(it.Current())) {
                others.Add(it.Current());
            }
        }
    }
    return others;
}

Result<std::string> merge(const GrowMessage& request) {
    const occ::Numbering before(request.shape);
    ShapeUpgrade_UnifySameDomain unifier(request.shape, /*UnifyEdges=*/Standard_True,
                                         /*UnifyFaces=*/Standard_True,
                                         /*ConcatBSplines=*/Standard_False);
    unifier.KeepShapes(all_but(request, before));
    unifier.Build();
    GrowMessage answer{request.task, unifier.Shape(), {}};
    if (answer.shape.IsNull()) {
        return fail(ErrorCode::Refused, "OCCT's merging of faces gave nothing");
    }
    const occ::Numbering after(answer.shape);
    const auto history = unifier.History();
    for (int face = 1; face <= before.faces.Extent(); ++face) {
        const TopTools_ListOfShape& images = history->Modified(before.faces(face));
        const TopoDS_Shape& image = images.IsEmpty() ? before.faces(face) : images.First();
        if (const int number = after.faces.FindIndex(image); number > 0) {
            answer.faces.emplace_back(face, number);
        }
    }
    return packed(answer);
}

}  // namespace
}  // namespace suture

int main() {
    return suture::occ::serve("changing faces", [](const std::string& bytes) {
        const suture::GrowMessage request = suture::unpacked_grow_message(bytes);
        return request.task == suture::GrowTask::Merge ? suture::merge(request)
                                                       : suture::grow(request);
    });
}

// OCCT's removal of features, the only code that calls it: a program, because it can crash or hang.
#include "suture/edges/grow_request.h"
#include "suture/occ/isolate.h"
#include "suture/occ/topology.h"

#include <BRepAlgoAPI_Defeaturing.hxx>
#include <TopTools_ListOfShape.hxx>
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

}  // namespace
}  // namespace suture

int main() {
    return suture::occ::serve("letting neighbours grow", [](const std::string& request) {
        return suture::grow(suture::unpacked_grow_message(request));
    });
}

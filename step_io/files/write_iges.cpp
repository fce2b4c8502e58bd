#include "files/write_iges.h"

#include "files/iges_module.h"
#include "files/static_scope.h"
#include "files/write_time.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace suture::io {

namespace {

/// Whether faces are sewn together anywhere.
bool has_sewn_shell(const TopoDS_Shape& shape) {
    for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shell.Current(), TopAbs_FACE, faces);
        if (faces.Extent() > 1) {
            return true;
        }
    }
    return false;
}

}  // namespace

Result<void> write_iges(const ModelFile& model, const std::string& name, std::ostream& stream) {
    const Result<std::tm> time = time_of_writing();
    if (!time) {
        return tl::unexpected(time.error());
    }
    StaticScope scope;
    const IgesModule& iges = iges_module();
    scope.set("xstep.cascade.unit", "MM");
    scope.set("write.iges.unit", model.unit.c_str());
    scope.set("write.iges.brep.mode", has_sewn_shell(model.shape()) ? 1 : 0);
    scope.set("write.iges.header.product", name.c_str());
    scope.set("write.iges.header.receiver", "");
    scope.set("write.iges.header.author",
              model.origin.authors.empty() ? "" : model.origin.authors.front().c_str());
    scope.set("write.iges.header.company",
              model.origin.organizations.empty() ? "" : model.origin.organizations.front().c_str());
    if (model.precision > 0.0) {
        constexpr int kUseGivenValue = 2;
        scope.set("write.precision.mode", kUseGivenValue);
        scope.set("write.precision.val", model.precision);
    }
    switch (iges.write(model.document, iges_time(*time).c_str(), stream)) {
        case IgesOutcome::TransferFailed:
            return fail(ErrorCode::Internal, "OCCT cannot write the model as IGES{}{}",
                        scope.complaint().empty() ? "" : ": ", scope.complaint());
        case IgesOutcome::FileFailed:
            return fail(ErrorCode::WriteFailed, "OCCT could not print the IGES file");
        case IgesOutcome::Done:
            break;
    }
    return {};
}

}  // namespace suture::io

#include "files/new_model.h"

#include "files/document.h"
#include "files/join_bodies.h"
#include "files/static_scope.h"
#include "suture/occ/guard.h"

namespace suture::io {

Result<ModelFile> make_model(const TopoDS_Shape& shape, const std::string& name) {
    return occ::guarded("making a model", [&]() -> Result<ModelFile> {
        const StaticScope names_nothing;
        ModelFile model;
        model.document = make_document();
        shapes_of(model.document)->AddShape(shape, /*makeAssembly=*/Standard_False);
        name_parts(model.document, name);
        return model;
    });
}

}  // namespace suture::io

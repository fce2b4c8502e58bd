#include "files/read_iges.h"

#include "files/iges_module.h"
#include "files/iges_text.h"
#include "files/progress_indicator.h"
#include "files/static_scope.h"
#include "files/units.h"
#include "suture/platform/on_demand.h"

namespace suture::io {

namespace {

void take_over(const IgesGlobals& globals, ModelFile& model) {
    model.unit = unit_of_millimetres(globals.unit);
    model.precision = globals.resolution * globals.unit;
    if (!globals.author.empty()) {
        model.origin.authors.push_back(globals.author);
    }
    if (!globals.company.empty()) {
        model.origin.organizations.push_back(globals.company);
    }
}

}  // namespace

const IgesModule& iges_module() {
    static const auto* const module =
        static_cast<const IgesModule*>(symbol_on_demand("suture_iges.so", "suture_iges"));
    module->make_parameters();
    return *module;
}

Result<void> read_iges(ModelFile& model, std::string_view text, const std::filesystem::path& place,
                       const Progress& progress) {
    if (Result<void> whole = check_iges_text(text, model.path); !whole) {
        return whole;
    }
    StaticScope scope;
    const IgesModule& iges = iges_module();
    scope.set("xstep.cascade.unit", "MM");
    const auto indicator = occ::make<ProgressIndicator>(progress, std::string("read"), 0.0, 1.0);
    IgesGlobals globals;
    const IgesOutcome outcome =
        iges.read(place.c_str(), model.document, globals, indicator->Start());
    if (outcome == IgesOutcome::FileFailed) {
        return fail(ErrorCode::Unreadable, "{} is damaged: OCCT cannot read it{}{}",
                    model.path.string(), scope.complaint().empty() ? "" : ": ", scope.complaint());
    }
    take_over(globals, model);
    if (outcome == IgesOutcome::TransferFailed && !progress.cancelled()) {
        return fail(ErrorCode::Unreadable, "{} holds no shape that OCCT can read",
                    model.path.string());
    }
    model.merge_loose();
    return {};
}

}  // namespace suture::io

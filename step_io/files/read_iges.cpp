#include "files/read_iges.h"

#include "files/iges_text.h"
#include "files/progress_indicator.h"
#include "files/static_scope.h"
#include "files/units.h"

#include <IGESCAFControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <TCollection_HAsciiString.hxx>

namespace suture::io {

namespace {

void read_globals(const IGESData_GlobalSection& globals, ModelFile& model) {
    const double millimetres = globals.UnitValue();
    model.unit = unit_of_millimetres(millimetres);
    model.precision = globals.Resolution() * millimetres;
    if (!globals.AuthorName().IsNull()) {
        model.origin.authors.emplace_back(globals.AuthorName()->ToCString());
    }
    if (!globals.CompanyName().IsNull()) {
        model.origin.organizations.emplace_back(globals.CompanyName()->ToCString());
    }
}

}  // namespace

Result<void> read_iges(ModelFile& model, std::string_view text, const Progress& progress) {
    if (Result<void> whole = check_iges_text(text, model.path); !whole) {
        return whole;
    }
    StaticScope scope;
    scope.set("xstep.cascade.unit", "MM");
    IGESCAFControl_Reader reader;
    if (reader.ReadFile(model.path.c_str()) != IFSelect_RetDone) {
        return fail(ErrorCode::Unreadable, "{} is damaged: OCCT cannot read it{}{}",
                    model.path.string(), scope.complaint().empty() ? "" : ": ", scope.complaint());
    }
    read_globals(reader.IGESModel()->GlobalSection(), model);
    const auto indicator = occ::make<ProgressIndicator>(progress, std::string("read"), 0.0, 1.0);
    if (!reader.Transfer(model.document, indicator->Start()) && !progress.cancelled()) {
        return fail(ErrorCode::Unreadable, "{} holds no shape that OCCT can read",
                    model.path.string());
    }
    model.merge_loose();
    return {};
}

}  // namespace suture::io

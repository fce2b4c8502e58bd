#include "files/write_step.h"

#include "files/static_scope.h"
#include "files/step_order.h"
#include "files/step_text.h"
#include "files/units.h"
#include "files/write_time.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPConstruct.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include <sstream>

namespace suture::io {

namespace {

occ::Handle<TCollection_HAsciiString> to_occ(const std::string& text) {
    return occ::make<TCollection_HAsciiString>(text.c_str());
}

/// STEP has no empty list here: at least one empty string.
occ::Handle<Interface_HArray1OfHAsciiString> to_occ(const std::vector<std::string>& texts) {
    const int count = std::max<int>(1, static_cast<int>(texts.size()));
    auto array = occ::make<Interface_HArray1OfHAsciiString>(1, count);
    for (int i = 1; i <= count; ++i) {
        array->SetValue(i, to_occ(texts.empty() ? "" : texts[static_cast<std::size_t>(i) - 1]));
    }
    return array;
}

const char* occt_schema(const std::string& schema) {
    return schema == "AP203" ? "AP203" : schema == "AP242" ? "AP242DIS" : "AP214IS";
}

void write_header(const ModelFile& model, const std::string& name, const std::tm& time,
                  const occ::Handle<StepData_StepModel>& entities) {
    APIHeaderSection_MakeHeader header(entities);
    header.SetName(to_occ(name));
    header.SetTimeStamp(to_occ(step_time(time)));
    header.SetOriginatingSystem(to_occ("Suture " SUTURE_VERSION));
    header.SetAuthor(to_occ(model.origin.authors));
    header.SetOrganization(to_occ(model.origin.organizations));
    header.SetAuthorisation(to_occ(model.origin.authorisation));
    if (!model.origin.description.empty()) {
        header.SetDescription(to_occ(model.origin.description));
    }
}

/// 0 for a face that OCCT has lost sight of.
StepId entity_of(const TopoDS_Face& face, const XSControl_WorkSession& session,
                 const StepData_StepModel& entities) {
    const auto entity = STEPConstruct::FindEntity(session.TransferWriter()->FinderProcess(), face);
    return entity.IsNull() ? 0 : static_cast<StepId>(entities.Number(entity));
}

}  // namespace

Result<std::vector<StepId>> write_step(const ModelFile& model, const std::string& name,
                                       std::span<const TopoDS_Face> traced, std::ostream& stream) {
    const Result<std::tm> time = time_of_writing();
    if (!time) {
        return tl::unexpected(time.error());
    }
    StaticScope scope;
    scope.set("write.step.schema", occt_schema(model.schema));  // before there is a writer
    scope.set("write.step.unit", model.unit.c_str());
    scope.set("xstep.cascade.unit", "MM");
    scope.set("write.stepcaf.subshapes.name", 1);
    scope.set("write.step.product.name", name.c_str());
    if (model.precision > 0.0) {
        constexpr int kUseGivenValue = 2;
        scope.set("write.precision.mode", kUseGivenValue);
        scope.set("write.precision.val", model.precision);
    }
    STEPCAFControl_Writer writer;
    writer.SetSHUOMode(true);
    writer.SetDimTolMode(false);
    writer.SetPropsMode(false);
    writer.SetMaterialMode(true);
    // OCCT 7.8 names the unit of "write.step.unit" and writes millimetres: 7.6 takes both from it.
    writer.ChangeWriter().Model()->SetWriteLengthUnit(millimetres_of_unit(model.unit));
    if (!writer.Transfer(model.document, STEPControl_AsIs)) {
        return fail(ErrorCode::Internal, "OCCT cannot write the model as STEP{}{}",
                    scope.complaint().empty() ? "" : ": ", scope.complaint());
    }
    const occ::Handle<StepData_StepModel> entities = writer.ChangeWriter().Model();
    count_instances(*entities);
    write_header(model, name, *time, entities);
    StepData_StepWriter text(entities);
    text.SendModel(occ::cast<StepData_Protocol>(writer.ChangeWriter().WS()->Protocol()));
    std::ostringstream printed;
    text.Print(printed);
    const NumberedText ordered = in_fixed_order(encode_step_text(printed.str()));
    stream << ordered.text;
    std::vector<StepId> numbers;
    for (const TopoDS_Face& face : traced) {
        const StepId number = entity_of(face, *writer.ChangeWriter().WS(), *entities);
        numbers.push_back(ordered.numbers[number]);
    }
    return numbers;
}

}  // namespace suture::io

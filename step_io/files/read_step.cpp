#include "files/read_step.h"

#include "files/external_files.h"
#include "files/format.h"
#include "files/progress_indicator.h"
#include "files/static_scope.h"
#include "files/step_text.h"
#include "files/units.h"
#include "suture/base/text.h"
#include "suture/occ/step_units.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepRepr_GlobalUncertaintyAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <TCollection_HAsciiString.hxx>

#include <optional>
#include <regex>
#include <sstream>

namespace suture::io {

namespace {

std::string text_of(const occ::Handle<TCollection_HAsciiString>& text) {
    return text.IsNull() ? std::string() : std::string(text->ToCString());
}

std::string schema_of(const APIHeaderSection_MakeHeader& header) {
    for (int i = 1; header.HasFs() && i <= header.NbSchemaIdentifiers(); ++i) {
        const std::string schema = text_of(header.SchemaIdentifiersValue(i));
        if (schema.find("CONFIG_CONTROL_DESIGN") != schema.npos ||
            schema.find("AP203") != schema.npos) {
            return "AP203";
        }
        if (schema.find("AP242") != schema.npos) {
            return "AP242";
        }
    }
    return "AP214";
}

Origin origin_of(const APIHeaderSection_MakeHeader& header) {
    Origin origin;
    for (int i = 1; header.HasFd() && i <= header.NbDescription(); ++i) {
        origin.description.push_back(text_of(header.DescriptionValue(i)));
    }
    for (int i = 1; header.HasFn() && i <= header.NbAuthor(); ++i) {
        origin.authors.push_back(text_of(header.AuthorValue(i)));
    }
    for (int i = 1; header.HasFn() && i <= header.NbOrganization(); ++i) {
        origin.organizations.push_back(text_of(header.OrganizationValue(i)));
    }
    if (header.HasFn()) {
        origin.authorisation = text_of(header.Authorisation());
    }
    return origin;
}

/// Unit and accuracy of the first representation context that states a length unit.
void read_context(const Interface_InterfaceModel& entities, ModelFile& model) {
    using Context = StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx;
    for (int i = 1; i <= entities.NbEntities(); ++i) {
        const auto context = occ::cast<Context>(entities.Value(i));
        if (context.IsNull()) {
            continue;
        }
        STEPConstruct_UnitContext units;
        occ::compute_factors(units, context->GlobalUnitAssignedContext());
        if (!units.LengthDone()) {
            continue;
        }
        model.unit = unit_of_millimetres(units.LengthFactor());
        units.ComputeTolerance(context->GlobalUncertaintyAssignedContext());
        model.precision = units.HasUncertainty() ? units.Uncertainty() * units.LengthFactor() : 0.0;
        return;
    }
}

/// OCCT's scanner takes a byte-order mark for a word of the file's, and has no room for long texts.
/// OCCT 7.8 finds no STEP file whose name is not UTF-8.
IFSelect_ReturnStatus read_entities(STEPCAFControl_Reader& reader, ModelFile& model,
                                    std::string_view text, bool from_text) {
    const std::optional<ShorterStep> shorter = with_short_texts(text);
    const bool named = valid_utf8(model.path.native()) == model.path.native();
    if (!shorter && !from_text && named && !text.starts_with(kByteOrderMark)) {
        return reader.ReadFile(model.path.c_str());
    }
    if (shorter) {
        text = shorter->text;
        model.notes.push_back(
            fmt::format("{} text{} of more than {} characters {} cut, the first at entity #{}",
                        shorter->cut, shorter->cut == 1 ? "" : "s", kLongestStepText,
                        shorter->cut == 1 ? "is" : "are", shorter->first));
    }
    if (text.starts_with(kByteOrderMark)) {
        text.remove_prefix(kByteOrderMark.size());
    }
    std::istringstream stream{std::string(text)};
    return reader.ChangeReader().ReadStream(model.path.c_str(), stream);
}

/// What OCCT complains of, without the address in memory and the file's name that it may have.
std::string reason_of(const std::string& complaint) {
    static const std::regex noise(
        "[ .]*Exception Raised while reading Step File : '[^']*': |"
        "0x[0-9a-fA-F]+ : |[ .]+$");
    const std::string reason = std::regex_replace(complaint, noise, "");
    return reason.empty() ? "" : ": " + reason;
}

Result<void> transfer_error(const ModelFile& model) {
    if (!model.missing_files.empty()) {
        return {};  // read_model says which
    }
    return fail(ErrorCode::Unreadable, "{} holds no shape that OCCT can read", model.path.string());
}

}  // namespace

Result<void> read_step(ModelFile& model, std::string_view text, const Progress& progress,
                       const StepReading& options) {
    if (Result<void> whole = check_step_text(text, model.path); !whole) {
        return whole;
    }
    StaticScope scope;
    scope.set("xstep.cascade.unit", "MM");
    scope.set("read.stepcaf.subshapes.name", options.face_names ? 1 : 0);
    if (!options.face_names) {
        model.notes.emplace_back(
            "the names of faces are lost: OCCT's reader crashes on this file with them");
    }
    STEPCAFControl_Reader reader;
    reader.SetSHUOMode(true);    // colours of single instances
    reader.SetGDTMode(false);    // what the writer would not write again
    reader.SetPropsMode(false);  // volumes and centroids, wrong after a fill
    reader.SetViewMode(false);
    if (read_entities(reader, model, text, options.from_text) != IFSelect_RetDone) {
        return fail(ErrorCode::Unreadable, "{} is damaged: OCCT cannot read it{}",
                    model.path.string(), reason_of(scope.complaint()));
    }
    const auto entities = occ::cast<StepData_StepModel>(reader.Reader().Model());
    const APIHeaderSection_MakeHeader header(entities);
    model.schema = schema_of(header);
    model.origin = origin_of(header);
    read_context(*entities, model);
    model.missing_files = close_external_files(*entities, model.path, options.external_files);

    constexpr double kParsed = 0.25;  // of the time, on the files measured
    const auto indicator =
        occ::make<ProgressIndicator>(progress, std::string("read"), kParsed, 1.0);
    const bool transferred = reader.Transfer(model.document, indicator->Start());
    return transferred || progress.cancelled() ? Result<void>() : transfer_error(model);
}

}  // namespace suture::io

#include "files/iges_module.h"

#include <IGESCAFControl_Reader.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <TCollection_HAsciiString.hxx>

namespace suture::io {

namespace {

std::string text_of(const occ::Handle<TCollection_HAsciiString>& text) {
    return text.IsNull() ? std::string() : std::string(text->ToCString());
}

void make_parameters() {
    IGESControl_Controller::Init();
}

IgesOutcome read(const char* file, const Document& document, IgesGlobals& globals,
                 const Message_ProgressRange& progress) {
    IGESCAFControl_Reader reader;
    if (reader.ReadFile(file) != IFSelect_RetDone) {
        return IgesOutcome::FileFailed;
    }
    const IGESData_GlobalSection& section = reader.IGESModel()->GlobalSection();
    globals.unit = section.UnitValue();
    globals.resolution = section.Resolution();
    globals.author = text_of(section.AuthorName());
    globals.company = text_of(section.CompanyName());
    Document target = document;
    return reader.Transfer(target, progress) ? IgesOutcome::Done : IgesOutcome::TransferFailed;
}

IgesOutcome write(const Document& document, const char* time, std::ostream& stream) {
    IGESCAFControl_Writer writer;
    if (!writer.Transfer(document)) {
        return IgesOutcome::TransferFailed;
    }
    writer.ComputeModel();
    IGESData_GlobalSection globals = writer.Model()->GlobalSection();
    const auto stamp = occ::make<TCollection_HAsciiString>(time);
    globals.SetDate(stamp);
    globals.SetLastChangeDate(stamp);
    writer.Model()->SetGlobalSection(globals);
    return writer.Write(stream) ? IgesOutcome::Done : IgesOutcome::FileFailed;
}

}  // namespace

}  // namespace suture::io

extern "C" {
/// What iges_module() looks for.
extern const suture::io::IgesModule suture_iges;
const suture::io::IgesModule suture_iges{suture::io::make_parameters, suture::io::read,
                                         suture::io::write};
}

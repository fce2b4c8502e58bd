#include "files/iges_module.h"

#include <IGESCAFControl_Reader.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_ColorEntity.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_EntityIterator.hxx>
#include <TCollection_HAsciiString.hxx>

#include <set>
#include <vector>

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

/// Colours and properties, as names are, in the order in which entities need them: OCCT has them in
/// the order of addresses.
void fix_order(IGESData_IGESModel& model) {
    constexpr int kColour = 314;
    constexpr int kProperty = 406;
    using Entity = occ::Handle<IGESData_IGESEntity>;
    std::vector<Entity> order;
    std::vector<Entity> others;
    for (int i = 1; i <= model.NbEntities(); ++i) {
        const Entity entity = model.Entity(i);
        const int type = entity->TypeNumber();
        (type == kColour || type == kProperty ? others : order).push_back(entity);
    }
    std::set<const IGESData_IGESEntity*> seen;
    const auto add = [&](const Entity& entity) {
        if (!entity.IsNull() && model.Number(entity) > 0 && seen.insert(entity.get()).second) {
            order.push_back(entity);
        }
    };
    const std::size_t count = order.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Entity entity = order[i];
        Interface_EntityIterator properties = entity->Properties();
        for (properties.Start(); properties.More(); properties.Next()) {
            add(occ::cast<IGESData_IGESEntity>(properties.Value()));
        }
        add(entity->Color());
    }
    for (const Entity& entity : others) {
        add(entity);
    }
    model.ClearEntities();
    for (const Entity& entity : order) {
        model.AddEntity(entity);
    }
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
    fix_order(*writer.Model());
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

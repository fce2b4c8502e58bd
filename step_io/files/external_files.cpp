#include "files/external_files.h"

#include "suture/occ/handle.h"

#include <fmt/format.h>

#include <STEPControl_Reader.hxx>
#include <StepAP214_AppliedExternalIdentificationAssignment.hxx>
#include <StepBasic_DocumentFile.hxx>
#include <StepBasic_ExternalSource.hxx>
#include <StepBasic_SourceItem.hxx>
#include <StepData_SelectMember.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <functional>
#include <set>
#include <system_error>

namespace suture::io {
namespace {

namespace fs = std::filesystem;

using Text = occ::Handle<TCollection_HAsciiString>;

std::string text_of(const Text& text) {
    return text.IsNull() ? std::string() : std::string(text->ToCString());
}

/// Whether `path` lies in `folder` or below it; both canonical.
bool is_below(const fs::path& path, const fs::path& folder) {
    const auto [end, ignored] =
        std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end();
}

/// A name of another file that an entity holds, and how to take it away: OCCT skips a document
/// without a name.
struct Name {
    std::string text;
    std::function<void()> clear;
};

std::vector<Name> names_of(const occ::Handle<Standard_Transient>& entity) {
    std::vector<Name> names;
    const auto add = [&](const Text& text) {
        names.push_back({text_of(text), [text] { text->Clear(); }});
    };
    if (const auto document = occ::cast<StepBasic_DocumentFile>(entity); !document.IsNull()) {
        add(document->Id());
    }
    const auto assignment = occ::cast<StepAP214_AppliedExternalIdentificationAssignment>(entity);
    if (!assignment.IsNull()) {
        add(assignment->AssignedId());
    }
    if (const auto source = occ::cast<StepBasic_ExternalSource>(entity); !source.IsNull()) {
        const occ::Handle<Standard_Transient> value = source->SourceId().Value();
        if (const auto named = occ::cast<StepData_SelectMember>(value); !named.IsNull()) {
            names.push_back({named->String(), [named] { named->SetString(""); }});
        }
        add(occ::cast<TCollection_HAsciiString>(value));
    }
    std::erase_if(names, [](const Name& name) { return name.text.empty(); });
    return names;
}

/// Says of every name in a file and in the files that these names lead to whether it may be read.
class ExternalFiles {
  public:
    ExternalFiles(const fs::path& file, bool allowed) : allowed_(allowed) {
        std::error_code error;
        folder_ = fs::canonical(fs::absolute(file, error).parent_path(), error);
        seen_.insert(fs::weakly_canonical(file, error));
    }

    /// Empty if it may; else the names that may not, as a user wants to read them.
    std::vector<std::string> refused(const std::string& name) {
        std::error_code error;
        const fs::path path = fs::weakly_canonical(folder_ / name, error);
        if (!allowed_) {
            return {fmt::format("{} (--external-references no)", name)};
        }
        if (error || !is_below(path, folder_)) {
            return {fmt::format("{} (not in the folder of the file)", name)};
        }
        if (!fs::exists(path, error)) {
            return {name};
        }
        if (!fs::is_regular_file(path, error)) {
            return {fmt::format("{} (no ordinary file)", name)};
        }
        return seen_.insert(path).second ? refused_within(path) : std::vector<std::string>();
    }

  private:
    std::vector<std::string> refused_within(const fs::path& path) {
        STEPControl_Reader reader;
        std::vector<std::string> result;
        if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
            return {fmt::format("{} (damaged)", path.filename().string())};
        }
        const auto entities = reader.WS()->Model();
        for (int i = 1; i <= entities->NbEntities(); ++i) {
            for (const Name& name : names_of(entities->Value(i))) {
                const std::vector<std::string> inner = refused(name.text);
                result.insert(result.end(), inner.begin(), inner.end());
            }
        }
        return result;
    }

  private:
    bool allowed_;
    fs::path folder_;
    std::set<fs::path> seen_;
};

}  // namespace

std::vector<std::string> close_external_files(const Interface_InterfaceModel& entities,
                                              const std::filesystem::path& file, bool allowed) {
    ExternalFiles files(file, allowed);
    std::set<std::string> closed;  // names
    std::set<std::string> told;
    std::set<std::string> open;
    for (int i = 1; i <= entities.NbEntities(); ++i) {
        const occ::Handle<Standard_Transient> entity = entities.Value(i);
        for (const auto& [name, clear] : names_of(entity)) {
            if (open.contains(name)) {
                continue;
            }
            if (!closed.contains(name)) {
                const std::vector<std::string> refused = files.refused(name);
                if (refused.empty()) {
                    open.insert(name);
                    continue;
                }
                closed.insert(name);
                told.insert(refused.begin(), refused.end());
            }
            clear();
        }
    }
    return {told.begin(), told.end()};
}

}  // namespace suture::io

#include "files/losses.h"

#include "files/document.h"
#include "files/look.h"

#include <fmt/format.h>

#include <set>
#include <string_view>

namespace suture::io {

namespace {

/// What stands in an assembly tree.
struct Contents {
    int assemblies = 0;
    std::set<std::string> names;  ///< of assemblies, parts and instances
    bool looks = false;           ///< colours or layers of anything
};

class Counter {
  public:
    explicit Counter(const Document& document) : looks_(document) {
        for (const TDF_Label& root : roots_of(document)) {
            visit(root);
        }
    }

    [[nodiscard]] const Contents& contents() const { return contents_; }

  private:
    void visit(const TDF_Label& label) {
        const TDF_Label target = referred(label);
        take(label);
        take(target);
        if (XCAFDoc_ShapeTool::IsAssembly(target)) {
            ++contents_.assemblies;
            for (const TDF_Label& component : components_of(target)) {
                visit(component);
            }
            return;
        }
        for (const TDF_Label& sub : sub_shapes_of(target)) {
            contents_.looks = contents_.looks || has_look(sub);
        }
    }

    void take(const TDF_Label& label) {
        if (std::string name = name_of(label); !name.empty()) {
            contents_.names.insert(std::move(name));
        }
        contents_.looks = contents_.looks || has_look(label);
    }

    [[nodiscard]] bool has_look(const TDF_Label& label) const {
        Look look = looks_.of(label, {});
        look.name.clear();
        return !look.empty();
    }

    Looks looks_;
    Contents contents_;
};

bool is_brep(Format format) {
    return format == Format::BrepText || format == Format::BrepBinary ||
           format == Format::BrepFreecad;
}

}  // namespace

std::vector<std::string> lost_in(const ModelFile& model, Format format) {
    if (format != Format::Iges && !is_brep(format)) {
        return {};
    }
    const std::string_view name = format == Format::Iges ? "IGES" : "BREP";
    const Contents contents = Counter(model.document).contents();
    std::vector<std::string> losses;
    if (contents.assemblies > 0) {
        losses.push_back(
            fmt::format("{} has no assembly tree: all parts become one model, and {} names of "
                        "assemblies, parts "
                        "and instances are lost",
                        name, contents.names.size()));
    }
    if (is_brep(format) && contents.looks) {
        losses.push_back(fmt::format("{} has no colours and layers: they are lost", name));
    }
    return losses;
}

}  // namespace suture::io

#include "files/freecad_document.h"

#include "files/brep.h"
#include "files/document.h"
#include "files/packed.h"
#include "files/rigid.h"
#include "files/static_scope.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <fmt/format.h>

#include <gp_Quaternion.hxx>

#include <map>
#include <set>
#include <sstream>

namespace suture::io {

namespace {

using Tree = boost::property_tree::ptree;

/// An object of the document, as far as it matters here.
struct FreecadObject {
    std::string name;
    std::string type;
    std::string label;
    std::string shape_file;  ///< empty: no shape
    std::vector<std::string> group;
    gp_Trsf placement;
    bool visible = true;
};

gp_Trsf to_transformation(const Tree& attributes) {
    const auto number = [&](const char* key) { return attributes.get<double>(key); };
    gp_Trsf result;
    result.SetTransformation(gp_Quaternion(number("Q0"), number("Q1"), number("Q2"), number("Q3")),
                             gp_Vec(number("Px"), number("Py"), number("Pz")));
    return result;
}

void take_property(const std::string& name, const Tree& property, FreecadObject& object) {
    if (name == "Label") {
        object.label = property.get("String.<xmlattr>.value", "");
    } else if (name == "Visibility") {
        object.visible = property.get("Bool.<xmlattr>.value", "true") == "true";
    } else if (name == "Shape") {
        object.shape_file = property.get("Part.<xmlattr>.file", "");
    } else if (const auto place = property.get_child_optional("PropertyPlacement.<xmlattr>");
               name == "Placement" && place) {
        object.placement = to_transformation(*place);
    } else if (const auto list = property.get_child_optional("LinkList"); name == "Group" && list) {
        for (const auto& [key, link] : *list) {
            if (key == "Link") {
                object.group.push_back(link.get("<xmlattr>.value", ""));
            }
        }
    }
}

/// All objects, in the document's order.
std::vector<FreecadObject> parse_objects(const std::string& xml) {
    Tree tree;
    std::istringstream stream(xml);
    boost::property_tree::read_xml(stream, tree);
    std::map<std::string, std::string> types;
    for (const auto& [key, object] : tree.get_child("Document.Objects")) {
        if (key == "Object") {
            types[object.get<std::string>("<xmlattr>.name")] = object.get("<xmlattr>.type", "");
        }
    }
    std::vector<FreecadObject> objects;
    for (const auto& [key, data] : tree.get_child("Document.ObjectData")) {
        if (key != "Object") {
            continue;
        }
        FreecadObject& object = objects.emplace_back();
        object.name = data.get<std::string>("<xmlattr>.name");
        object.type = types[object.name];
        for (const auto& [kind, property] : data.get_child("Properties")) {
            if (kind == "Property") {
                take_property(property.get("<xmlattr>.name", ""), property, object);
            }
        }
    }
    return objects;
}

class FreecadReader {
  public:
    FreecadReader(ModelFile& model, const std::string& archive, std::vector<FreecadObject> objects)
        : model_(model), archive_(archive), objects_(std::move(objects)) {
        for (const FreecadObject& object : objects_) {
            by_name_[object.name] = &object;
            inner_.insert(object.group.begin(), object.group.end());
        }
    }

    Result<void> read() {
        for (const FreecadObject& object : objects_) {
            if (inner_.contains(object.name)) {
                continue;
            }
            if (Result<void> done = add(object, {}, 0); !done) {
                return done;
            }
        }
        if (links_ > 0) {
            model_.notes.push_back(fmt::format(
                "links to other objects are left out ({}): export STEP from FreeCAD to keep them",
                links_));
        }
        return {};
    }

  private:
    /// outer: where the container of the object stands
    Result<void> add(const FreecadObject& object, const gp_Trsf& outer, int depth) {
        constexpr int kDeepest = 100;  // groups within groups; a ring of them is a damaged file
        if (!object.visible || depth > kDeepest) {
            return {};
        }
        if (object.type == "App::Link" || object.type.starts_with("App::LinkElement")) {
            ++links_;
            return {};
        }
        if (!object.shape_file.empty()) {
            return add_shape(object, outer);
        }
        const gp_Trsf inner = object.type == "App::Part" ? outer * object.placement : outer;
        for (const std::string& name : object.group) {
            const auto found = by_name_.find(name);
            if (found == by_name_.end()) {
                continue;
            }
            if (Result<void> done = add(*found->second, inner, depth + 1); !done) {
                return done;
            }
        }
        return {};
    }

    Result<void> add_shape(const FreecadObject& object, const gp_Trsf& outer) {
        if (object.type.starts_with("PartDesign::Plane")) {
            return {};  // a help for drawing
        }
        const Result<std::string> bytes = unpack_entry(archive_, object.shape_file, model_.path);
        if (!bytes) {
            return tl::unexpected(bytes.error());
        }
        const Result<TopoDS_Shape> shape = bytes->starts_with("Open CASCADE")
                                               ? read_brep_binary(*bytes, model_.path)
                                               : read_brep_text(*bytes, model_.path);
        if (!shape) {
            return fail(ErrorCode::Unreadable, "{} (object {})", shape.error().message,
                        object.label);
        }
        if (has_face(*shape)) {
            const StaticScope names_nothing;
            const TopoDS_Shape placed = with_rigid_placements(*shape).Moved(outer);
            // A shape with a place becomes a part and an instance of it; both have the name.
            const TDF_Label label = shapes_of(model_.document)->AddShape(placed, false);
            set_name(label, object.label);
            set_name(referred(label), object.label);
        }
        return {};
    }

    ModelFile& model_;
    const std::string& archive_;
    std::vector<FreecadObject> objects_;
    std::map<std::string, const FreecadObject*> by_name_;
    std::set<std::string> inner_;  ///< stand in a group, a part or a body
    int links_ = 0;
};

}  // namespace

Result<void> read_freecad_document(ModelFile& model, const std::string& archive) {
    const Result<std::string> xml = unpack_entry(archive, "Document.xml", model.path);
    if (!xml) {
        return tl::unexpected(xml.error());
    }
    try {
        return FreecadReader(model, archive, parse_objects(*xml)).read();
    } catch (const boost::property_tree::ptree_error& error) {
        return fail(ErrorCode::Unreadable, "{}: FreeCAD's Document.xml in it is damaged: {}",
                    model.path.string(), error.what());
    }
}

}  // namespace suture::io

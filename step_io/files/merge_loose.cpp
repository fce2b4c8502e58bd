#include "files/document.h"
#include "files/look.h"
#include "files/model_file.h"

#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <functional>
#include <map>

namespace suture::io {

namespace {

/// Whether there is no solid and no shell of two faces or more.
bool is_loose(const TopoDS_Shape& shape) {
    if (!has_face(shape) || TopExp_Explorer(shape, TopAbs_SOLID).More()) {
        return false;
    }
    for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shell.Current(), TopAbs_FACE, faces);
        if (faces.Extent() > 1) {
            return false;
        }
    }
    return true;
}

/// Collects some of the shapes of a model, each where it stands, and the looks of their faces.
class Gathering {
  public:
    /// Input  wanted: of a part's shape and the place where it stands, whether it is taken.
    Gathering(const Document& document,
              std::function<bool(const TopoDS_Shape&, const TopLoc_Location&)> wanted)
        : looks_(document), wanted_(std::move(wanted)) {
        for (const TDF_Label& root : roots_of(document)) {
            visit(root, TopLoc_Location());
        }
    }

    [[nodiscard]] const TopTools_IndexedMapOfShape& faces() const { return faces_; }
    [[nodiscard]] const std::vector<TopoDS_Shape>& shapes() const { return shapes_; }
    [[nodiscard]] const Look& look(int face) const { return face_looks_.at(face); }
    /// The parts and components that they were taken from.
    [[nodiscard]] const std::vector<TDF_Label>& occurrences() const { return occurrences_; }

  private:
    void visit(const TDF_Label& label, const TopLoc_Location& above) {
        const TDF_Label target = referred(label);
        const TopLoc_Location location = above * XCAFDoc_ShapeTool::GetLocation(label);
        if (XCAFDoc_ShapeTool::IsAssembly(target)) {
            for (const TDF_Label& component : components_of(target)) {
                visit(component, location);
            }
        } else if (const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(target);
                   wanted_(shape, location)) {
            if (std::ranges::find(occurrences_, label) == occurrences_.end()) {
                occurrences_.push_back(label);
            }
            Look look = looks_.of(label, looks_.of(target, {}));
            look.name = name_of(target);  // not the instance's
            shapes_.push_back(shape.Moved(location));
            take(target, shape, location, look);
        }
    }

    void take(const TDF_Label& part, const TopoDS_Shape& shape, const TopLoc_Location& location,
              const Look& look) {
        std::map<int, Look> own;  // by the part's own face numbers
        TopTools_IndexedMapOfShape part_faces;
        TopExp::MapShapes(shape, TopAbs_FACE, part_faces);
        for (const TDF_Label& sub_label : sub_shapes_of(part)) {
            TopTools_IndexedMapOfShape sub_faces;
            TopExp::MapShapes(XCAFDoc_ShapeTool::GetShape(sub_label), TopAbs_FACE, sub_faces);
            for (int i = 1; i <= sub_faces.Extent(); ++i) {
                const int number = part_faces.FindIndex(sub_faces(i));
                own[number] = looks_.of(sub_label, own.contains(number) ? own[number] : look);
            }
        }
        for (int i = 1; i <= part_faces.Extent(); ++i) {
            const int number = faces_.Add(part_faces(i).Moved(location));
            face_looks_.try_emplace(number, own.contains(i) ? own[i] : look);
        }
    }

    Looks looks_;
    std::function<bool(const TopoDS_Shape&, const TopLoc_Location&)> wanted_;
    std::vector<TopoDS_Shape> shapes_;
    TopTools_IndexedMapOfShape faces_;
    std::map<int, Look> face_looks_;
    std::vector<TDF_Label> occurrences_;
};

/// Takes a component or a root out of the model, and assemblies that are empty then.
void remove(const Document& document, const TDF_Label& occurrence) {
    const occ::Handle<XCAFDoc_ShapeTool> tool = shapes_of(document);
    const TDF_Label target = referred(occurrence);
    if (XCAFDoc_ShapeTool::IsComponent(occurrence)) {
        const TDF_Label assembly = occurrence.Father();
        tool->RemoveComponent(occurrence);
        if (components_of(assembly).empty()) {
            TDF_LabelSequence users;
            XCAFDoc_ShapeTool::GetUsers(assembly, users);
            for (const TDF_Label& user : users) {
                remove(document, user);
            }
            tool->RemoveShape(assembly);
        }
    } else {
        tool->RemoveShape(occurrence);
    }
    if (target != occurrence && XCAFDoc_ShapeTool::IsFree(target)) {
        tool->RemoveShape(target);
    }
}

/// Makes one part of what was gathered, in the place of all that it was taken from.
TDF_Label make_part(const ModelFile& model, const Gathering& gathered, const TopoDS_Shape& all) {
    const std::vector<TDF_Label> roots = roots_of(model.document);
    const std::string name = roots.size() == 1 ? name_of(roots.front()) : std::string();
    for (const TDF_Label& occurrence : gathered.occurrences()) {
        remove(model.document, occurrence);
    }
    const occ::Handle<XCAFDoc_ShapeTool> tool = shapes_of(model.document);
    const TDF_Label part = tool->AddShape(all, false);
    set_name(part, name.empty() ? model.path.stem().string() : name);
    const Looks looks(model.document);
    for (int i = 1; i <= gathered.faces().Extent(); ++i) {
        looks.set(tool->AddSubShape(part, gathered.faces()(i)), gathered.look(i));
    }
    tool->UpdateAssemblies();
    return part;
}

}  // namespace

void ModelFile::merge_loose() {
    const Gathering loose(document, [](const TopoDS_Shape& shape, const TopLoc_Location&) {
        return is_loose(shape);
    });
    if (loose.occurrences().size() < 2) {
        return;
    }
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (int i = 1; i <= loose.faces().Extent(); ++i) {
        builder.Add(all, loose.faces()(i));
    }
    make_part(*this, loose, all);
}

void ModelFile::unite(const TopTools_IndexedMapOfShape& edges) {
    TopTools_IndexedMapOfShape open = edges;  // those that no part has been found for
    const Gathering holders(document,
                            [&](const TopoDS_Shape& shape, const TopLoc_Location& location) {
                                TopTools_IndexedMapOfShape own;
                                TopExp::MapShapes(shape.Moved(location), TopAbs_EDGE, own);
                                bool holds = false;
                                for (int i = 1; i <= own.Extent(); ++i) {
                                    holds = open.RemoveKey(own(i)) || holds;
                                }
                                return holds;
                            });
    const bool one_part = holders.shapes().size() == 1 && has_face(holders.shapes().front());
    if (holders.shapes().empty() || one_part) {
        return;
    }
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const TopoDS_Shape& shape : holders.shapes()) {
        builder.Add(all, shape);
    }
    united = make_part(*this, holders, all);
}

}  // namespace suture::io

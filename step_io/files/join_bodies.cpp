#include "files/join_bodies.h"

#include "files/look.h"

#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <TDataStd_Name.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <XCAFDoc.hxx>

#include <utility>
#include <vector>

namespace suture::io {

namespace {

/// Products and their instances have a name, if only an empty one.
bool has_name(const TDF_Label& label) {
    return label.IsAttribute(TDataStd_Name::GetID());
}

bool is_body(const TDF_Label& component) {
    const TDF_Label target = referred(component);
    return !has_name(component) && !has_name(target) &&
           XCAFDoc_ShapeTool::GetLocation(component).IsIdentity() &&
           !XCAFDoc_ShapeTool::IsAssembly(target);
}

/// Loose faces that the file keeps together, a geometric set: they are sewn by themselves first.
bool is_group_of_faces(const TopoDS_Shape& shape) {
    if (shape.ShapeType() != TopAbs_COMPOUND || shape.NbChildren() < 2) {
        return false;
    }
    bool faces = true;
    for (TopoDS_Iterator child(shape); child.More(); child.Next()) {
        faces = faces && child.Value().ShapeType() == TopAbs_FACE;
    }
    return faces;
}

/// The bodies of one product with everything that stands at their labels.
struct Bodies {
    std::vector<TopoDS_Shape> shapes;
    std::vector<std::pair<TopoDS_Shape, Look>> looks;

    void add(const TDF_Label& component, const Looks& document_looks) {
        const TDF_Label target = referred(component);
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(target);
        const Look look = document_looks.of(component, document_looks.of(target, {}));
        if (is_group_of_faces(shape)) {
            shapes.push_back(shape);
            for (TopoDS_Iterator face(shape); face.More(); face.Next()) {
                looks.emplace_back(face.Value(), look);
            }
        } else if (shape.ShapeType() == TopAbs_COMPOUND) {
            for (TopoDS_Iterator body(shape); body.More(); body.Next()) {
                add(body.Value(), look);
            }
        } else {
            add(shape, look);
        }
        for (const TDF_Label& sub : sub_shapes_of(target)) {
            looks.emplace_back(XCAFDoc_ShapeTool::GetShape(sub), document_looks.of(sub, {}));
        }
    }
    void add(const TopoDS_Shape& body, const Look& look) {
        shapes.push_back(body);
        looks.emplace_back(body, look);
    }
};

void join(const Document& document, const TDF_Label& product) {
    const occ::Handle<XCAFDoc_ShapeTool> tool = shapes_of(document);
    const Looks document_looks(document);
    Bodies bodies;
    for (const TDF_Label& component : components_of(product)) {
        bodies.add(component, document_looks);
    }
    for (const TDF_Label& component : components_of(product)) {
        const TDF_Label target = referred(component);
        tool->RemoveComponent(component);
        if (XCAFDoc_ShapeTool::IsFree(target)) {
            tool->RemoveShape(target);
        }
    }
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const TopoDS_Shape& shape : bodies.shapes) {
        builder.Add(all, shape);
    }
    product.ForgetAttribute(XCAFDoc::AssemblyGUID());
    tool->SetShape(product, all);
    for (const auto& [shape, look] : bodies.looks) {
        if (!look.empty()) {
            document_looks.set(tool->AddSubShape(product, shape), look);
        }
    }
}

/// Whether something below was joined.
bool join_below(const Document& document, const TDF_Label& label) {
    const TDF_Label target = referred(label);
    const std::vector<TDF_Label> components = components_of(target);
    if (components.empty()) {
        return false;
    }
    bool joined = false;
    bool all_bodies = true;
    for (const TDF_Label& component : components) {
        joined = join_below(document, component) || joined;
        all_bodies = all_bodies && is_body(component);
    }
    if (all_bodies) {
        join(document, target);
    }
    return joined || all_bodies;
}

void name_below(const TDF_Label& label, const std::string& name) {
    const TDF_Label target = referred(label);
    if (name_of(target).empty()) {
        set_name(target, name);
    }
    int number = 0;
    for (const TDF_Label& component : components_of(target)) {
        name_below(component, fmt::format("{}.{}", name_of(target), ++number));
    }
}

}  // namespace

void join_bodies(const Document& document) {
    bool joined = false;
    for (const TDF_Label& root : roots_of(document)) {
        joined = join_below(document, root) || joined;
    }
    if (joined) {
        shapes_of(document)->UpdateAssemblies();
    }
}

void name_parts(const Document& document, const std::string& name) {
    const std::vector<TDF_Label> roots = roots_of(document);
    for (std::size_t i = 0; i < roots.size(); ++i) {
        name_below(roots[i], roots.size() == 1 ? name : fmt::format("{}.{}", name, i + 1));
    }
}

}  // namespace suture::io

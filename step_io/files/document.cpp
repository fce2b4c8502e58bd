#include "files/document.h"

#include <TCollection_AsciiString.hxx>
#include <TDF_ChildIterator.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <XCAFDoc_DocumentTool.hxx>

namespace suture::io {

namespace {

std::vector<TDF_Label> to_vector(const TDF_LabelSequence& labels) {
    return {labels.begin(), labels.end()};
}

}  // namespace

Document make_document() {
    Document document = occ::make<TDocStd_Document>("BinXCAF");
    XCAFDoc_DocumentTool::Set(document->Main());
    return document;
}

occ::Handle<XCAFDoc_ShapeTool> shapes_of(const Document& document) {
    return XCAFDoc_DocumentTool::ShapeTool(document->Main());
}

occ::Handle<XCAFDoc_ColorTool> colours_of(const Document& document) {
    return XCAFDoc_DocumentTool::ColorTool(document->Main());
}

occ::Handle<XCAFDoc_LayerTool> layers_of(const Document& document) {
    return XCAFDoc_DocumentTool::LayerTool(document->Main());
}

std::vector<TDF_Label> roots_of(const Document& document) {
    TDF_LabelSequence labels;
    shapes_of(document)->GetFreeShapes(labels);
    return to_vector(labels);
}

std::vector<TDF_Label> components_of(const TDF_Label& label) {
    TDF_LabelSequence labels;
    XCAFDoc_ShapeTool::GetComponents(label, labels);
    return to_vector(labels);
}

TDF_Label referred(const TDF_Label& label) {
    TDF_Label target = label;
    while (XCAFDoc_ShapeTool::IsReference(target)) {
        XCAFDoc_ShapeTool::GetReferredShape(TDF_Label(target), target);
    }
    return target;
}

std::vector<TDF_Label> sub_shapes_of(const TDF_Label& part) {
    std::vector<TDF_Label> labels;
    for (TDF_ChildIterator child(part, true); child.More(); child.Next()) {
        if (XCAFDoc_ShapeTool::IsShape(child.Value())) {
            labels.push_back(child.Value());
        }
    }
    return labels;
}

std::string name_of(const TDF_Label& label) {
    occ::Handle<TDataStd_Name> name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name)) {
        return {};
    }
    return TCollection_AsciiString(name->Get()).ToCString();
}

void set_name(const TDF_Label& label, const std::string& name) {
    TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
}

bool has_face(const TopoDS_Shape& shape) {
    return !shape.IsNull() && TopExp_Explorer(shape, TopAbs_FACE).More();
}

}  // namespace suture::io

#pragma once

#include "suture/occ/handle.h"

#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <string>
#include <vector>

namespace suture::io {

using Document = occ::Handle<TDocStd_Document>;

/// An XCAF document with nothing in it, that belongs to no application.
[[nodiscard]] Document make_document();

[[nodiscard]] occ::Handle<XCAFDoc_ShapeTool> shapes_of(const Document& document);
[[nodiscard]] occ::Handle<XCAFDoc_ColorTool> colours_of(const Document& document);
[[nodiscard]] occ::Handle<XCAFDoc_LayerTool> layers_of(const Document& document);

/// The free shapes: the roots of the assembly trees.
[[nodiscard]] std::vector<TDF_Label> roots_of(const Document& document);

/// The components of an assembly, none for anything else.
[[nodiscard]] std::vector<TDF_Label> components_of(const TDF_Label& label);

/// What a component or a located root refers to; other labels stand for themselves.
[[nodiscard]] TDF_Label referred(const TDF_Label& label);

/// All labels of sub-shapes below a part's label.
[[nodiscard]] std::vector<TDF_Label> sub_shapes_of(const TDF_Label& part);

/// A label's name in UTF-8, empty if it has none.
[[nodiscard]] std::string name_of(const TDF_Label& label);
void set_name(const TDF_Label& label, const std::string& name);

[[nodiscard]] bool has_face(const TopoDS_Shape& shape);

}  // namespace suture::io

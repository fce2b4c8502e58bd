#pragma once

#include "files/document.h"
#include "files/model_file.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Quantity_Color.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <algorithm>
#include <string>
#include <vector>

namespace suture::io::test {

inline std::string number(double value) {
    return fmt::format("{:.4g}", std::abs(value) < 1e-7 ? 0.0 : value);
}

/// Where a shape is and how large: independent of the order of sub-shapes.
inline std::string place(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    if (shape.ShapeType() <= TopAbs_FACE) {
        BRepGProp::SurfaceProperties(shape, properties);
    } else {
        BRepGProp::LinearProperties(shape, properties);
    }
    const gp_Pnt centre = properties.CentreOfMass();
    return fmt::format("{} at {},{},{}", number(properties.Mass()), number(centre.X()),
                       number(centre.Y()), number(centre.Z()));
}

inline std::string look(const Document& document, const TDF_Label& label) {
    std::string text;
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorGen, XCAFDoc_ColorSurf, XCAFDoc_ColorCurv}) {
        Quantity_Color colour;
        if (colours_of(document)->GetColor(label, type, colour)) {
            // STEP keeps a generic colour as surface and curve colour
            text += fmt::format(" {}:{}", type == XCAFDoc_ColorCurv ? "curve" : "surface",
                                Quantity_Color::ColorToHex(colour).ToCString());
        }
    }
    occ::Handle<TColStd_HSequenceOfExtendedString> layers;
    if (layers_of(document)->GetLayers(label, layers)) {
        for (const TCollection_ExtendedString& layer : *layers) {
            text += fmt::format(" layer:{}", TCollection_AsciiString(layer).ToCString());
        }
    }
    return text;
}

inline std::string location_text(const TDF_Label& label) {
    const TopLoc_Location location = XCAFDoc_ShapeTool::GetLocation(label);
    std::string text;
    for (int row = 1; row <= 3; ++row) {
        for (int column = 1; column <= 4; ++column) {
            text += fmt::format(" {}", number(location.Transformation().Value(row, column)));
        }
    }
    return text;
}

inline void describe(const Document& document, const TDF_Label& label, const std::string& indent,
                     std::string& text) {
    const TDF_Label target = referred(label);
    text += fmt::format("{}'{}'", indent, name_of(target));
    if (target != label) {
        text += fmt::format(" as '{}'{}{}", name_of(label), location_text(label),
                            look(document, label));
    }
    text += look(document, target);
    if (XCAFDoc_ShapeTool::IsAssembly(target)) {
        text += "\n";
        for (const TDF_Label& component : components_of(target)) {
            describe(document, component, indent + "  ", text);
        }
        return;
    }
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(target);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    text += fmt::format(" {} faces, {}\n", faces.Extent(), place(shape));
    std::vector<std::string> lines;
    for (const TDF_Label& sub : sub_shapes_of(target)) {
        const TopoDS_Shape part = XCAFDoc_ShapeTool::GetShape(sub);
        lines.push_back(fmt::format("{}  {}: {} '{}'{}\n", indent,
                                    static_cast<int>(part.ShapeType()), place(part), name_of(sub),
                                    look(document, sub)));
    }
    std::ranges::sort(lines);
    for (const std::string& line : lines) {
        text += line;
    }
}

/// The assembly tree of a model with all names, locations, colours, layers and sizes.
inline std::string describe(const ModelFile& model) {
    std::string text;
    for (const TDF_Label& root : roots_of(model.document)) {
        describe(model.document, root, "", text);
    }
    return text;
}

}  // namespace suture::io::test

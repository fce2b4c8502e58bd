#pragma once

#include "step_io/files/files.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gp_Ax1.hxx>

namespace suture::io::test {

inline TopLoc_Location moved(double x, double y, double z, double angle = 0.0) {
    gp_Trsf rotation;
    rotation.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2)), angle);
    gp_Trsf translation;
    translation.SetTranslation(gp_Vec(x, y, z));
    return TopLoc_Location(translation * rotation);
}

inline TopoDS_Shape face_of(const TopoDS_Shape& shape, int number) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    return faces(number);
}

/// Two levels: machine > frame (plate, bolt twice) and bolt once more. Names in several scripts,
/// colours of parts, faces and layers.
inline ModelFile two_level_assembly() {
    ModelFile model;
    model.document = make_document();
    const auto tool = shapes_of(model.document);
    const auto colours = colours_of(model.document);
    const auto layers = layers_of(model.document);
    const TopoDS_Shape plate_shape = BRepPrimAPI_MakeBox(30, 20, 5).Shape();
    const TopoDS_Shape bolt_shape = BRepPrimAPI_MakeCylinder(2, 15).Shape();
    const TDF_Label plate = tool->AddShape(plate_shape, false);
    const TDF_Label bolt = tool->AddShape(bolt_shape, false);
    set_name(plate, "Träger 板");
    set_name(bolt, "bolt M4 'short'");
    const TDF_Label frame = tool->NewShape();
    const TDF_Label machine = tool->NewShape();
    set_name(frame, "frame");
    set_name(machine, "machine");
    set_name(tool->AddComponent(frame, plate, TopLoc_Location()), "base");
    set_name(tool->AddComponent(frame, bolt, moved(5, 5, 0)), "left bolt");
    set_name(tool->AddComponent(frame, bolt, moved(25, 5, 1, 0.3)), "right bolt");
    set_name(tool->AddComponent(machine, frame, moved(0, 0, 40, 0.7)), "upper frame");
    set_name(tool->AddComponent(machine, bolt, moved(-20, 3, 0)), "spare bolt");
    tool->UpdateAssemblies();
    colours->SetColor(plate, Quantity_Color(0.2, 0.4, 0.6, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    colours->SetColor(tool->AddSubShape(plate, face_of(plate_shape, 3)),
                      Quantity_Color(1, 0, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    const TDF_Label side = tool->AddSubShape(plate, face_of(plate_shape, 5));
    colours->SetColor(side, Quantity_Color(0, 1, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    set_name(side, "datum A");
    layers->SetLayer(side, "sides");
    colours->SetColor(bolt, Quantity_Color(0.5, 0.5, 0.5, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    layers->SetLayer(bolt, "hardware");
    return model;
}

}  // namespace suture::io::test

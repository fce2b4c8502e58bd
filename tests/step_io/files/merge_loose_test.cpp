#include "step_io/files/assembly.h"
#include "step_io/files/describe.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <gp_Pln.hxx>

namespace suture::io::test {

namespace {

TopoDS_Shape square(double offset) {
    return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, offset), gp_Dir(0, 0, 1)), 0, 3, 0, 2)
        .Shape();
}

int faces_in(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    return faces.Extent();
}

}  // namespace

TEST(MergeLoose, MakesOnePartOfFacesAndKeepsTheirLooks) {
    ModelFile model;
    model.path = "sheets.step";
    model.document = make_document();
    const auto tool = shapes_of(model.document);
    const TDF_Label red = tool->AddShape(square(0), false);
    const TDF_Label solid = tool->AddShape(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), false);
    const TopoDS_Shape green_square = square(4);
    const TDF_Label green = tool->AddShape(green_square, false);
    set_name(red, "red sheet");
    set_name(green, "green sheet");
    set_name(solid, "block");
    colours_of(model.document)
        ->SetColor(red, Quantity_Color(1, 0, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    colours_of(model.document)
        ->SetColor(green, Quantity_Color(0, 1, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    layers_of(model.document)->SetLayer(green, "outside");

    model.merge_loose();

    EXPECT_EQ(describe(model),
              "'block' 6 faces, 22 at 0.5,1,1.5\n"
              "'sheets' 2 faces, 12 at 1.5,1,2\n"
              "  4: 6 at 1.5,1,0 'red sheet' surface:#FF0000\n"
              "  4: 6 at 1.5,1,4 'green sheet' surface:#00FF00 layer:outside\n");
}

TEST(MergeLoose, PutsFacesOfAnAssemblyWhereTheyStand) {
    ModelFile model;
    model.path = "sheets.step";
    model.document = make_document();
    const auto tool = shapes_of(model.document);
    const TDF_Label sheet = tool->AddShape(square(0), false);
    const TDF_Label group = tool->NewShape();
    const TDF_Label all = tool->NewShape();
    set_name(all, "hull");
    tool->AddComponent(group, sheet, moved(0, 0, 1));
    tool->AddComponent(group, sheet, moved(0, 0, 2));
    tool->AddComponent(all, group, moved(10, 0, 0));
    tool->AddComponent(all, group, moved(20, 0, 0));
    tool->UpdateAssemblies();
    const std::string before = place(model.shape());
    model.merge_loose();
    EXPECT_EQ(place(model.shape()), before);
    ASSERT_EQ(model.parts().size(), 1U);
    EXPECT_EQ(model.parts().front().name, "hull");
    EXPECT_EQ(faces_in(model.parts().front().shape), 4);
}

TEST(MergeLoose, LeavesSewnShellsAndSingleSheetsAlone) {
    BRepBuilderAPI_Sewing sewing(1e-6);
    sewing.Add(square(0));
    sewing.Add(BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)), 0, 3, 0, 2));
    sewing.Perform();
    ModelFile model = model_of(sewing.SewedShape(), "angle");
    set_name(shapes_of(model.document)->AddShape(square(9), false), "sheet");
    const std::string before = describe(model);
    model.merge_loose();
    EXPECT_EQ(describe(model), before);
    EXPECT_EQ(model.parts().size(), 2U);
}

TEST(MergeLoose, MakesOnePartOfEachFileOfLooseFaces) {
    SUTURE_NEEDS_CAD_FILES();
    const std::vector<std::pair<const char*, int>> files{
        {"bearing.iges", 213},  {"hammer.iges", 45},    {"goteborg.iges", 3},
        {"goteborg.step", 3},   {"777-200LR.stp", 113}, {"simple_wing.stp", 13},
        {"ANC101-ill.stp", 137}};
    for (const auto& [name, faces] : files) {
        ModelFile model = read(cad(name));
        if (model.format == Format::Iges) {
            EXPECT_EQ(model.parts().size(), 1U) << name;
        }
        model.merge_loose();
        ASSERT_EQ(model.parts().size(), 1U) << name;
        EXPECT_EQ(faces_in(model.parts().front().shape), faces) << name;
        EXPECT_FALSE(model.parts().front().name.empty()) << name;
    }
}

TEST(MergeLoose, KeepsColoursOfLooseIgesFaces) {
    const Folder folder;
    ModelFile model = model_of(square(0), "red");
    const auto tool = shapes_of(model.document);
    const TDF_Label green = tool->AddShape(square(4), false);
    set_name(green, "green");
    colours_of(model.document)
        ->SetColor(green, Quantity_Color(0, 1, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    colours_of(model.document)
        ->SetColor(model.parts().front().label, Quantity_Color(1, 0, 0, Quantity_TOC_sRGB),
                   XCAFDoc_ColorSurf);
    write(model, folder / "sheets.igs", Format::Iges);
    const std::string text = describe(read(folder / "sheets.igs"));
    EXPECT_NE(text.find("6 at 1.5,1,0 'red' surface:#FF0000"), text.npos) << text;
    EXPECT_NE(text.find("6 at 1.5,1,4 'green' surface:#00FF00"), text.npos) << text;
}

}  // namespace suture::io::test

#include "step_io/files/assembly.h"
#include "step_io/files/describe.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

namespace suture::io::test {

namespace {

struct Swap {
    TopoDS_Shape shape;
    TopTools_DataMapOfShapeShape replaced;
};

/// The same shape with one face exchanged for another on a copy of its surface and its old edges.
Swap swap_face(const TopoDS_Shape& shape, int number) {
    const TopoDS_Face old = TopoDS::Face(face_of(shape, number));
    TopoDS_Face fresh;
    const BRep_Builder builder;
    builder.MakeFace(fresh, occ::cast<Geom_Surface>(BRep_Tool::Surface(old)->Copy()),
                     BRep_Tool::Tolerance(old));
    for (TopoDS_Iterator wire(old.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next()) {
        builder.Add(fresh, wire.Value());
    }
    fresh.Orientation(old.Orientation());
    for (TopExp_Explorer edge(old, TopAbs_EDGE); edge.More(); edge.Next()) {
        double first = 0.0;
        double last = 0.0;
        const TopoDS_Edge& side = TopoDS::Edge(edge.Current());
        builder.UpdateEdge(side, BRep_Tool::CurveOnSurface(side, old, first, last), fresh,
                           BRep_Tool::Tolerance(side));
    }
    BRepTools_ReShape reshape;
    reshape.Replace(old, fresh);
    Swap swap{reshape.Apply(shape), {}};
    swap.replaced.Bind(old, fresh);
    return swap;
}

/// Whether swap_face can do it: no seam, no pole.
bool is_simple(const TopoDS_Shape& face) {
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
        const TopoDS_Edge& side = TopoDS::Edge(edge.Current());
        if (BRep_Tool::Degenerated(side) || BRep_Tool::IsClosed(side, TopoDS::Face(face))) {
            return false;
        }
    }
    return true;
}

int part_faces(const Part& part) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(part.shape, TopAbs_FACE, faces);
    return faces.Extent();
}

int part_number(const ModelFile& model, const std::string& name) {
    const std::vector<Part> parts = model.parts();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].name == name) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

const std::string kPlate = "Träger 板";

}  // namespace

TEST(Replace, KeepsTreeNamesColoursAndLayersThroughStep) {
    const Folder folder;
    write(two_level_assembly(), folder / "in.step", Format::Step);
    ModelFile model = read(folder / "in.step");
    const std::string before = describe(model);
    for (int face = 1; face <= 6; ++face) {
        ModelFile changed = read(folder / "in.step");
        const Part part = changed.parts()[static_cast<std::size_t>(part_number(changed, kPlate))];
        const Swap swap = swap_face(part.shape, face);
        ASSERT_FALSE(swap.shape.IsSame(part.shape));
        changed.replace(part, swap.shape, swap.replaced);
        EXPECT_EQ(describe(changed), before) << face;
        write(changed, folder / "out.step", Format::Step);
        EXPECT_EQ(describe(read(folder / "out.step")), before) << face;
    }
}

TEST(Replace, ChangesEveryInstanceOfAPart) {
    ModelFile model = two_level_assembly();
    const Part bolt = model.parts().at(1);
    const TopoDS_Shape longer = BRepPrimAPI_MakeCylinder(2, 45).Shape();
    model.replace(bolt, longer, {});
    int count = 0;
    for (TopExp_Explorer solid(model.shape(), TopAbs_SOLID); solid.More(); solid.Next()) {
        count += solid.Current().IsPartner(longer) ? 1 : 0;
    }
    EXPECT_EQ(count, 3);
    EXPECT_EQ(model.parts().at(1).name, bolt.name);
    EXPECT_EQ(model.parts().at(1).instances, 3);
}

TEST(Replace, LeavesOtherPartsFacesTheirNumbers) {
    ModelFile model = two_level_assembly();
    TopTools_IndexedMapOfShape before;
    TopExp::MapShapes(model.shape(), TopAbs_FACE, before);
    const Part plate = model.parts().at(0);
    const Swap swap = swap_face(plate.shape, 2);
    model.replace(plate, swap.shape, swap.replaced);
    TopTools_IndexedMapOfShape after;
    TopExp::MapShapes(model.shape(), TopAbs_FACE, after);
    ASSERT_EQ(after.Extent(), before.Extent());
    int changed = 0;
    for (int i = 1; i <= before.Extent(); ++i) {
        changed += before(i).IsSame(after(i)) ? 0 : 1;
        EXPECT_EQ(place(before(i)), place(after(i))) << i;
    }
    EXPECT_EQ(changed, 1);
}

TEST(Replace, DropsTheColourOfAFaceThatIsGone) {
    ModelFile model = two_level_assembly();
    const Part plate = model.parts().at(0);
    BRepTools_ReShape reshape;
    reshape.Remove(face_of(plate.shape, 3));
    model.replace(plate, reshape.Apply(plate.shape), {});
    EXPECT_EQ(describe(model).find("#FF0000"), std::string::npos);
    EXPECT_NE(describe(model).find("#00FF00"), std::string::npos);
}

TEST(Replace, KeepsTheColourOfASolidThatWasRebuilt) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 5).Shape();
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    builder.Add(all, box);
    ModelFile model = model_of(all, "box");
    const Part part = model.parts().front();
    const TDF_Label body = shapes_of(model.document)->AddSubShape(part.label, box);
    colours_of(model.document)
        ->SetColor(body, Quantity_Color(1, 0, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    const Swap swap = swap_face(all, 2);
    model.replace(part, swap.shape, swap.replaced);
    EXPECT_NE(describe(model).find("#FF0000"), std::string::npos);
    EXPECT_TRUE(XCAFDoc_ShapeTool::GetShape(body).IsSame(
        TopExp_Explorer(swap.shape, TopAbs_SOLID).Current()));
}

TEST(Replace, KeepsColoursOfRealFiles) {
    SUTURE_NEEDS_CAD_FILES();
    const Folder folder;
    for (const char* name : {"0044_bb_boxblend_03_colored.stp", "Reflector_Definition.step",
                             "0045_bb_boxblend_03_colored_mirrored.stp"}) {
        ModelFile plain = read(cad(name));
        write(plain, folder / "plain.step", Format::Step);
        ModelFile model = read(cad(name));
        const std::string before = describe(model);
        int swapped = 0;
        for (const Part& part : model.parts()) {
            int number = 1;
            while (number <= part_faces(part) && !is_simple(face_of(part.shape, number))) {
                ++number;
            }
            if (number <= part_faces(part)) {
                const Swap swap = swap_face(part.shape, number);
                model.replace(part, swap.shape, swap.replaced);
                ++swapped;
            }
        }
        EXPECT_GT(swapped, 0);
        EXPECT_EQ(describe(model), before) << name;
        write(model, folder / "out.step", Format::Step);
        // what OCCT's writer itself loses is not the replacement's doing
        EXPECT_EQ(describe(read(folder / "out.step")), describe(read(folder / "plain.step")))
            << name;
    }
}

}  // namespace suture::io::test

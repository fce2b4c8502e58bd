#include "files/look.h"

#include "step_io/files/assembly.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepTools_ReShape.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <map>

namespace suture::io::test {

namespace {

const Quantity_Color kRed(1, 0, 0, Quantity_TOC_sRGB);
const Quantity_Color kGreen(0, 1, 0, Quantity_TOC_sRGB);

/// A box of one part, one of whose faces gives way to a copy with a surface of its own.
struct Filled {
    ModelFile model;
    TopoDS_Face face;

    /// The new face's colour, its own or its body's, after writing and reading.
    [[nodiscard]] std::string colour_in_file() const {
        const Folder folder;
        write(model, folder / "filled.step", Format::Step);
        const ModelFile again = read(folder / "filled.step");
        const Part part = again.parts().front();
        const TopoDS_Face there = face_at(part.shape);
        const Looks looks(again.document);
        Look look = looks.of(part.label, {});
        for (const TDF_Label& label : sub_shapes_of(part.label)) {
            TopTools_IndexedMapOfShape faces;
            TopExp::MapShapes(XCAFDoc_ShapeTool::GetShape(label), TopAbs_FACE, faces);
            if (faces.Contains(there)) {
                look = looks.of(label, look);
            }
        }
        const auto& colour = look.colours[1] ? look.colours[1] : look.colours[0];
        return colour ? Quantity_Color::ColorToHex(colour->GetRGB(), true).ToCString() : "none";
    }

    /// The face of another box that stands where the new one stands.
    [[nodiscard]] TopoDS_Face face_at(const TopoDS_Shape& shape) const {
        const auto place = centre_of(face);
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        for (int i = 1; i <= faces.Extent(); ++i) {
            if (centre_of(faces(i)).Distance(place) < 1e-6) {
                return TopoDS::Face(faces(i));
            }
        }
        return {};
    }

    static gp_Pnt centre_of(const TopoDS_Shape& face) {
        gp_XYZ sum;
        int count = 0;
        for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next(), ++count) {
            sum += BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).XYZ();
        }
        return sum / count;
    }
};

/// colour(model, part, shape) sets the looks of the box before face 3 is made anew.
template <class Colour>
Filled filled_box(Colour&& colour) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 5).Shape();
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    builder.Add(all, box);
    Filled filled{model_of(all, "box"), {}};
    const Part part = filled.model.parts().front();
    colour(filled.model, part, box);
    const TopoDS_Shape old = face_of(all, 3);
    BRepTools_ReShape reshape;
    TopoDS_Shape fresh = old.EmptyCopied();
    for (TopoDS_Iterator it(old.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
        builder.Add(fresh, it.Value());
    }
    reshape.Replace(old, fresh);
    filled.model.replace(part, reshape.Apply(all), {});
    filled.face = TopoDS::Face(fresh);
    const std::array faces{filled.face};
    filled.model.adopt_looks(part, faces);
    return filled;
}

void colour_faces(const ModelFile& model, const Part& part, const TopoDS_Shape& box,
                  const std::map<int, Quantity_Color>& colours) {
    for (const auto& [number, colour] : colours) {
        colours_of(model.document)
            ->SetColor(shapes_of(model.document)->AddSubShape(part.label, face_of(box, number)),
                       colour, XCAFDoc_ColorSurf);
    }
}

}  // namespace

TEST(AdoptLooks, GivesANewFaceTheColourOfTheFacesAroundIt) {
    // Face 4 is opposite of face 3 and no neighbour: its colour does not count.
    const Filled filled = filled_box([](const auto& model, const auto& part, const auto& box) {
        colour_faces(model, part, box,
                     {{1, kRed}, {2, kRed}, {3, kGreen}, {4, kGreen}, {5, kRed}, {6, kRed}});
    });
    EXPECT_EQ(filled.colour_in_file(), "#FF0000");
}

TEST(AdoptLooks, GivesNoColourWhereNeighboursDiffer) {
    const Filled filled = filled_box([](const auto& model, const auto& part, const auto& box) {
        colour_faces(model, part, box, {{1, kRed}, {2, kGreen}, {5, kRed}, {6, kRed}});
    });
    EXPECT_EQ(filled.colour_in_file(), "none");
}

TEST(AdoptLooks, LeavesANewFaceTheColourOfItsBody) {
    const Filled filled = filled_box([](const auto& model, const auto& part, const auto& box) {
        colours_of(model.document)
            ->SetColor(shapes_of(model.document)->AddSubShape(part.label, box), kGreen,
                       XCAFDoc_ColorSurf);
    });
    EXPECT_EQ(filled.colour_in_file(), "#00FF00");
    for (const TDF_Label& label : sub_shapes_of(filled.model.parts().front().label)) {
        EXPECT_NE(XCAFDoc_ShapeTool::GetShape(label).ShapeType(), TopAbs_FACE);
    }
}

TEST(AdoptLooks, PutsTheNeighboursOwnColourOverThatOfTheBody) {
    const Filled filled = filled_box([](const auto& model, const auto& part, const auto& box) {
        colours_of(model.document)
            ->SetColor(shapes_of(model.document)->AddSubShape(part.label, box), kGreen,
                       XCAFDoc_ColorSurf);
        colour_faces(model, part, box, {{1, kRed}, {2, kRed}, {5, kRed}, {6, kRed}});
    });
    EXPECT_EQ(filled.colour_in_file(), "#FF0000");
}

TEST(AdoptLooks, PutsANewFaceOnTheLayerOfItsNeighbours) {
    const Filled filled = filled_box([](const auto& model, const auto& part, const auto& box) {
        for (const int number : {1, 2, 5, 6}) {
            layers_of(model.document)
                ->SetLayer(shapes_of(model.document)->AddSubShape(part.label, face_of(box, number)),
                           "skin");
        }
    });
    TDF_Label label;
    const Part part = filled.model.parts().front();
    ASSERT_TRUE(shapes_of(filled.model.document)->FindSubShape(part.label, filled.face, label));
    EXPECT_TRUE(layers_of(filled.model.document)->IsSet(label, "skin"));
}

}  // namespace suture::io::test

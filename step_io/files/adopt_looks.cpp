#include "files/document.h"
#include "files/look.h"
#include "files/model_file.h"
#include "suture/occ/topology.h"

#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <map>

namespace suture::io {

namespace {

bool same_layers(const Look& a, const Look& b) {
    if (a.layers.IsNull() || b.layers.IsNull()) {
        return a.layers.IsNull() && b.layers.IsNull();
    }
    return a.layers->Length() == b.layers->Length() &&
           std::equal(a.layers->begin(), a.layers->end(), b.layers->begin());
}

/// How the faces of a part look: by their own labels, or by those of what they belong to.
class FaceLooks {
  public:
    FaceLooks(const Looks& looks, const TDF_Label& part) {
        TopExp::MapShapes(XCAFDoc_ShapeTool::GetShape(part), TopAbs_FACE, faces_);
        const Look whole = looks.of(part, {});
        looks_.assign(static_cast<std::size_t>(faces_.Extent()), whole);
        // What is larger first: a face's own label is over its solid's.
        std::vector<TDF_Label> labels = sub_shapes_of(part);
        std::ranges::stable_sort(labels, {}, [](const TDF_Label& label) {
            return XCAFDoc_ShapeTool::GetShape(label).ShapeType();
        });
        for (const TDF_Label& label : labels) {
            TopTools_IndexedMapOfShape faces;
            TopExp::MapShapes(XCAFDoc_ShapeTool::GetShape(label), TopAbs_FACE, faces);
            for (int i = 1; i <= faces.Extent(); ++i) {
                if (Look* look = find(faces(i))) {
                    *look = looks.of(label, *look);
                }
            }
        }
    }

    /// Null for a face of another part.
    [[nodiscard]] Look* find(const TopoDS_Shape& face) {
        const int number = faces_.FindIndex(face);
        return number == 0 ? nullptr : &looks_[static_cast<std::size_t>(number - 1)];
    }

  private:
    TopTools_IndexedMapOfShape faces_;
    std::vector<Look> looks_;
};

/// What all have alike; of what differs, nothing.
Look common(const std::vector<Look>& looks) {
    Look result = looks.front();
    result.name.clear();
    for (const Look& look : looks) {
        for (std::size_t i = 0; i < kColourTypes.size(); ++i) {
            if (look.colours[i] != result.colours[i]) {
                result.colours[i].reset();
            }
        }
        if (!same_layers(look, result)) {
            result.layers.Nullify();
        }
    }
    return result;
}

/// Of a look what is not there without a label of its own.
Look beyond(Look look, const Look& inherited) {
    for (std::size_t i = 0; i < kColourTypes.size(); ++i) {
        if (look.colours[i] == inherited.colours[i]) {
            look.colours[i].reset();
        }
    }
    if (same_layers(look, inherited)) {
        look.layers.Nullify();
    }
    return look;
}

}  // namespace

void ModelFile::adopt_looks(const Part& part, std::span<const TopoDS_Face> faces) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part.label);
    TopTools_IndexedDataMapOfShapeListOfShape faces_of_edges;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edges);
    TopTools_IndexedMapOfShape fresh;
    for (const TopoDS_Face& face : faces) {
        fresh.Add(face);
    }
    const Looks looks(document);
    FaceLooks known(looks, part.label);
    // All faces of one fill look alike, also those that meet no old face: their neighbours do.
    std::vector<Look> found;
    for (const TopoDS_Face& face : faces) {
        for (const TopoDS_Edge& edge : occ::edges_of(face)) {
            const TopTools_ListOfShape* meeting = faces_of_edges.Seek(edge);
            for (const TopoDS_Shape& neighbour : meeting ? *meeting : TopTools_ListOfShape()) {
                if (const Look* look = known.find(neighbour); look && !fresh.Contains(neighbour)) {
                    found.push_back(*look);
                }
            }
        }
    }
    if (found.empty()) {
        return;
    }
    const Look wanted = common(found);
    const occ::Handle<XCAFDoc_ShapeTool> tool = shapes_of(document);
    for (const TopoDS_Face& face : faces) {
        const Look* inherited = known.find(face);
        if (inherited == nullptr) {
            continue;
        }
        if (const Look own = beyond(wanted, *inherited); !own.empty()) {
            looks.set(tool->AddSubShape(part.label, face), own);
        }
    }
}

}  // namespace suture::io

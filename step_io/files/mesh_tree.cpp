#include "files/mesh_tree.h"

#include "files/document.h"
#include "files/look.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <Quantity_Color.hxx>
#include <TDF_Tool.hxx>
#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <map>
#include <optional>

namespace suture::io {

namespace {

constexpr int kNone = -1;

class TreeMesher {
  public:
    TreeMesher(const ModelFile& model, const MeshOptions& options)
        : looks_(model.document), options_(options) {}

    Result<MeshTree> run(const Document& document) {
        for (const TDF_Label& root : roots_of(document)) {
            const Result<std::size_t> object = add(referred(root), colour_at(root, kNone));
            if (!object) {
                return tl::unexpected(object.error());
            }
            tree_.roots.push_back({*object, name_of(root), placement_of_label(root)});
        }
        return std::move(tree_);
    }

  private:
    static gp_Trsf placement_of_label(const TDF_Label& label) {
        return XCAFDoc_ShapeTool::GetShape(label).Location().Transformation();
    }

    /// The object of a part or an assembly, made at the first time.
    ///
    /// Input    inherited: the colour that an instance gives what has none of its own
    Result<std::size_t> add(const TDF_Label& label, int inherited) {
        const int own = colour_at(label, inherited);
        const std::pair key(entry_of(label), own);
        if (const auto known = known_.find(key); known != known_.end()) {
            return known->second;
        }
        MeshObject object;
        object.name = name_of(label);
        if (XCAFDoc_ShapeTool::IsAssembly(label)) {
            for (const TDF_Label& component : components_of(label)) {
                const Result<std::size_t> inner =
                    add(referred(component), colour_at(component, own));
                if (!inner) {
                    return inner;
                }
                object.children.push_back(
                    {*inner, name_of(component), placement_of_label(component)});
            }
        } else if (Result<void> meshed = mesh(label, own, object); !meshed) {
            return tl::unexpected(meshed.error());
        }
        tree_.objects.push_back(std::move(object));
        return known_[key] = tree_.objects.size() - 1;
    }

    static std::string entry_of(const TDF_Label& label) {
        TCollection_AsciiString entry;
        TDF_Tool::Entry(label, entry);
        return entry.ToCString();
    }

    Result<void> mesh(const TDF_Label& part, int colour, MeshObject& object) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part);
        if (!has_face(shape)) {
            return {};
        }
        Result<Mesh> mesh = make_mesh(shape, options_);
        if (!mesh) {
            return fail(mesh.error().code, "part '{}': {}", object.name, mesh.error().message);
        }
        object.mesh = std::move(*mesh);
        for (UnmeshedFace& face : object.mesh.facts.left_out) {
            face.part = object.name;
        }
        const std::vector<int> of_face = colours_of_faces(part, colour, shape);
        if (std::ranges::any_of(of_face, [](int one) { return one != kNone; })) {
            for (const std::uint32_t face : object.mesh.faces) {
                object.colours.push_back(of_face[face]);
            }
        }
        return {};
    }

    /// By FaceN: its own colour, that of the body it belongs to, or that of the part.
    std::vector<int> colours_of_faces(const TDF_Label& part, int of_part,
                                      const TopoDS_Shape& shape) {
        const occ::Numbering numbering(shape);
        std::vector<int> result(static_cast<std::size_t>(numbering.faces.Extent()) + 1, of_part);
        std::vector<TDF_Label> subs = sub_shapes_of(part);
        // Bodies first, so that faces have the last word; the order of labels is OCCT's, by
        // addresses.
        std::ranges::stable_sort(subs, {}, [&](const TDF_Label& sub) {
            const TopoDS_Shape& body = XCAFDoc_ShapeTool::GetShape(sub);
            const TopExp_Explorer face(body, TopAbs_FACE);
            return std::pair(body.ShapeType(),
                             face.More() ? numbering.faces.FindIndex(face.Current()) : 0);
        });
        for (const TDF_Label& sub : subs) {
            const int colour = colour_at(sub, kNone);
            if (colour == kNone) {
                continue;
            }
            for (TopExp_Explorer face(XCAFDoc_ShapeTool::GetShape(sub), TopAbs_FACE); face.More();
                 face.Next()) {
                const int number = numbering.faces.FindIndex(face.Current());
                if (number > 0) {
                    result[static_cast<std::size_t>(number)] = colour;
                }
            }
        }
        return result;
    }

    int colour_at(const TDF_Label& label, int inherited) {
        // The colour of surfaces, or the one for all.
        const Look look = looks_.of(label, {});
        const auto& wanted = look.colours[1] ? look.colours[1] : look.colours[0];
        if (!wanted) {
            return inherited;
        }
        std::array<double, 4> colour{};
        wanted->GetRGB().Values(colour[0], colour[1], colour[2], Quantity_TOC_sRGB);
        colour[3] = wanted->Alpha();
        const auto found = std::ranges::find(tree_.colours, colour);
        if (found != tree_.colours.end()) {
            return static_cast<int>(found - tree_.colours.begin());
        }
        tree_.colours.push_back(colour);
        return static_cast<int>(tree_.colours.size()) - 1;
    }

    Looks looks_;
    MeshOptions options_;
    MeshTree tree_;
    std::map<std::pair<std::string, int>, std::size_t> known_;  ///< by label and colour
};

}  // namespace

Result<MeshTree> make_mesh_tree(const ModelFile& model, const MeshOptions& options) {
    return occ::guarded("meshing", [&]() -> Result<MeshTree> {
        MeshOptions all = options;
        if (all.deflection <= 0.0) {
            all.deflection = usual_deflection(model.shape());
        }
        return TreeMesher(model, all).run(model.document);
    });
}

MeshFacts facts_of(const MeshTree& tree) {
    MeshFacts facts;
    for (const MeshObject& object : tree.objects) {
        const MeshFacts& own = object.mesh.facts;
        facts.deflection = std::max(facts.deflection, own.deflection);
        facts.needles += own.needles;
        facts.open_edges += own.open_edges;
        facts.triangles += own.triangles;
        facts.points += own.points;
        facts.left_out.insert(facts.left_out.end(), own.left_out.begin(), own.left_out.end());
    }
    return facts;
}

}  // namespace suture::io

#include "files/model_file.h"

#include "files/document.h"

#include <BRep_Builder.hxx>
#include <TDF_LabelIntegerMap.hxx>
#include <TNaming_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>

#include <array>

namespace suture::io {

namespace {

/// Walks the assembly tree and counts how often each part stands in it.
class PartCollector {
  public:
    explicit PartCollector(const TDF_Label& united) : united_(united) {}

    void visit(const TDF_Label& label) {
        const TDF_Label target = referred(label);
        if (XCAFDoc_ShapeTool::IsAssembly(target)) {
            for (const TDF_Label& component : components_of(target)) {
                visit(component);
            }
            return;
        }
        if (const int* known = numbers_.Seek(target)) {
            ++parts_[static_cast<std::size_t>(*known)].instances;
            return;
        }
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(target);
        if (has_face(shape) || target == united_) {
            numbers_.Bind(target, static_cast<int>(parts_.size()));
            parts_.push_back({target, name_of(target), shape, 1});
        }
    }
    [[nodiscard]] std::vector<Part> parts() { return std::move(parts_); }

  private:
    TDF_Label united_;
    std::vector<Part> parts_;
    TDF_LabelIntegerMap numbers_;
};

/// What a part's old sub-shapes are in its new shape.
class Successors {
  public:
    Successors(const TopoDS_Shape& before, const TopoDS_Shape& after,
               const TopTools_DataMapOfShapeShape& replaced)
        : replaced_(replaced) {
        TopExp::MapShapes(after, present_);
        constexpr std::array kContainers{TopAbs_COMPOUND, TopAbs_SOLID, TopAbs_SHELL};
        for (const TopAbs_ShapeEnum kind : kContainers) {
            TopTools_IndexedMapOfShape old_ones;
            TopTools_IndexedMapOfShape new_ones;
            TopExp::MapShapes(before, kind, old_ones);
            TopExp::MapShapes(after, kind, new_ones);
            for (int i = 1; old_ones.Extent() == new_ones.Extent() && i <= old_ones.Extent(); ++i) {
                containers_.Bind(old_ones(i), new_ones(i));
            }
        }
    }

    /// Null if nothing of the shape is left.
    [[nodiscard]] TopoDS_Shape of(const TopoDS_Shape& shape) const {
        if (replaced_.IsBound(shape) && present_.Contains(replaced_.Find(shape))) {
            return replaced_.Find(shape);
        }
        if (present_.Contains(shape)) {
            return shape;
        }
        return containers_.IsBound(shape) ? containers_.Find(shape) : TopoDS_Shape();
    }

  private:
    const TopTools_DataMapOfShapeShape& replaced_;
    TopTools_IndexedMapOfShape present_;
    TopTools_DataMapOfShapeShape containers_;
};

}  // namespace

std::vector<Part> ModelFile::parts() const {
    PartCollector collector(united);
    for (const TDF_Label& root : roots_of(document)) {
        collector.visit(root);
    }
    return collector.parts();
}

TopoDS_Shape ModelFile::shape() const {
    const std::vector<TDF_Label> roots = roots_of(document);
    if (roots.size() == 1) {
        return XCAFDoc_ShapeTool::GetShape(roots.front());
    }
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const TDF_Label& root : roots) {
        builder.Add(all, XCAFDoc_ShapeTool::GetShape(root));
    }
    return all;
}

void ModelFile::replace(const Part& part, const TopoDS_Shape& shape,
                        const TopTools_DataMapOfShapeShape& replaced) {
    const Successors successors(XCAFDoc_ShapeTool::GetShape(part.label), shape, replaced);
    const occ::Handle<XCAFDoc_ShapeTool> tool = shapes_of(document);
    for (const TDF_Label& label : sub_shapes_of(part.label)) {
        const TopoDS_Shape old = XCAFDoc_ShapeTool::GetShape(label);
        const TopoDS_Shape successor = successors.of(old);
        if (successor.IsNull()) {
            label.ForgetAllAttributes();
        } else if (!successor.IsSame(old)) {
            TNaming_Builder(label).Generated(successor);
        }
    }
    tool->SetShape(part.label, shape);
    tool->UpdateAssemblies();
    // OCCT keeps tables from shapes to labels; they are filled anew from the labels.
    for (const TDF_Label& root : roots_of(document)) {
        tool->ComputeShapes(root);
    }
    tool->ComputeSimpleShapes();
}

}  // namespace suture::io

#include "suture/faces/voids.h"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>

namespace suture {
namespace {

/// Whether what a closed shell bounds is everything but its inside.
bool faces_inwards(const TopoDS_Shape& shell) {
    const BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    BRepClass3d_SolidClassifier classifier(solid);
    classifier.PerformInfinitePoint(Precision::Confusion());
    return classifier.State() == TopAbs_IN;
}

/// All vertices, since a shell that crosses the solid's boundary is no void.
bool lies_in(const TopoDS_Shape& shell, const TopoDS_Shape& solid) {
    BRepClass3d_SolidClassifier classifier(solid);
    for (TopExp_Explorer it(shell, TopAbs_VERTEX); it.More(); it.Next()) {
        const TopoDS_Vertex& vertex = TopoDS::Vertex(it.Current());
        classifier.Perform(BRep_Tool::Pnt(vertex), BRep_Tool::Tolerance(vertex));
        if (classifier.State() != TopAbs_IN) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<TopoDS_Shape> take_in_voids(std::vector<TopoDS_Shape> shapes) {
    std::vector<bool> taken(shapes.size(), false);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const TopoDS_Shape shell = shapes[i];
        if (shell.ShapeType() != TopAbs_SHELL || !BRep_Tool::IsClosed(shell) ||
            !faces_inwards(shell)) {
            continue;
        }
        const auto around = std::ranges::find_if(shapes, [&](const TopoDS_Shape& other) {
            return other.ShapeType() == TopAbs_SOLID && lies_in(shell, other);
        });
        if (around != shapes.end()) {
            TopoDS_Shape hollow = around->EmptyCopied();
            const BRep_Builder builder;
            for (TopoDS_Iterator it(*around); it.More(); it.Next()) {
                builder.Add(hollow, it.Value());
            }
            builder.Add(hollow, shell);
            *around = hollow;
            taken[i] = true;
        }
    }
    std::vector<TopoDS_Shape> left;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (!taken[i]) {
            left.push_back(shapes[i]);
        }
    }
    return left;
}

}  // namespace suture

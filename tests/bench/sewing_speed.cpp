/// Processor time of sewing 10,000 loose faces, against OCCT's own sewing of the same faces.
#include "suture/sew/sew_shape.h"

#include <fmt/format.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeSegment.hxx>
#include <GeomFill.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Compound.hxx>

#include <cmath>
#include <ctime>

namespace {

constexpr int kSide = 100;  // faces
constexpr double kFloor = 1e-6;

gp_Pnt point(int i, int j) {
    return {1.0 * i, 1.0 * j, 3.0 * std::sin(0.1 * i) * std::cos(0.13 * j)};
}

/// A wavy sheet of ruled faces that share nothing.
TopoDS_Compound loose_faces() {
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
            const auto line = [&](int k) {
                return GC_MakeSegment(point(i, j + k), point(i + 1, j + k)).Value();
            };
            builder.Add(compound,
                        BRepBuilderAPI_MakeFace(GeomFill::Surface(line(0), line(1)), 1e-7).Face());
        }
    }
    return compound;
}

template <class Work>
double cpu_seconds(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main() {
    const TopoDS_Compound ours = loose_faces();
    const TopoDS_Compound theirs = loose_faces();
    int left = -1;
    const double here = cpu_seconds([&] {
        const auto sewn = suture::sew_shape(ours, 0.0);
        left = sewn ? sewn->free_edges_after : -1;
    });
    int left_there = -1;
    const double there = cpu_seconds([&] {
        BRepBuilderAPI_Sewing sewing(kFloor);
        sewing.Add(theirs);
        sewing.Perform();
        left_there = sewing.NbFreeEdges();
    });
    fmt::print("{} faces: sew_shape {:.2f} s ({} free edges left), OCCT {:.2f} s ({})\n",
               kSide * kSide, here, left, there, left_there);
    return here <= there && left == left_there ? 0 : 1;
}

#pragma once

#include "suture/occ/topology.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

/// Surfaces cut into cells, one face each, sewn into a shell: bodies whose holes have a known
/// answer, the surface itself.
namespace suture::grids {

/// The shell of all cells [us[i], us[i+1]] x [vs[j], vs[j+1]] but those in `missing`. All are sewn
/// before some are taken out, so that cells that touch in a corner share their vertex.
inline TopoDS_Shape shell_of(const opencascade::handle<Geom_Surface>& surface,
                             const std::vector<double>& us, const std::vector<double>& vs,
                             const std::set<std::pair<int, int>>& missing) {
    constexpr double kTolerance = 1e-6;
    BRepBuilderAPI_Sewing sewing(kTolerance);
    std::vector<TopoDS_Face> taken;
    for (int i = 0; i + 1 < static_cast<int>(us.size()); ++i) {
        for (int j = 0; j + 1 < static_cast<int>(vs.size()); ++j) {
            const auto a = static_cast<std::size_t>(i);
            const auto b = static_cast<std::size_t>(j);
            const TopoDS_Face face =
                BRepBuilderAPI_MakeFace(surface, us[a], us[a + 1], vs[b], vs[b + 1], kTolerance);
            sewing.Add(face);
            if (missing.contains({i, j})) {
                taken.push_back(face);
            }
        }
    }
    sewing.Perform();
    const BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (TopExp_Explorer it(sewing.SewedShape(), TopAbs_FACE); it.More(); it.Next()) {
        const bool kept = std::none_of(taken.begin(), taken.end(), [&](const TopoDS_Face& face) {
            return sewing.ModifiedSubShape(face).IsSame(it.Current());
        });
        if (kept) {
            builder.Add(shell, it.Current());
        }
    }
    return shell;
}

/// A shell of a solid's faces without some of them (numbered from 0 in TopExp's order).
inline TopoDS_Shape without_faces(const TopoDS_Shape& solid, const std::set<int>& missing) {
    const BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    int number = 0;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
        if (!missing.contains(number++)) {
            builder.Add(shell, it.Current());
        }
    }
    return shell;
}

}  // namespace suture::grids

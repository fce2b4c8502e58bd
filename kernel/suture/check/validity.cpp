#include "suture/check/validity.h"

#include "suture/check/brepcheck_problems.h"
#include "suture/check/edge_uses.h"
#include "suture/occ/guard.h"

#include <tbb/parallel_for.h>

#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <numeric>

namespace suture {

namespace {

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, kind, map);
    return map.Extent();
}

double largest_tolerance(const TopoDS_Shape& shape) {
    return std::max({BRep_Tool::MaxTolerance(shape, TopAbs_FACE),
                     BRep_Tool::MaxTolerance(shape, TopAbs_EDGE),
                     BRep_Tool::MaxTolerance(shape, TopAbs_VERTEX)});
}

/// Volume of the cone from the origin over a face, positive if its normal points away from there.
double volume_of_cone(const TopoDS_Face& face, const gp_Pnt& origin) {
    const bool bounds =
        face.Orientation() == TopAbs_FORWARD || face.Orientation() == TopAbs_REVERSED;
    TopLoc_Location location;
    if (!bounds || BRep_Tool::Surface(face, location).IsNull()) {
        return 0.0;
    }
    BRepGProp_Face surface(face);
    const bool whole_surface = !TopExp_Explorer(face, TopAbs_EDGE).More();
    if (whole_surface) {
        return BRepGProp_Vinert(surface, origin).Mass();
    }
    BRepGProp_Domain border(face);
    return BRepGProp_Vinert(surface, border, origin).Mass();
}

/// The origin that OCCT takes itself: far from it, the differences of large cones would eat digits.
gp_Pnt middle_of_vertices(const TopoDS_Shape& solid) {
    gp_XYZ sum;
    int vertices = 0;
    for (TopExp_Explorer it(solid, TopAbs_VERTEX); it.More(); it.Next()) {
        sum += BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).XYZ();
        ++vertices;
    }
    return vertices > 0 ? gp_Pnt(sum / vertices) : gp_Pnt();
}

/// Sum over the faces of the solids, each face on its own: so they can be measured side by side.
double volume_of_solids(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    std::vector<gp_Pnt> origins;
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(shape, TopAbs_SOLID, solids);
    for (int k = 1; k <= solids.Extent(); ++k) {
        const gp_Pnt origin = middle_of_vertices(solids(k));
        for (TopExp_Explorer it(solids(k), TopAbs_FACE); it.More(); it.Next()) {
            faces.push_back(TopoDS::Face(it.Current()));
            origins.push_back(origin);
        }
    }
    std::vector<double> volumes(faces.size(), 0.0);
    tbb::parallel_for(std::size_t{0}, faces.size(),
                      [&](std::size_t i) { volumes[i] = volume_of_cone(faces[i], origins[i]); });
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

/// Adds OCCT's own failure to the problems.
template <class Action>
void attempt(std::string_view what, Validity& result, Action&& action) {
    if (const auto done = occ::guarded(what, std::forward<Action>(action)); !done) {
        result.problems.push_back(done.error().message);
    }
}

}  // namespace

Validity measure_validity(const TopoDS_Shape& shape, ValidityDepth depth) {
    Validity result;
    if (shape.IsNull()) {
        result.problems.emplace_back("there is no shape");
        return result;
    }
    const occ::Numbering numbering(shape);
    result.solids = count(shape, TopAbs_SOLID);
    result.shells = count(shape, TopAbs_SHELL);
    result.faces = numbering.faces.Extent();
    result.free_edges =
        static_cast<int>(std::ranges::count(find_edge_uses(numbering, {}), std::size_t{1},
                                            [](const auto& uses) { return uses.size(); }));
    result.closed = result.faces > 0 && result.free_edges == 0;
    result.max_tolerance = largest_tolerance(shape);
    if (depth == ValidityDepth::Full) {
        attempt("volume", result, [&] { result.volume = volume_of_solids(shape); });
    }
    if (depth != ValidityDepth::Topology) {
        attempt("BRepCheck", result, [&] {
            auto found = find_brepcheck_problems(shape, numbering);
            result.checked = true;
            result.valid = found.empty();
            std::ranges::move(found, std::back_inserter(result.problems));
        });
    }
    return result;
}

}  // namespace suture

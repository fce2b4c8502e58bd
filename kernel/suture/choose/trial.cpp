#include "suture/choose/trial.h"

#include "suture/check/brepcheck_problems.h"
#include "suture/faces/make_faces.h"
#include "suture/faces/unite_corners.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <set>

namespace suture {
namespace {

/// The hole's loops on copies of the neighbours.
struct CopiedHole {
    TopoDS_Compound neighbours;
    std::vector<BoundaryLoop> loops;
};

CopiedHole copy_of(const std::vector<BoundaryLoop>& loops) {
    const BRep_Builder builder;
    TopoDS_Compound originals;
    builder.MakeCompound(originals);
    TopTools_MapOfShape seen;
    for (const BoundaryLoop& loop : loops) {
        for (const BoundaryEdge& edge : loop.edges) {
            if (seen.Add(edge.face)) {
                builder.Add(originals, edge.face);
            }
        }
    }
    BRepBuilderAPI_Copy copy(originals, /*copyGeom=*/Standard_False, /*copyMesh=*/Standard_False);
    CopiedHole result{TopoDS::Compound(copy.Shape()), loops};
    for (BoundaryLoop& loop : result.loops) {
        for (BoundaryEdge& edge : loop.edges) {
            edge.face =
                TopoDS::Face(copy.ModifiedShape(edge.face).Oriented(edge.face.Orientation()));
            edge.edge =
                TopoDS::Edge(copy.ModifiedShape(edge.edge).Oriented(edge.edge.Orientation()));
        }
    }
    unite_corners(result.neighbours, result.loops);
    return result;
}

Result<FillMeasures> measure(const CopiedHole& copied, const Hole& hole,
                             const std::vector<TopoDS_Face>& faces, const Tolerance& tolerance,
                             const Progress& progress) {
    const BRep_Builder builder;
    TopoDS_Compound model = copied.neighbours;
    for (const TopoDS_Face& face : faces) {
        builder.Add(model, face);
    }
    const occ::Numbering numbering(model);
    FillPlace place;
    place.through = hole.through;
    for (const BoundaryLoop& loop : copied.loops) {
        for (const BoundaryEdge& edge : loop.edges) {
            place.sides.push_back(numbering.of(edge.edge));
        }
    }
    for (const TopoDS_Face& face : faces) {
        place.faces.push_back(numbering.of(face));
    }
    Profile profile;
    profile.tolerance = tolerance;
    auto measures = measure_fills(model, numbering, {place}, profile, progress);
    if (!measures) {
        return tl::unexpected(measures.error());
    }
    return std::move(measures->front());
}

}  // namespace

Result<FillMeasures> try_fill(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                              const FillResult& fill, const Tolerance& tolerance,
                              const Progress& progress) {
    return occ::guarded("trying the new face", [&]() -> Result<FillMeasures> {
        const CopiedHole copied = copy_of(loops);
        const auto made = make_faces(copied.loops, hole, fill);
        if (!made) {
            return tl::unexpected(made.error());
        }
        for (const TopoDS_Face& face : made->faces) {
            if (!BRepCheck_Analyzer(face).IsValid()) {
                const auto problems = find_brepcheck_problems(face, occ::Numbering(face));
                return fail(ErrorCode::Refused, "OCCT's check finds the new face invalid ({})",
                            fmt::join(problems, ", "));
            }
        }
        return measure(copied, hole, made->faces, tolerance, progress);
    });
}

}  // namespace suture

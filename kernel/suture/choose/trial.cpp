#include "suture/choose/trial.h"

#include "suture/check/brepcheck_problems.h"
#include "suture/faces/make_faces.h"
#include "suture/faces/unite_corners.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

namespace suture {
namespace {

/// The hole's loops on copies of the faces that meet them, be it in a vertex.
struct CopiedHole {
    TopoDS_Compound around;
    std::vector<BoundaryLoop> loops;
};

/// The faces of the shape that meet the loops, by whether `meeting` they do.
std::vector<TopoDS_Face> faces_around(const Site& site, bool meeting) {
    TopTools_MapOfShape vertices;
    for (const BoundaryLoop& loop : site.loops) {
        for (const BoundaryEdge& edge : loop.edges) {
            for (TopExp_Explorer it(edge.edge, TopAbs_VERTEX); it.More(); it.Next()) {
                vertices.Add(it.Current());
            }
        }
    }
    std::vector<TopoDS_Face> faces = occ::faces_of(site.shape);
    std::erase_if(faces, [&](const TopoDS_Face& face) {
        bool meets = false;
        for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More() && !meets; it.Next()) {
            meets = vertices.Contains(it.Current());
        }
        return meets != meeting;
    });
    return faces;
}

CopiedHole copy_of(const Site& site) {
    const BRep_Builder builder;
    TopoDS_Compound originals;
    builder.MakeCompound(originals);
    for (const TopoDS_Face& face : faces_around(site, /*meeting=*/true)) {
        builder.Add(originals, face);
    }
    for (const BoundaryLoop& loop : site.loops) {
        for (const BoundaryEdge& edge : loop.edges) {
            if (edge.face.IsNull()) {
                builder.Add(originals, edge.edge);
            }
        }
    }
    BRepBuilderAPI_Copy copy(originals, /*copyGeom=*/Standard_False, /*copyMesh=*/Standard_False);
    CopiedHole result{TopoDS::Compound(copy.Shape()), site.loops};
    for (BoundaryLoop& loop : result.loops) {
        for (BoundaryEdge& edge : loop.edges) {
            if (!edge.face.IsNull()) {
                edge.face =
                    TopoDS::Face(copy.ModifiedShape(edge.face).Oriented(edge.face.Orientation()));
            }
            edge.edge =
                TopoDS::Edge(copy.ModifiedShape(edge.edge).Oriented(edge.edge.Orientation()));
        }
    }
    unite_corners(result.around, result.loops);
    return result;
}

Result<Trial> measure(const CopiedHole& copied, const std::vector<ThroughPoint>& through,
                      const std::vector<TopoDS_Face>& faces, const Tolerance& tolerance,
                      const Progress& progress) {
    const BRep_Builder builder;
    Trial trial;
    trial.model = copied.around;
    for (const TopoDS_Face& face : faces) {
        builder.Add(trial.model, face);
    }
    const occ::Numbering numbering(trial.model);
    trial.place.through = through;
    for (const BoundaryLoop& loop : copied.loops) {
        for (const BoundaryEdge& edge : loop.edges) {
            trial.place.sides.push_back(numbering.of(edge.edge));
            trial.place.supports.push_back(edge.support);
        }
    }
    for (const TopoDS_Face& face : faces) {
        trial.place.faces.push_back(numbering.of(face));
    }
    Profile profile;
    profile.tolerance = tolerance;
    auto measures = measure_fills(trial.model, numbering, {trial.place}, profile, progress);
    if (!measures) {
        return tl::unexpected(measures.error());
    }
    trial.measures = std::move(measures->front());
    return trial;
}

}  // namespace

Result<Trial> try_fill(const Site& site, const Hole& hole, const FillResult& fill,
                       const Tolerance& tolerance, const Progress& progress) {
    return occ::guarded("trying the new face", [&]() -> Result<Trial> {
        const CopiedHole copied = copy_of(site);
        auto made = make_faces(copied.loops, hole, fill);
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
        const auto asked = hole.through.end() - static_cast<std::ptrdiff_t>(site.guides);
        auto trial =
            measure(copied, {hole.through.begin(), asked}, made->faces, tolerance, progress);
        if (trial) {
            trial->placements = std::move(made->placements);
        }
        return trial;
    });
}

Result<void> add_clashes(const Site& site, const Hole& hole, const Tolerance& tolerance,
                         const Progress& progress, Trial& trial) {
    const BRep_Builder builder;
    // Behind the faces that are there: their numbers stay.
    for (const TopoDS_Face& face : faces_around(site, /*meeting=*/false)) {
        builder.Add(trial.model, face);
    }
    return measure_clashes(trial.model, trial.place, hole.diameter, tolerance, progress,
                           trial.measures);
}

}  // namespace suture

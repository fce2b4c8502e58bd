#include "suture/choose/trial.h"

#include "suture/check/brepcheck_problems.h"
#include "suture/check/continuity.h"
#include "suture/check/point_distance.h"
#include "suture/faces/make_faces.h"
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
    return result;
}

/// The edges of new faces that are no sides of the hole.
std::vector<int> inner_edges(const std::vector<TopoDS_Face>& faces, const std::vector<int>& sides,
                             const occ::Numbering& numbering) {
    std::set<int> inner;
    for (const TopoDS_Face& face : faces) {
        for (const TopoDS_Edge& edge : occ::edges_of(face)) {
            inner.insert(numbering.of(edge));
        }
    }
    for (const int side : sides) {
        inner.erase(side);
    }
    return {inner.begin(), inner.end()};
}

/// New faces have to meet each other as well as they meet the neighbours.
Continuity highest_wish(const Hole& hole) {
    Continuity highest = Continuity::G0;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            highest = std::max(highest, ribbon.continuity);
        }
    }
    return highest;
}

Result<TrialMeasure> measure(const CopiedHole& copied, const Hole& hole,
                             const std::vector<TopoDS_Face>& faces, const Tolerance& tolerance,
                             const Progress& progress) {
    const BRep_Builder builder;
    TopoDS_Compound model = copied.neighbours;
    for (const TopoDS_Face& face : faces) {
        builder.Add(model, face);
    }
    const occ::Numbering numbering(model);
    std::vector<int> edges;
    for (const BoundaryLoop& loop : copied.loops) {
        for (const BoundaryEdge& edge : loop.edges) {
            edges.push_back(numbering.of(edge.edge));
        }
    }
    std::vector<int> inner = inner_edges(faces, edges, numbering);
    std::vector<int> all = edges;
    all.insert(all.end(), inner.begin(), inner.end());
    Profile profile;
    profile.tolerance = tolerance;
    const auto report = measure_continuity(model, profile, all, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    TrialMeasure result;
    std::size_t next = 0;
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            const int number = edges[next++];
            const auto found = std::find_if(report->edges.begin(), report->edges.end(),
                                            [&](const auto& e) { return e.edge == number; });
            if (found == report->edges.end() || found->samples == 0) {
                return fail(ErrorCode::Refused, "{} could not be measured against the new face",
                            name_of(ribbon));
            }
            const SideMeasure side{found->max_gap, found->max_angle, found->curvature_mismatch};
            result.score = std::max(result.score, score_of(side, ribbon.continuity, tolerance));
            result.sides.push_back(side);
        }
    }
    for (const EdgeContinuity& edge : report->edges) {
        if (std::find(inner.begin(), inner.end(), edge.edge) != inner.end()) {
            result.inner.gap = std::max(result.inner.gap, edge.max_gap);
            result.inner.angle = std::max(result.inner.angle, edge.max_angle);
            result.inner.curvature_mismatch =
                std::max(result.inner.curvature_mismatch, edge.curvature_mismatch);
        }
    }
    result.score = std::max(result.score, score_of(result.inner, highest_wish(hole), tolerance));
    for (const Eigen::Vector3d& point : hole.through) {
        result.through = std::max(result.through, measure_distance(point, faces));
    }
    result.score = std::max(result.score, result.through / tolerance.linear);
    return result;
}

}  // namespace

double score_of(const SideMeasure& side, Continuity wanted, const Tolerance& tolerance) {
    double score = side.gap / tolerance.linear;
    if (wanted >= Continuity::G1) {
        score = std::max(score, side.angle / tolerance.angular);
    }
    if (wanted >= Continuity::G2) {
        score = std::max(score, side.curvature_mismatch / tolerance.curvature);
    }
    return score;
}

Result<TrialMeasure> try_fill(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                              const FillResult& fill, const Tolerance& tolerance,
                              const Progress& progress) {
    return occ::guarded("trying the new face", [&]() -> Result<TrialMeasure> {
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

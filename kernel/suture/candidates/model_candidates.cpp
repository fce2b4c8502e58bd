#include "suture/candidates/model_candidates.h"

#include "suture/candidates/carriers.h"
#include "suture/candidates/twins.h"
#include "suture/occ/guard.h"
#include "suture/ribbon/noise.h"

#include <TopTools_MapOfShape.hxx>

namespace suture {

Result<std::vector<Candidate>> find_candidates(const TopoDS_Shape& model,
                                               const occ::Numbering& numbering,
                                               const std::vector<BoundaryLoop>& loops,
                                               const Hole& hole, Scope scope) {
    return occ::guarded("looking for the lost surface in the model", [&] {
        std::vector<TopoDS_Face> faces;
        TopTools_MapOfShape seen;
        for (const BoundaryLoop& loop : loops) {
            for (const BoundaryEdge& edge : loop.edges) {
                if (!edge.face.IsNull() && seen.Add(edge.face)) {
                    faces.push_back(edge.face);
                }
            }
        }
        if (scope == Scope::Model) {
            for (const TopoDS_Face& face : occ::faces_of(model)) {
                if (seen.Add(face)) {
                    faces.push_back(face);
                }
            }
        }
        std::vector<Candidate> candidates =
            find_carriers(faces, numbering, hole, measure_noise(loops, hole),
                          /*offsets=*/scope == Scope::Model);
        if (scope == Scope::Model) {
            for (Candidate& twin : find_twins(faces, numbering, loops, hole)) {
                candidates.push_back(std::move(twin));
            }
        }
        return candidates;
    });
}

}  // namespace suture

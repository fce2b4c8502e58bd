#pragma once

#include "suture/base/result.h"
#include "suture/detect/boundary_loop.h"
#include "suture/faces/placement.h"
#include "suture/model/patch.h"
#include "suture/model/ribbon.h"

#include <TopoDS_Face.hxx>

#include <memory>
#include <vector>

namespace suture {

/// New faces for a hole, built on the hole's own edges and vertices: the edges get a further
/// pcurve, and a larger tolerance where they miss the new surface by more than theirs; nothing else
/// of them changes.
struct NewFaces {
    std::vector<TopoDS_Face> faces;     ///< oriented outwards
    double max_gap = 0.0;               ///< largest distance edge to new surface, model units
    int grown_edges = 0;                ///< edges that needed a larger tolerance for that
    double grown_tolerance = 0.0;       ///< the largest of these tolerances
    std::vector<Placement> placements;  ///< of the edges, in the order of the patches' wires
};

/// New faces whose place on the hole's edges is known, but which are not made yet.
class PlacedFaces {
  public:
    PlacedFaces(PlacedFaces&& other) noexcept;
    PlacedFaces& operator=(PlacedFaces&& other) noexcept;
    ~PlacedFaces();

    /// Makes them, once. Changes the edges.
    [[nodiscard]] Result<NewFaces> make();

  private:
    class Maker;
    explicit PlacedFaces(std::unique_ptr<Maker> maker);
    friend Result<PlacedFaces> place_faces(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                                           const FillResult& result,
                                           const std::vector<Placement>& known);

    std::unique_ptr<Maker> maker_;
};

/// Finds the curves of the edges on the new surfaces: most of the work. It changes nothing, so that
/// it can be done for many holes at once.
///
/// Input    loops: the hole's, in the order of hole.loops; result: what a fill method made of them.
///          All three have to stay as they are until the faces are made. known: what was found
///          before for the same result on copies of the edges; taken where it holds.
/// Refuses  a patch whose surface or trimming curves OCCT cannot take.
[[nodiscard]] Result<PlacedFaces> place_faces(const std::vector<BoundaryLoop>& loops,
                                              const Hole& hole, const FillResult& result,
                                              const std::vector<Placement>& known = {});

/// Both steps in one.
///
/// Input    loops: the hole's, in the order of hole.loops; result: what a fill method made of them.
/// Refuses  a patch whose surface or trimming curves OCCT cannot take.
[[nodiscard]] Result<NewFaces> make_faces(const std::vector<BoundaryLoop>& loops, const Hole& hole,
                                          const FillResult& result);

}  // namespace suture

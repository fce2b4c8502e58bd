#pragma once

#include "suture/model/continuity.h"
#include "suture/model/implicit_form.h"
#include "suture/model/surface.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suture {

/// Where a ribbon runs in a patch's domain: (u, v) as a function of the ribbon's own s in [0,1].
using TrimCurve = std::function<Eigen::Vector2d(double s)>;

/// Where an inner edge starts or ends: in a corner of the hole, or in a vertex of its own.
struct Node {
    int loop = -1;  ///< where ribbon `index` of this loop starts; -1: inner vertex `index`
    int index = 0;
};

/// An edge that a fill adds between its patches, or along which a closed patch meets itself.
struct InnerEdge {
    Node from, to;
};

/// One edge of a patch's outline.
struct EdgeUse {
    int loop = -1;           ///< ribbon `index` of this loop; -1: inner edge `index`
    int index = 0;           ///< 0-based
    bool backwards = false;  ///< walked from its end to its start; never a ribbon
    /// (u, v) for the edge's own s in [0,1], which runs from its start to its end either way. Both
    /// patches of an inner edge have the same point at the same s.
    TrimCurve at;
    /// The outline goes on along a border of the domain that is one point, to where the next use
    /// starts.
    bool pole_after = false;
};

/// A surface of the model in its own form: occ/model_surface.h.
struct ModelSurface;

/// One surface and its outline: sides of the hole and inner edges.
struct Patch {
    Surface surface;
    bool reversed = false;   ///< the outward normal is -(X_u x X_v)
    bool exact = true;       ///< false where the surface approximates the method's own form
    double fit_error = 0.0;  ///< of that approximation, in model units
    /// The interior lies to the left of each, or to the right where `reversed`. An inner edge that
    /// is used twice by one patch, once backwards, is a seam: where a patch that goes all the way
    /// around its surface is cut open, from corner to corner or to a pole.
    std::vector<std::vector<EdgeUse>> wires;
    /// What the surface is a copy of as a B-spline, if the model has it in another form.
    std::shared_ptr<const ModelSurface> original = {};
};

/// All sides of a loop in their order, as a wire.
[[nodiscard]] std::vector<EdgeUse> wire_of_loop(int loop, std::vector<TrimCurve> trims);

/// What a fill method made of a hole.
struct FillResult {
    std::vector<Patch> patches;  ///< each has an edge of the hole or of a patch before it
    std::vector<Eigen::Vector3d> inner_vertices;
    std::vector<InnerEdge> inner_edges;
    std::optional<ImplicitForm> implicit;  ///< of a method that has one
    std::vector<std::string> notes;  ///< what the user should know: relaxed corners, chosen counts
};

}  // namespace suture

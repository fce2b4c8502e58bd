#pragma once

#include "suture/detect/seams.h"
#include "suture/detect/shell_graph.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace suture {

/// A face that shares no edge with another, and the compound of the model that it lies in. Faces
/// of one compound are sewn first: in OpenVSP's files other compounds repeat the same edges.
struct LooseFace {
    TopoDS_Face face;
    int group = 0;
};

/// The loose faces of a shape.
struct Loose {
    std::vector<LooseFace> faces;
    std::vector<int> uses;  ///< their free edge uses
    int free_edges = 0;     ///< of the whole shape
    int groups = 0;
};

/// Result  faces that share no edge with another and have a free one.
[[nodiscard]] Loose find_loose(const TopoDS_Shape& shape, const ShellGraph& graph);

/// The widest gap that is a seam by its length and stays below the features.
///
/// Input  partners: of the loose uses.
[[nodiscard]] double choose_tolerance(const std::vector<EdgePartner>& partners,
                                      double model_diagonal);

/// Gives each face that lies within a body, all its edges on edges where others already meet, a
/// group of its own: sewing would take it for one of the body's faces.
void set_membranes_apart(const ShellGraph& graph, double tolerance, Loose& loose);

}  // namespace suture

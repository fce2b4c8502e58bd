#pragma once

#include "suture/occ/topology.h"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <array>
#include <vector>

namespace suture {

/// One use of an edge by a face (a coedge), oriented as the face goes: material on the left, seen
/// against the face's outward normal.
struct Coedge {
    TopoDS_Edge edge;
    int face = 0;   ///< index into ShellGraph::faces
    int next = -1;  ///< the use that follows around the face, -1 where the wire is open
    int previous = -1;
    int mate = -1;  ///< the other use of the same edge, -1: there is none
    bool degenerated = false;
    bool free = false;  ///< the only use of its edge by the shape, and no seam
};

/// One of the two ends of an edge use.
struct UseEnd {
    int use = -1;
    bool at_start = false;

    bool operator==(const UseEnd&) const = default;
};

/// The faces of a shape and how they hang together, across edges and around vertices.
struct ShellGraph {
    std::vector<TopoDS_Face> faces;  ///< in TopExp's order, oriented as in the shape
    std::vector<Coedge> uses;
    std::vector<int> component;    ///< per face: which connected shell it belongs to
    std::vector<int> sign;         ///< per face: -1 where it is turned against most of its shell
    std::vector<bool> orientable;  ///< per component
    int components = 0;
};

/// Input  any shape; a face or an edge that it holds several times counts once.
/// Result edges that more than two uses share are mated by pairs, the straightest first; an odd one
///        out has no mate and is not free.
[[nodiscard]] ShellGraph make_shell_graph(const TopoDS_Shape& shape);

/// What was met on the way around a vertex through the faces.
struct Fan {
    UseEnd last;         ///< the end of the use without mate that the fan ends at, or use -1
    double angle = 0.0;  ///< the angle that the faces fill, in radians
};

/// Walks around the vertex at `from`, through the material, to the other border of the fan of
/// faces.
[[nodiscard]] Fan walk_fan(const ShellGraph& graph, UseEnd from);

}  // namespace suture

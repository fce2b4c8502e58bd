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
    bool free = false;  ///< the only use of its edge by its shell, and no other shell is open there
};

/// One of the two ends of an edge use.
struct UseEnd {
    int use = -1;
    bool at_start = false;

    bool operator==(const UseEnd&) const = default;
};

/// The faces of a shape and how they hang together, across edges and around vertices.
struct ShellGraph {
    std::vector<TopoDS_Face> faces;  ///< in TopExp's order, oriented as in the shape; one that
                                     ///< bounds two bodies stands here for each of their shells
    std::vector<int> shell;          ///< per face: number of the shell that it lies in, -1: in none
    std::vector<int> solid;          ///< per face: the same of the solid
    std::vector<Coedge> uses;
    std::vector<int> component;    ///< per face: which connected shell it belongs to
    std::vector<int> sign;         ///< per face: -1 where it is turned against most of its shell
    std::vector<bool> orientable;  ///< per component
    int components = 0;
};

/// Input  any shape; a shell that it holds several times counts once, and so does a face or an edge
///        within a shell.
/// Result each shell by itself first: of the uses of an edge those of one shell are mated, the
///        straightest first where there are more than two. What is single in its shell is mated
///        with what is single in another, or is free. The odd one out of three uses of one shell
///        has no mate and is not free.
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

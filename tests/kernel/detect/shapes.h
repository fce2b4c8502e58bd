#pragma once

#include "suture/detect/find_loops.h"
#include "suture/occ/topology.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include <array>
#include <initializer_list>
#include <map>
#include <set>
#include <utility>
#include <vector>

/// Small shapes with known loops, and what must hold for every loop.
namespace suture::test {

inline TopoDS_Compound compound_of(const std::vector<TopoDS_Shape>& parts) {
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& part : parts) {
        builder.Add(compound, part);
    }
    return compound;
}

inline TopoDS_Shell shell_of(const std::vector<TopoDS_Face>& faces) {
    BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (const TopoDS_Face& face : faces) {
        builder.Add(shell, face);
    }
    return shell;
}

/// A shell of the faces of a shape but those of the given numbers.
inline TopoDS_Shell without_faces(const TopoDS_Shape& shape, const std::set<int>& numbers) {
    std::vector<TopoDS_Face> kept;
    const std::vector<TopoDS_Face> all = occ::faces_of(shape);
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        if (!numbers.contains(i + 1)) {
            kept.push_back(all[i]);
        }
    }
    return shell_of(kept);
}

/// Plane polygons that share the edges between points of the same indices.
class PolygonMesh {
  public:
    explicit PolygonMesh(const std::vector<gp_Pnt>& points) {
        for (const gp_Pnt& p : points) {
            vertices_.push_back(BRepBuilderAPI_MakeVertex(p));
        }
    }

    /// Rings of point indices: the outer one, then holes.
    TopoDS_Face face(const std::vector<std::vector<int>>& rings) {
        BRepBuilderAPI_MakeFace maker(wire(rings.front()), /*OnlyPlane=*/true);
        for (std::size_t i = 1; i < rings.size(); ++i) {
            maker.Add(wire(rings[i]));
        }
        return maker.Face();
    }
    TopoDS_Face face(const std::vector<int>& ring) {
        return face(std::vector<std::vector<int>>{ring});
    }

  private:
    TopoDS_Edge edge(int a, int b) {
        const auto key = std::minmax(a, b);
        if (!edges_.contains(key)) {
            edges_[key] = BRepBuilderAPI_MakeEdge(vertices_[key.first], vertices_[key.second]);
        }
        const TopoDS_Edge& shared = edges_[key];
        return a < b ? shared : TopoDS::Edge(shared.Reversed());
    }
    TopoDS_Wire wire(const std::vector<int>& ring) {
        BRep_Builder builder;
        TopoDS_Wire result;
        builder.MakeWire(result);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            builder.Add(result, edge(ring[i], ring[(i + 1) % ring.size()]));
        }
        result.Closed(true);
        return result;
    }

    std::vector<TopoDS_Vertex> vertices_;
    std::map<std::pair<int, int>, TopoDS_Edge> edges_;
};

/// A face that shares nothing with another.
inline TopoDS_Face polygon(const std::vector<gp_Pnt>& points) {
    PolygonMesh mesh(points);
    std::vector<int> ring(points.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
        ring[i] = static_cast<int>(i);
    }
    return mesh.face(ring);
}

/// Two boxes with one upright edge in common, the one without the face `missing`, the other closed.
inline TopoDS_Compound boxes_with_common_edge(bool first_is_open, std::size_t missing) {
    PolygonMesh mesh({{0, 0, 0},
                      {10, 0, 0},
                      {10, 10, 0},
                      {0, 10, 0},
                      {0, 0, 10},
                      {10, 0, 10},
                      {10, 10, 10},
                      {0, 10, 10},
                      {20, 10, 0},
                      {20, 20, 0},
                      {10, 20, 0},
                      {20, 10, 10},
                      {20, 20, 10},
                      {10, 20, 10}});
    const std::vector<std::vector<int>> one{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    const std::vector<std::vector<int>> two{{2, 10, 9, 8},  {6, 11, 12, 13}, {2, 8, 11, 6},
                                            {8, 9, 12, 11}, {9, 10, 13, 12}, {10, 2, 6, 13}};
    std::vector<TopoDS_Face> first;
    std::vector<TopoDS_Face> second;
    for (std::size_t i = 0; i < 6; ++i) {
        if (!first_is_open || i != missing) {
            first.push_back(mesh.face(one[i]));
        }
        if (first_is_open || i != missing) {
            second.push_back(mesh.face(two[i]));
        }
    }
    return compound_of({shell_of(first), shell_of(second)});
}

/// Each face copied, so that none shares an edge with another.
inline TopoDS_Compound loosened(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Shape> parts;
    for (const TopoDS_Face& face : occ::faces_of(shape)) {
        parts.push_back(BRepBuilderAPI_Transform(face, gp_Trsf(), /*Copy=*/true).Shape());
    }
    return compound_of(parts);
}

inline std::vector<BoundaryLoop> loops_of(const TopoDS_Shape& shape) {
    const occ::Numbering numbering(shape);
    auto loops = find_loops(shape, numbering);
    EXPECT_TRUE(loops.has_value()) << loops.error().message;
    return loops.value_or(std::vector<BoundaryLoop>());
}

/// Kind and number of sides of each loop, sorted.
using Census = std::multiset<std::pair<std::string, std::size_t>>;

inline Census census(const std::vector<BoundaryLoop>& loops) {
    Census result;
    for (const BoundaryLoop& loop : loops) {
        result.emplace(to_string(loop.kind), loop.edges.size());
    }
    return result;
}
inline Census census(const TopoDS_Shape& shape) {
    return census(loops_of(shape));
}

/// Head to tail, each edge against its use in its face.
inline void expect_well_walked(const BoundaryLoop& loop) {
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
        const BoundaryEdge& here = loop.edges[i];
        const BoundaryEdge& next = loop.edges[(i + 1) % loop.edges.size()];
        const TopoDS_Vertex end = TopExp::LastVertex(here.edge, true);
        const TopoDS_Vertex start = TopExp::FirstVertex(next.edge, true);
        const double apart = BRep_Tool::Pnt(end).Distance(BRep_Tool::Pnt(start));
        EXPECT_TRUE(end.IsSame(start) || apart <= BRep_Tool::Tolerance(end))
            << "edge " << here.edge_number << " does not lead to edge " << next.edge_number;
        int uses = 0;
        for (TopExp_Explorer it(here.face, TopAbs_EDGE); it.More(); it.Next()) {
            if (it.Current().IsSame(here.edge)) {
                ++uses;
                EXPECT_NE(it.Current().Orientation(), here.edge.Orientation());
            }
        }
        EXPECT_EQ(uses, 1);
        EXPECT_GT(here.edge_number, 0);
        EXPECT_GT(here.face_number, 0);
    }
}

inline TopoDS_Shape moved(const TopoDS_Shape& shape, double scale) {
    gp_Trsf rotation;
    rotation.SetRotation(gp_Ax1(gp_Pnt(0.3, -0.7, 1.1), gp_Dir(1.0, 2.0, -0.5)), 0.8);
    gp_Trsf scaling;
    scaling.SetScale(gp_Pnt(0.0, 0.0, 0.0), scale);
    return BRepBuilderAPI_Transform(shape, scaling * rotation, /*Copy=*/true).Shape();
}

/// The same faces in reverse order.
inline TopoDS_Shape renumbered(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces = occ::faces_of(shape);
    std::reverse(faces.begin(), faces.end());
    return shell_of(faces);
}

}  // namespace suture::test

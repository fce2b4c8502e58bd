#include "files/mesh.h"

#include "files/mesh_repair.h"
#include "suture/occ/guard.h"
#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <limits>
#include <numeric>
#include <optional>

namespace suture::io {

namespace {

/// Of the diagonal: fine enough that a fillet looks round at the size of a screen.
constexpr double kRelativeDeflection = 1e-3;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Points that turn out to be one are united; each set is known by its smallest member.
class PointSets {
  public:
    std::uint32_t add(int count) {
        const auto first = static_cast<std::uint32_t>(parent_.size());
        parent_.resize(parent_.size() + static_cast<std::size_t>(count));
        std::iota(parent_.begin() + first, parent_.end(), first);
        return first;
    }
    std::uint32_t find(std::uint32_t point) {
        while (parent_[point] != point) {
            point = parent_[point] = parent_[parent_[point]];
        }
        return point;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    [[nodiscard]] std::size_t size() const { return parent_.size(); }

  private:
    std::vector<std::uint32_t> parent_;
};

/// Sews the triangulations of a shape's faces together along the edges that they share.
class MeshSewer {
  public:
    explicit MeshSewer(const TopoDS_Shape& shape) : numbers_(shape) {
        TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
        edge_points_.resize(static_cast<std::size_t>(numbers_.edges.Extent()) + 1);
        vertex_points_.resize(static_cast<std::size_t>(vertices_.Extent()) + 1, kNone);
    }

    Result<void> add(const TopoDS_Face& face) {
        TopLoc_Location location;
        const occ::Handle<Poly_Triangulation> grid = BRep_Tool::Triangulation(face, location);
        if (grid.IsNull() || grid->NbTriangles() == 0) {
            return {};  // triangulate tells of it
        }
        const std::uint32_t first = sets_.add(grid->NbNodes());
        const gp_Trsf move = location.Transformation();
        for (int i = 1; i <= grid->NbNodes(); ++i) {
            const gp_Pnt point = grid->Node(i).Transformed(move);
            points_.push_back({point.X(), point.Y(), point.Z()});
        }
        const bool reversed = (face.Orientation() == TopAbs_REVERSED) != move.IsNegative();
        for (int i = 1; i <= grid->NbTriangles(); ++i) {
            std::array<int, 3> node{};
            grid->Triangle(i).Get(node[0], node[reversed ? 2 : 1], node[reversed ? 1 : 2]);
            auto& triangle = triangles_.emplace_back();
            faces_.push_back(static_cast<std::uint32_t>(numbers_.of(face)));
            for (std::size_t k = 0; k < node.size(); ++k) {
                triangle[k] = first + static_cast<std::uint32_t>(node[k] - 1);
            }
        }
        for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
            const TopoDS_Edge& side = TopoDS::Edge(edge.Current());
            const occ::Handle<Poly_PolygonOnTriangulation> polygon =
                BRep_Tool::PolygonOnTriangulation(side, grid, location);
            if (polygon.IsNull()) {
                return fail(ErrorCode::Internal, "edge {} of face {} was not meshed",
                            numbers_.of(side), numbers_.of(face));
            }
            if (Result<void> joined = join(side, *polygon, first); !joined) {
                return joined;
            }
        }
        return {};
    }

    /// Triangles so far, before points are united: the beginning of the next body.
    [[nodiscard]] std::size_t triangles() const { return triangles_.size(); }

    /// Turns the triangles from `begin` on if they enclose a negative volume.
    void turn_outward(std::size_t begin) {
        double volume = 0.0;
        for (std::size_t i = begin; i < triangles_.size(); ++i) {
            const auto& [a, b, c] = triangles_[i];
            volume += signed_volume(points_[sets_.find(a)], points_[sets_.find(b)],
                                    points_[sets_.find(c)]);
        }
        for (std::size_t i = begin; volume < 0.0 && i < triangles_.size(); ++i) {
            std::swap(triangles_[i][1], triangles_[i][2]);
        }
    }

    /// One point for each set, and the triangles that are left.
    [[nodiscard]] Mesh mesh() {
        Mesh result;
        std::vector<std::uint32_t> number(sets_.size(), kNone);
        const auto number_of = [&](std::uint32_t point) {
            const std::uint32_t set = sets_.find(point);
            if (number[set] == kNone) {
                number[set] = static_cast<std::uint32_t>(result.points.size());
                result.points.push_back(points_[set]);
            }
            return number[set];
        };
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const auto& [a, b, c] = triangles_[i];
            const std::array set{sets_.find(a), sets_.find(b), sets_.find(c)};
            if (set[0] != set[1] && set[1] != set[2] && set[2] != set[0]) {
                result.triangles.push_back({number_of(a), number_of(b), number_of(c)});
                result.faces.push_back(faces_[i]);
            }
        }
        return result;
    }

  private:
    using Point = std::array<double, 3>;

    /// Of the tetrahedron over the first point of all, so that far-off models lose no digits.
    [[nodiscard]] double signed_volume(const Point& a, const Point& b, const Point& c) const {
        const Point& o = points_.front();
        const gp_Vec x(a[0] - o[0], a[1] - o[1], a[2] - o[2]);
        const gp_Vec y(b[0] - o[0], b[1] - o[1], b[2] - o[2]);
        const gp_Vec z(c[0] - o[0], c[1] - o[1], c[2] - o[2]);
        return x.DotCross(y, z) / 6.0;
    }

    /// The points of an edge in one face are those that it has in the others, in the same order. A
    /// degenerated edge has two points only, both its vertex.
    Result<void> join(const TopoDS_Edge& edge, const Poly_PolygonOnTriangulation& polygon,
                      std::uint32_t first) {
        std::vector<std::uint32_t> points;
        for (int i = 1; i <= polygon.NbNodes(); ++i) {
            points.push_back(first + static_cast<std::uint32_t>(polygon.Node(i) - 1));
        }
        const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
        join_vertex(TopExp::FirstVertex(forward), points.front());
        join_vertex(TopExp::LastVertex(forward), points.back());
        auto& known = edge_points_[static_cast<std::size_t>(numbers_.of(edge))];
        if (known.empty()) {
            known = std::move(points);
            return {};
        }
        if (known.size() != points.size()) {
            return fail(ErrorCode::Internal, "edge {} has {} points in one face and {} in another",
                        numbers_.of(edge), known.size(), points.size());
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            sets_.unite(known[i], points[i]);
        }
        return {};
    }

    void join_vertex(const TopoDS_Vertex& vertex, std::uint32_t point) {
        if (vertex.IsNull()) {
            return;  // an edge without end: nothing to join
        }
        auto& known = vertex_points_[static_cast<std::size_t>(vertices_.FindIndex(vertex))];
        known = known == kNone ? point : known;
        sets_.unite(known, point);
    }

    occ::Numbering numbers_;
    TopTools_IndexedMapOfShape vertices_;
    PointSets sets_;
    std::vector<Point> points_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<std::uint32_t> faces_;
    std::vector<std::vector<std::uint32_t>> edge_points_;
    std::vector<std::uint32_t> vertex_points_;
};

Result<Mesh> sew_mesh(const TopoDS_Shape& shape) {
    MeshSewer sewer(shape);
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
        const std::size_t begin = sewer.triangles();
        for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next()) {
            if (Result<void> added = sewer.add(TopoDS::Face(face.Current())); !added) {
                return tl::unexpected(added.error());
            }
        }
        sewer.turn_outward(begin);
    }
    for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next()) {
        if (Result<void> added = sewer.add(TopoDS::Face(face.Current())); !added) {
            return tl::unexpected(added.error());
        }
    }
    return sewer.mesh();
}

Result<Mesh> mesh_once(const TopoDS_Shape& shape, double deflection, double angle) {
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape, false, false).Shape();
    std::vector<UnmeshedFace> left_out = triangulate(copy, deflection, angle);
    return sew_mesh(copy).map([&](Mesh&& mesh) {
        mesh.facts.left_out = std::move(left_out);
        return std::move(mesh);
    });
}

bool is_complete(const Mesh& mesh) {
    return std::ranges::none_of(mesh.facts.left_out, &UnmeshedFace::area);
}

/// Flatter triangles are no triangles any more once a file has their points with single precision.
double least_height(const Mesh& mesh) {
    double largest = 0.0;
    for (const auto& point : mesh.points) {
        for (const double x : point) {
            largest = std::max(largest, std::abs(x));
        }
    }
    return 2.0 * static_cast<double>(std::numeric_limits<float>::epsilon()) * largest;
}

}  // namespace

double usual_deflection(const TopoDS_Shape& shape) {
    return kRelativeDeflection * occ::diagonal(shape);
}

Result<Mesh> make_mesh(const TopoDS_Shape& shape, const MeshOptions& options) {
    return occ::guarded("meshing", [&]() -> Result<Mesh> {
        const double wanted =
            options.deflection > 0.0 ? options.deflection : usual_deflection(shape);
        // Coarser points of one face's edges are coarser in its neighbours too, and so on: all is.
        Result<Mesh> best = mesh_once(shape, wanted, options.angular_deflection);
        double deflection = wanted;
        for (const double factor : {2.0, 4.0}) {
            if (best && is_complete(*best)) {
                break;
            }
            Result<Mesh> other = mesh_once(shape, factor * wanted, options.angular_deflection);
            if (other && (!best || is_complete(*other))) {
                best = std::move(other);
                deflection = factor * wanted;
            }
        }
        if (!best) {
            return best;
        }
        MeshFacts& facts = best->facts;
        facts.deflection = deflection;
        facts.needles = remove_back_to_back(*best);
        facts.needles += remove_needles(*best, least_height(*best));
        facts.open_edges = count_open_edges(*best);
        facts.triangles = best->triangles.size();
        facts.points = best->points.size();
        return best;
    });
}

}  // namespace suture::io

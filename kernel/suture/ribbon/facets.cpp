#include "suture/ribbon/facets.h"

#include "suture/base/tolerance.h"
#include "suture/occ/convert.h"
#include "suture/occ/topology.h"
#include "suture/ribbon/extract.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

using Eigen::Vector3d;

/// Fewer planes around a hole are walls of a part that was drawn with planes.
constexpr std::size_t kFewestSides = 5;

/// Facets are turned against each other by at most this, and most of them by at least that.
const double kLargestTurn = radians(40.0);
const double kLeastTurn = radians(0.5);
constexpr double kMost = 0.7;

/// An opening that is as flat as this share of its diameter is closed by a lid.
constexpr double kPlanar = 1e-3;

/// Vertices so many edges from the border tell the shape that is meant.
constexpr int kRings = 2;

/// The polynomial has at least so many vertices for each of its coefficients.
constexpr int kOverdetermined = 2;

/// Shares of the hole's diameter: how far a vertex may be from the shape that is meant; how densely
/// points are taken of it, and how far from the border.
constexpr double kFarOff = 0.03;
constexpr double kGrid = 0.09;
constexpr double kInside = 0.12;

bool is_straight(const BoundaryEdge& side) {
    return BRepAdaptor_Curve(side.edge).GetType() == GeomAbs_Line &&
           BRepAdaptor_Surface(side.face, Standard_False).GetType() == GeomAbs_Plane;
}

bool is_planar(const RibbonLoop& loop) {
    Vector3d centre = Vector3d::Zero();
    Vector3d normal = Vector3d::Zero();
    for (const Ribbon& side : loop.ribbons) {
        centre += side.at(0.0).point / static_cast<double>(loop.ribbons.size());
    }
    double size = 0.0;
    for (const Ribbon& side : loop.ribbons) {
        const Vector3d a = side.at(0.0).point - centre;
        normal += a.cross(side.at(1.0).point - centre);
        size = std::max(size, a.norm());
    }
    normal.normalize();
    return std::ranges::all_of(loop.ribbons, [&](const Ribbon& side) {
        return std::abs(normal.dot(side.at(0.0).point - centre)) <= kPlanar * size;
    });
}

/// The vertices within so many edges of a border.
std::vector<Vector3d> vertices_around(const TopoDS_Shape& shape, const BoundaryLoop& border) {
    TopTools_IndexedDataMapOfShapeListOfShape edges;
    TopExp::MapShapesAndAncestors(shape, TopAbs_VERTEX, TopAbs_EDGE, edges);
    TopTools_IndexedMapOfShape found;
    for (const BoundaryEdge& side : border.edges) {
        found.Add(TopExp::FirstVertex(side.edge, Standard_True));
    }
    int next = 1;
    for (int ring = 0; ring < kRings; ++ring) {
        for (const int end = found.Extent(); next <= end; ++next) {
            for (const TopoDS_Shape& edge : edges.FindFromKey(found(next))) {
                found.Add(TopExp::FirstVertex(TopoDS::Edge(edge)));
                found.Add(TopExp::LastVertex(TopoDS::Edge(edge)));
            }
        }
    }
    std::vector<Vector3d> points;
    for (int i = 1; i <= found.Extent(); ++i) {
        points.push_back(occ::from_occ(BRep_Tool::Pnt(TopoDS::Vertex(found(i)))));
    }
    return points;
}

/// The opening's plane, in which lengths are shares of the hole's diameter.
struct RimFrame {
    Vector3d centre = Vector3d::Zero();
    Eigen::Matrix3d axes;  ///< the third one leaves the opening
    double unit = 1.0;

    [[nodiscard]] Vector3d in(const Vector3d& p) const {
        return axes.transpose() * (p - centre) / unit;
    }
    [[nodiscard]] Vector3d out(const Vector3d& p) const { return centre + axes * p * unit; }
};

RimFrame frame_of(const RibbonLoop& border, double diameter) {
    RimFrame frame;
    frame.unit = diameter;
    for (const Ribbon& side : border.ribbons) {
        frame.centre += side.at(0.0).point / static_cast<double>(border.ribbons.size());
    }
    Vector3d normal = Vector3d::Zero();
    for (const Ribbon& side : border.ribbons) {
        normal += (side.at(0.0).point - frame.centre).cross(side.at(1.0).point - frame.centre);
    }
    normal.normalize();
    frame.axes.col(0) = normal.unitOrthogonal();
    frame.axes.col(1) = normal.cross(frame.axes.col(0));
    frame.axes.col(2) = normal;
    return frame;
}

/// A polynomial in two variables, of all terms up to a degree.
class HeightPolynomial {
  public:
    /// The one whose values are nearest to the third coordinates of points.
    HeightPolynomial(int degree, const std::vector<Vector3d>& points) : degree_(degree) {
        const auto count = static_cast<Eigen::Index>(points.size());
        Eigen::MatrixXd rows(count, terms(degree));
        Eigen::VectorXd values(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const Vector3d& p = points[static_cast<std::size_t>(i)];
            rows.row(i) = monomials(p.x(), p.y());
            values[i] = p.z();
        }
        coefficients_ = rows.colPivHouseholderQr().solve(values);
    }

    [[nodiscard]] double at(double x, double y) const { return monomials(x, y) * coefficients_; }

    [[nodiscard]] static int terms(int degree) { return (degree + 1) * (degree + 2) / 2; }

  private:
    [[nodiscard]] Eigen::RowVectorXd monomials(double x, double y) const {
        Eigen::RowVectorXd row(terms(degree_));
        Eigen::Index next = 0;
        for (int i = 0; i <= degree_; ++i) {
            for (int j = 0; i + j <= degree_; ++j) {
                row[next++] = std::pow(x, i) * std::pow(y, j);
            }
        }
        return row;
    }

    int degree_;
    Eigen::VectorXd coefficients_;
};

/// How far a point lies inside a polygon in the plane; below zero: outside.
double depth_in(const std::vector<Vector3d>& polygon, double x, double y) {
    const Eigen::Vector2d p(x, y);
    bool inside = false;
    double nearest = INFINITY;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d a = polygon[i].head<2>();
        const Eigen::Vector2d b = polygon[(i + 1) % polygon.size()].head<2>();
        const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (a + t * (b - a) - p).norm());
        const bool crosses = (a.y() > y) != (b.y() > y);
        if (crosses && x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
            inside = !inside;
        }
    }
    return inside ? nearest : -nearest;
}

}  // namespace

bool are_facets(const Hole& hole, const std::vector<BoundaryLoop>& loops) {
    if (loops.size() != 1) {
        return false;
    }
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const std::vector<BoundaryEdge>& sides = loops[l].edges;
        if (sides.size() < kFewestSides ||
            !std::ranges::all_of(
                sides, [](const BoundaryEdge& s) { return !s.face.IsNull() && is_straight(s); }) ||
            is_planar(hole.loops[l])) {
            return false;
        }
        std::size_t turned = 0;
        for (const Corner& corner : corners_of(hole.loops[l])) {
            if (corner.normal_mismatch > kLargestTurn) {
                return false;
            }
            turned += corner.normal_mismatch > kLeastTurn ? 1 : 0;
        }
        if (static_cast<double>(turned) < kMost * static_cast<double>(sides.size())) {
            return false;
        }
    }
    return true;
}

std::vector<Vector3d> points_between_facets(const TopoDS_Shape& shape,
                                            const std::vector<BoundaryLoop>& loops,
                                            const Hole& hole) {
    const RimFrame frame = frame_of(hole.loops.front(), hole.diameter);
    std::vector<Vector3d> known;
    for (const Vector3d& p : vertices_around(shape, loops.front())) {
        known.push_back(frame.in(p));
    }
    const auto enough = [&](int degree) {
        return static_cast<int>(known.size()) >= kOverdetermined * HeightPolynomial::terms(degree);
    };
    const int degree = enough(4) ? 4 : 2;
    if (!enough(degree)) {
        return {};
    }
    const HeightPolynomial meant(degree, known);
    if (std::ranges::any_of(known, [&](const Vector3d& p) {
            return std::abs(meant.at(p.x(), p.y()) - p.z()) > kFarOff;
        })) {
        return {};
    }
    std::vector<Vector3d> border;
    for (const Ribbon& side : hole.loops.front().ribbons) {
        border.push_back(frame.in(side.at(0.0).point));
    }
    std::vector<Vector3d> points;
    for (double x = -1.0; x <= 1.0; x += kGrid) {
        for (double y = -1.0; y <= 1.0; y += kGrid) {
            if (depth_in(border, x, y) > kInside) {
                points.push_back(frame.out({x, y, meant.at(x, y)}));
            }
        }
    }
    return points;
}

}  // namespace suture

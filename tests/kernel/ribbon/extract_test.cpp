#include "suture/ribbon/extract.h"

#include "suture/base/tolerance.h"
#include "suture/occ/convert.h"
#include "suture/occ/topology.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include <cmath>

namespace suture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Every edge of a solid as if the face on its other side were missing: walked against its use.
std::vector<BoundaryLoop> sides_of(const TopoDS_Shape& solid) {
    const occ::Numbering numbering(solid);
    std::vector<BoundaryLoop> result;
    for (TopExp_Explorer f(solid, TopAbs_FACE); f.More(); f.Next()) {
        const TopoDS_Face face = TopoDS::Face(f.Current());
        for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
            const TopoDS_Edge edge = TopoDS::Edge(e.Current());
            if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) {
                continue;
            }
            BoundaryLoop loop;
            loop.edges.push_back({TopoDS::Edge(edge.Reversed()),
                                  face,
                                  numbering.of(edge),
                                  numbering.of(face),
                                  {},
                                  0});
            result.push_back(loop);
        }
    }
    return result;
}

/// What closed form says of a solid: outward normal and second fundamental form at a point.
struct Truth {
    std::string kind;  ///< of the faces that it speaks of
    std::function<Vector3d(const Vector3d&)> normal;
    std::function<Matrix3d(const Vector3d&)> form;
};

/// Far from every tolerance, near against every test body.
constexpr double kStep = 0.03;

Matrix3d tangent_projector(const Vector3d& n) {
    return Matrix3d::Identity() - n * n.transpose();
}

void expect_side(const BoundaryLoop& side, const Truth& truth, double scale) {
    const auto hole = extract_hole({side});
    ASSERT_TRUE(hole) << hole.error().message;
    const Ribbon& ribbon = hole->loops.front().ribbons.front();
    const BRepAdaptor_Curve curve(side.edges.front().edge);
    const bool curved = ribbon.support && kind_name(ribbon.support->surface) == truth.kind;
    for (int k = 0; k <= 10; ++k) {
        const double s = k / 10.0;
        const RibbonPoint p = ribbon.at(s);
        const double t = ribbon.first + (ribbon.last - ribbon.first) * s;
        EXPECT_LT((p.point - occ::from_occ(curve.Value(t))).norm(), 1e-9 * scale);
        EXPECT_NEAR(p.normal.norm(), 1.0, 1e-12);
        EXPECT_LT(std::abs(p.normal.dot(p.tangent)), 1e-9 * p.tangent.norm());
        EXPECT_LT((p.inward - p.normal.cross(p.tangent.normalized())).norm(), 1e-12);
        EXPECT_LT((p.curvature * p.normal).norm() * scale, 1e-9);
        if (curved) {
            EXPECT_LT((p.normal - truth.normal(p.point)).norm(), 1e-9);
            EXPECT_LT((p.curvature - truth.form(p.point)).norm() * scale, 1e-7);
        }
    }
    // The hole lies to the inward side: a step outward of it lies in the face, one inward does not.
    const RibbonPoint middle = ribbon.at(0.47);
    const auto in_face = [&](double step) {
        const TopoDS_Face& face = side.edges.front().face;
        const GeomAPI_ProjectPointOnSurf project(
            occ::to_point(Vector3d(middle.point + step * scale * middle.inward)),
            BRep_Tool::Surface(face));
        double u = 0.0;
        double v = 0.0;
        project.LowerDistanceParameters(u, v);
        // Into the face's own period.
        double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
        BRepTools::UVBounds(face, u0, u1, v0, v1);
        const BRepAdaptor_Surface form(face);
        u = form.IsUPeriodic() ? 0.5 * (u0 + u1) + std::remainder(u - 0.5 * (u0 + u1), 2.0 * kPi)
                               : u;
        v = form.IsVPeriodic() ? 0.5 * (v0 + v1) + std::remainder(v - 0.5 * (v0 + v1), 2.0 * kPi)
                               : v;
        const BRepClass_FaceClassifier where(face, gp_Pnt2d(u, v), 1e-9);
        return where.State() == TopAbs_IN;
    };
    EXPECT_TRUE(in_face(-kStep));
    EXPECT_FALSE(in_face(kStep));
}

gp_Trsf placed(double scale, bool mirrored) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -1, 2)), 0.9);
    gp_Trsf size;
    size.SetScale(gp_Pnt(0, 0, 0), scale);
    gp_Trsf mirror;
    if (mirrored) {
        mirror.SetMirror(gp_Ax2(gp_Pnt(0, 1, 0), gp_Dir(0.3, 0.2, 1)));
    }
    return size * turn * mirror;
}

/// Checks a solid as it is, moved by geometry (also mirrored), moved by location, and reversed.
void expect_solid(const TopoDS_Shape& solid, const Truth& truth) {
    for (const auto& side : sides_of(solid)) {
        expect_side(side, truth, 1.0);
    }
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (const bool mirrored : {false, true}) {
            const gp_Trsf trsf = placed(scale, mirrored);
            Eigen::Matrix3d linear;
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) {
                    linear(i, j) = trsf.Value(i + 1, j + 1);
                }
            }
            const Matrix3d turn = linear / scale;  // orthogonal, also where mirrored
            const Vector3d shift = occ::from_occ(gp_Pnt(trsf.TranslationPart()));
            const auto back = [=](const Vector3d& p) -> Vector3d {
                return turn.transpose() * (p - shift) / scale;
            };
            const Truth moved{
                truth.kind,
                [=](const Vector3d& p) -> Vector3d { return turn * truth.normal(back(p)); },
                [=](const Vector3d& p) -> Matrix3d {
                    return turn * truth.form(back(p)) * turn.transpose() / scale;
                }};
            const TopoDS_Shape copy =
                BRepBuilderAPI_Transform(solid, trsf, /*Copy=*/Standard_True).Shape();
            SCOPED_TRACE(testing::Message() << "scale " << scale << " mirrored " << mirrored);
            for (const auto& side : sides_of(copy)) {
                expect_side(side, moved, scale);
            }
        }
    }
    for (const bool mirrored : {false, true}) {
        // A location leaves the faces' flags as they are: what it mirrors is turned inside out.
        const double outward = mirrored ? -1.0 : 1.0;
        const gp_Trsf rigid = placed(1.0, mirrored);
        const TopoDS_Shape located = solid.Moved(TopLoc_Location(rigid), /*theRaiseExc=*/false);
        const auto unmoved = [&](const Vector3d& p) -> Vector3d {
            return occ::from_occ(occ::to_point(p).Transformed(rigid.Inverted()));
        };
        const Truth turned{
            truth.kind,
            [&](const Vector3d& p) -> Vector3d {
                return outward *
                       occ::from_occ(
                           occ::to_direction(truth.normal(unmoved(p))).Transformed(rigid));
            },
            [&](const Vector3d& p) -> Matrix3d {
                Matrix3d R;
                for (int c = 0; c < 3; ++c) {
                    const Vector3d e = Vector3d::Unit(c);
                    R.col(c) = occ::from_occ(occ::to_direction(e).Transformed(rigid));
                }
                return outward * (R * truth.form(unmoved(p)) * R.transpose());
            }};
        SCOPED_TRACE(mirrored ? "located in a mirror" : "located");
        for (const auto& side : sides_of(located)) {
            expect_side(side, turned, 1.0);
        }
    }
    const Truth reversed{truth.kind,
                         [&](const Vector3d& p) -> Vector3d { return -truth.normal(p); },
                         [&](const Vector3d& p) -> Matrix3d { return -truth.form(p); }};
    SCOPED_TRACE("reversed");
    for (const auto& side : sides_of(solid.Reversed())) {
        expect_side(side, reversed, 1.0);
    }
}

TEST(ExtractHole, GivesTheBoxItsFlatSides) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Shape();
    // Six planes meet at the edges: no single normal there, so only position and sides are checked.
    expect_solid(box, {});
}

TEST(ExtractHole, GivesTheSphereItsNormalAndForm) {
    const TopoDS_Shape sphere =
        BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 2, 2)), 2.0, -0.7, 0.9, 4.0)
            .Shape();
    const Truth truth{
        "sphere", [](const Vector3d& p) -> Vector3d { return p.normalized(); },
        [](const Vector3d& p) -> Matrix3d { return -tangent_projector(p.normalized()) / 2.0; }};
    expect_solid(sphere, truth);
}

TEST(ExtractHole, GivesTheCylinderItsNormalAndFormAlsoAsASpline) {
    const TopoDS_Shape wall =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 2.0, 5.0, 2.2).Shape();
    const auto radial = [](const Vector3d& p) -> Vector3d {
        return Vector3d(p.x(), p.y(), 0.0).normalized();
    };
    Truth truth{"cylinder", radial, [=](const Vector3d& p) -> Matrix3d {
                    const Vector3d around = Vector3d::UnitZ().cross(radial(p));
                    return -around * around.transpose() / 2.0;
                }};
    expect_solid(wall, truth);
    truth.kind = "B-spline surface";
    // Only the wall: as splines its caps would be of the same kind.
    for (const TopoDS_Face& face : occ::faces_of(BRepBuilderAPI_NurbsConvert(wall).Shape())) {
        if (BRepAdaptor_Surface(face).VDegree() == 1 && BRepAdaptor_Surface(face).UDegree() == 2) {
            for (const auto& side : sides_of(face)) {
                expect_side(side, truth, 1.0);
            }
        }
    }
}

TEST(ExtractHole, GivesTheTorusItsNormalAndForm) {
    const TopoDS_Shape torus =
        BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 5.0, 1.5, -1.0, 1.2, 2.0)
            .Shape();
    const auto radial = [](const Vector3d& p) -> Vector3d {
        return Vector3d(p.x(), p.y(), 0.0).normalized();
    };
    const auto normal = [=](const Vector3d& p) -> Vector3d {
        return (p - 5.0 * radial(p)).normalized();
    };
    const Truth truth{"torus", normal, [=](const Vector3d& p) -> Matrix3d {
                          const Vector3d around = Vector3d::UnitZ().cross(radial(p));
                          const Vector3d along = normal(p).cross(around);
                          const double distance = Vector3d(p.x(), p.y(), 0.0).norm();
                          // Meusnier: the parallel circle's curvature, seen along the normal.
                          const double k = radial(p).dot(normal(p)) / distance;
                          return -k * around * around.transpose() - along * along.transpose() / 1.5;
                      }};
    expect_solid(torus, truth);
}

TEST(ExtractHole, FindsANormalNextToAPole) {
    // The octant of a sphere: one side runs into the pole, where the parametrisation is singular.
    const TopoDS_Shape octant =
        BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 2.0, 0.0, kPi / 2, 1.5)
            .Shape();
    for (const auto& side : sides_of(octant)) {
        const auto hole = extract_hole({side});
        ASSERT_TRUE(hole) << hole.error().message;
        const Ribbon& ribbon = hole->loops[0].ribbons[0];
        if (kind_name(ribbon.support->surface) != "sphere") {
            continue;
        }
        for (const double s : {0.0, 1e-9, 0.5, 1.0}) {
            const RibbonPoint p = ribbon.at(s);
            EXPECT_LT((p.normal - p.point.normalized()).norm(), 1e-6) << s;
            EXPECT_LT((p.curvature + tangent_projector(p.normal) / 2.0).norm(), 1e-3) << s;
        }
    }
}

TEST(ExtractHole, KnowsTheSupportOfEverySide) {
    const TopoDS_Shape cone =
        BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(1, 0, 0), gp_Dir(0, 1, 1)), 3.0, 1.0, 4.0, 2.0).Shape();
    int cones = 0;
    for (const auto& side : sides_of(cone)) {
        const auto hole = extract_hole({side});
        ASSERT_TRUE(hole);
        const Ribbon& ribbon = hole->loops[0].ribbons[0];
        ASSERT_TRUE(ribbon.support);
        cones += kind_name(ribbon.support->surface) == "cone" ? 1 : 0;
        for (const double s : {0.0, 0.3, 1.0}) {
            const Eigen::Vector2d uv = ribbon.support->uv(s);
            const SurfaceJet jet = evaluate(ribbon.support->surface, uv.x(), uv.y());
            EXPECT_LT((jet.point - ribbon.at(s).point).norm(), 1e-12);
            const Vector3d n = (ribbon.support->reversed ? -1.0 : 1.0) * jet.u.cross(jet.v);
            EXPECT_GT(n.normalized().dot(ribbon.at(s).normal), 0.999999);
        }
    }
    EXPECT_EQ(cones, 4);
}

TEST(CornersOf, MeasuresAnglesInsideTheHoleAndNormalMismatch) {
    // The top of a box is missing: four right angles, and walls that disagree by 90 degrees.
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Shape();
    const occ::Numbering numbering(box);
    TopoDS_Face top;
    for (const TopoDS_Face& face : occ::faces_of(box)) {
        const auto plane = occ::from_occ(BRep_Tool::Surface(face));
        const auto& frame = std::get<Plane>(plane->surface).frame;
        if (std::abs(frame.z.z()) > 0.9 && frame.origin.z() > 3.9) {
            top = face;
        }
    }
    ASSERT_FALSE(top.IsNull());
    TopTools_IndexedDataMapOfShapeListOfShape owners;
    TopExp::MapShapesAndAncestors(box, TopAbs_EDGE, TopAbs_FACE, owners);
    BoundaryLoop loop;
    // The top's own wire runs as the loop does: with the missing face on its left.
    TopExp_Explorer oriented(box, TopAbs_FACE);
    while (!oriented.Current().IsSame(top)) {
        oriented.Next();
    }
    std::vector<TopoDS_Edge> edges;
    for (TopExp_Explorer e(oriented.Current(), TopAbs_EDGE); e.More(); e.Next()) {
        edges.push_back(TopoDS::Edge(e.Current()));
    }
    std::vector<TopoDS_Edge> ordered = {edges.front()};
    while (ordered.size() < edges.size()) {
        const TopoDS_Vertex end = TopExp::LastVertex(ordered.back(), Standard_True);
        for (const TopoDS_Edge& e : edges) {
            if (TopExp::FirstVertex(e, Standard_True).IsSame(end)) {
                ordered.push_back(e);
                break;
            }
        }
    }
    for (const TopoDS_Edge& edge : ordered) {
        for (const TopoDS_Shape& owner : owners.FindFromKey(edge)) {
            if (!owner.IsSame(top)) {
                TopExp_Explorer f(box, TopAbs_FACE);
                while (!f.Current().IsSame(owner)) {
                    f.Next();
                }
                loop.edges.push_back(
                    {edge, TopoDS::Face(f.Current()), numbering.of(edge), 0, {}, 0});
            }
        }
    }
    const auto hole = extract_hole({loop});
    ASSERT_TRUE(hole);
    EXPECT_NEAR(hole->diameter, std::hypot(2.0, 3.0), 1e-12);
    const auto corners = corners_of(hole->loops[0]);
    ASSERT_EQ(corners.size(), 4U);
    for (const Corner& corner : corners) {
        EXPECT_NEAR(corner.angle, kPi / 2, 1e-9);
        EXPECT_NEAR(corner.normal_mismatch, kPi / 2, 1e-9);
        EXPECT_NEAR(corner.point.z(), 4.0, 1e-12);
    }
}

}  // namespace
}  // namespace suture

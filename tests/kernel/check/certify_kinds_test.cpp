// Certificates on every kind of surface and curve that OCCT has.
#include "suture/check/certify/taylor_model.h"

#include "kernel/check/certified.h"
#include "kernel/check/shapes.h"
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Geom2d_Line.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Lin2d.hxx>

namespace suture {
namespace {

/// Sound and tight, and no edge without a proof; also turned, and ten times as large.
void expect_all_certified(const TopoDS_Shape& shape) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1({1, 2, 3}, {1, 1, -2}), 0.7);
    gp_Trsf size;
    size.SetScale({-1, 4, 2}, 10.0);
    for (const TopoDS_Shape& same :
         {shape, BRepBuilderAPI_Transform(shape, size * turn, true).Shape()}) {
        const std::vector<Certified> edges = certify_all(same);
        EXPECT_FALSE(edges.empty());
        for (const Certified& edge : edges) {
            EXPECT_TRUE(edge.certificate.certified)
                << "Edge" << edge.certificate.edge << ": " << edge.certificate.reason;
        }
        expect_sound_and_tight(same, edges.size());
    }
}

/// A wave through (0 0 0) in the plane y = 0, level at both ends, at a distance from the z axis.
TopoDS_Edge wave(double from_axis) {
    TColgp_Array1OfPnt poles(1, 5);
    poles.SetValue(1, {from_axis, 0, 0});
    poles.SetValue(2, {from_axis + 1, 0, 0});
    poles.SetValue(3, {from_axis + 2, 0, 1.5});
    poles.SetValue(4, {from_axis + 3, 0, -0.5});
    poles.SetValue(5, {from_axis + 4, 0, -0.5});
    TColStd_Array1OfReal knots(1, 3);
    knots.SetValue(1, 0);
    knots.SetValue(2, 2);
    knots.SetValue(3, 3);
    TColStd_Array1OfInteger multiplicities(1, 3);
    multiplicities.SetValue(1, 4);
    multiplicities.SetValue(2, 1);
    multiplicities.SetValue(3, 4);
    return BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(poles, knots, multiplicities, 3)).Edge();
}

/// The wave, and a straight edge that goes on from its level end.
TopoDS_Wire wave_and_line(double from_axis) {
    const TopoDS_Edge curved = wave(from_axis);
    const TopoDS_Edge level =
        BRepBuilderAPI_MakeEdge(gp_Pnt(from_axis + 4, 0, -0.5), gp_Pnt(from_axis + 6, 0, -0.5))
            .Edge();
    BRepBuilderAPI_MakeWire wire(curved);
    wire.Add(level);
    return wire.Wire();
}

TEST(CertifyKinds, SurfacesOfExtrusionThatMeetSmoothly) {
    expect_all_certified(BRepPrimAPI_MakePrism(wave_and_line(1.0), gp_Vec(0.3, 5, 0.2)).Shape());
}

TEST(CertifyKinds, SurfacesOfRevolutionThatMeetSmoothlyAndTheirSeam) {
    const gp_Ax1 axis({0, 0, 0}, {0, 0, 1});
    expect_all_certified(BRepPrimAPI_MakeRevol(wave_and_line(2.0), axis, 1.2).Shape());
    expect_all_certified(BRepPrimAPI_MakeRevol(wave_and_line(2.0), axis).Shape());
}

/// A quarter of a cylinder, r = 5 + offset, as an offset surface, and the plane tangent to it.
TopoDS_Shape offset_into_plane(double offset) {
    const occ::Handle<Geom_Surface> quarter = new Geom_RectangularTrimmedSurface(
        new Geom_CylindricalSurface(gp_Ax3({0, 0, 0}, {0, 0, 1}), 5.0), 0.0, 0.5 * kPi, 0.0, 3.0);
    const auto around = shapes::face_on(
        new Geom_OffsetSurface(GeomConvert::SurfaceToBSplineSurface(quarter), offset));
    const gp_Ax3 frame({5 + offset, 0, 0}, {1, 0, 0}, {0, -1, 0});
    const auto flat = shapes::face_on(
        new Geom_RectangularTrimmedSurface(new Geom_Plane(frame), 0.0, 4.0, -3.0, 0.0));
    return shapes::sewn({around, flat}, 1e-6);
}

TEST(CertifyKinds, OffsetSurfacesThatMeetAPlaneSmoothly) {
    for (const double offset : {2.0, -1.5}) {
        const TopoDS_Shape shape = offset_into_plane(offset);
        expect_all_certified(shape);
        for (const Certified& edge : certify_all(shape)) {
            EXPECT_LT(edge.certificate.angle, radians(1e-3));
        }
    }
}

TEST(CertifyKinds, AnOffsetSurfaceWithASlotBesideItsBorder) {
    // A slot of 0.01 between two plates that are equal along it: the nearest points lie on the
    // offset surfaces' borders.
    const double slot = 0.01;
    gp_Trsf apart;
    apart.SetTranslation(gp_Vec(0, -2.0 - slot, 0));
    const occ::Handle<Geom_Surface> plate =
        shapes::height_field(0, 3, 3, 4, [](int i, int) { return 0.05 * i * i; });
    const auto plate_face = shapes::face_on(new Geom_OffsetSurface(plate, 0.4));
    const TopoDS_Shape both = shapes::sewn(
        {plate_face, BRepBuilderAPI_Transform(plate_face, apart, true).Shape()}, 3.0 * slot);
    const std::vector<Certified> edges = certify_all(both);
    ASSERT_EQ(edges.size(), 1);
    const EdgeCertificate& certificate = edges[0].certificate;
    ASSERT_TRUE(certificate.certified) << certificate.reason;
    const auto traces = trace_edges(both, {certificate.edge}, 2001, Progress{});
    ASSERT_TRUE(traces);
    for (const TracePoint& p : traces->at(0).points) {
        EXPECT_LE(p.gap, certificate.gap);
        EXPECT_LE(p.angle, certificate.angle);
    }
    EXPECT_GE(certificate.gap, slot);
    // Sound, not sharp: room for the nearest point to lie elsewhere on the border.
    EXPECT_LE(certificate.gap, 10.0 * slot);
}

/// Two roofs of degree 1 across, with their ridge in the middle, that share the polygon y = 1.
TopoDS_Shape roofs(double drop) {
    const auto roof = [&](double y0, double y1, double z1) {
        TColgp_Array2OfPnt poles(1, 3, 1, 2);
        for (int i = 1; i <= 3; ++i) {
            const double z = i == 2 ? 1.0 : 0.0;
            poles.SetValue(i, 1, {i - 1.0, y0, z});
            poles.SetValue(i, 2, {i - 1.0, y1, z + z1});
        }
        TColStd_Array1OfReal u(1, 3);
        u.SetValue(1, 0);
        u.SetValue(2, 1);
        u.SetValue(3, 2);
        TColStd_Array1OfInteger mu(1, 3);
        mu.SetValue(1, 2);
        mu.SetValue(2, 1);
        mu.SetValue(3, 2);
        TColStd_Array1OfReal v(1, 2);
        v.SetValue(1, 0);
        v.SetValue(2, 1);
        TColStd_Array1OfInteger mv(1, 2);
        mv.Init(2);
        return occ::Handle<Geom_Surface>(new Geom_BSplineSurface(poles, u, v, mu, mv, 1, 1));
    };
    // As whole faces: face_on would cut them at the kink.
    const auto whole = [](const occ::Handle<Geom_Surface>& surface) {
        BRep_Builder builder;
        TopoDS_Face face;
        builder.MakeFace(face, surface, Precision::Confusion());
        std::vector<TopoDS_Edge> edges;
        const auto side = [&](const occ::Handle<Geom_Curve>& curve, const gp_Lin2d& line) {
            TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(curve).Edge();
            builder.UpdateEdge(edge, new Geom2d_Line(line), face, Precision::Confusion());
            return edge;
        };
        const TopoDS_Edge bottom = side(surface->VIso(0), {{0, 0}, {1, 0}});
        const TopoDS_Edge right = side(surface->UIso(2), {{2, 0}, {0, 1}});
        const TopoDS_Edge top = side(surface->VIso(1), {{0, 1}, {1, 0}});
        const TopoDS_Edge left = side(surface->UIso(0), {{0, 0}, {0, 1}});
        TopoDS_Wire wire;
        builder.MakeWire(wire);
        builder.Add(wire, bottom);
        builder.Add(wire, right);
        builder.Add(wire, top.Reversed());
        builder.Add(wire, left.Reversed());
        builder.Add(face, wire);
        return face;
    };
    return shapes::sewn({whole(roof(0, 1, 0)), whole(roof(1, 2, -drop))}, 1e-6);
}

TEST(CertifyKinds, EdgesAcrossAKinkOfTheirSurfaces) {
    expect_all_certified(roofs(0.0));
    expect_all_certified(roofs(0.3));
}

TEST(CertifyKinds, SplinesThatCollapseToAPoint) {
    // Two quarters of a sphere, which meet in a meridian from pole to pole.
    const gp_Ax2 first({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
    const gp_Ax2 second({0, 0, 0}, {0, 0, 1}, {0, 1, 0});
    const auto quarter = [](const gp_Ax2& frame) {
        const occ::Handle<Geom_Surface> part = new Geom_RectangularTrimmedSurface(
            new Geom_SphericalSurface(frame, 3.0), 0.0, 0.5 * kPi, -0.5 * kPi, 0.5 * kPi);
        return shapes::face_on(GeomConvert::SurfaceToBSplineSurface(part));
    };
    for (const TopoDS_Shape& shape :
         {shapes::sewn({quarter(first), quarter(second)}),
          BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeSphere(3.0).Shape()).Shape()}) {
        const std::vector<Certified> edges = certify_all(shape);
        ASSERT_EQ(edges.size(), 1);
        ASSERT_TRUE(edges[0].certificate.certified) << edges[0].certificate.reason;
        // Beside the pole rounding is large against the surface: not as sharp as elsewhere.
        EXPECT_LT(edges[0].certificate.angle, radians(2e-3));
        EXPECT_LT(edges[0].certificate.gap, 1e-5);
        const auto traces = trace_edges(shape, {1}, 2001, Progress{});
        ASSERT_TRUE(traces);
        for (const TracePoint& p : traces->at(0).points) {
            EXPECT_LE(p.gap, edges[0].certificate.gap);
            EXPECT_LE(p.angle, edges[0].certificate.angle);
        }
    }
}

TEST(CertifyKinds, ASharpPointIsNotCalledSmooth) {
    // Two halves of a cone as splines: their normals differ all around the apex.
    const TopoDS_Shape cone =
        BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCone(0.0, 3.0, 4.0).Shape()).Shape();
    for (const Certified& edge : certify_all(cone)) {
        if (edge.measured.faces[0] == edge.measured.faces[1] && edge.certificate.certified) {
            EXPECT_GT(edge.certificate.angle, radians(60.0));
            EXPECT_FALSE(edge.certificate.within_slack);
        }
    }
}

TEST(CertifyKinds, ParabolasAndHyperbolas) {
    // Planes parallel to the axis, and to a straight line of the cone, cut the cone in these.
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(5.0, 1.0, 4.0).Shape();
    const TopoDS_Shape hyperbola =
        BRepAlgoAPI_Common(cone, BRepPrimAPI_MakeBox(gp_Pnt(0.8, -9, -9), 20, 20, 20).Shape());
    expect_all_certified(hyperbola);
    gp_Trsf tilt;
    tilt.SetRotation(gp_Ax1({1.5, 0, 2}, {0, 1, 0}), -0.25 * kPi);
    const TopoDS_Shape parabola = BRepAlgoAPI_Common(
        cone,
        BRepBuilderAPI_Transform(BRepPrimAPI_MakeBox(gp_Pnt(1.5, -9, -9), 20, 20, 20).Shape(), tilt)
            .Shape());
    expect_all_certified(parabola);
}

TEST(CertifyKinds, TheSeamOfAConeUpToItsApex) {
    for (const Certified& edge : certify_all(BRepPrimAPI_MakeCone(0.0, 3.0, 4.0).Shape())) {
        EXPECT_TRUE(edge.certificate.certified) << edge.certificate.reason;
    }
}

TEST(CertifyKinds, EncloseExponentials) {
    for (const double center : {-3.0, 0.0, 2.5}) {
        for (const double half : {0.01, 0.7, -1.0}) {
            const auto range = certify::exponential(center, half).range();
            EXPECT_LE(range.low, std::exp(center - std::abs(half)));
            EXPECT_GE(range.high, std::exp(center + std::abs(half)));
            EXPECT_LT(range.high - range.low,
                      3.0 * std::abs(half) * std::exp(center + std::abs(half)));
        }
    }
}

}  // namespace
}  // namespace suture

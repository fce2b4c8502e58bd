// Holes of any outline in waves of any shape: filled, checked, written, read again, checked again.
// The lost part of the surface is known; both ways to fill have to meet it.
#include "files/new_model.h"
#include "suture/check/continuity.h"
#include "suture/detect/find_loops.h"
#include "suture/fill_holes.h"

#include "files.h"
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepLib.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

namespace suture::io::test {
namespace {

constexpr double kSize = 40.0;

/// A sheet with a hole, and points of what was cut out.
struct Sheet {
    TopoDS_Face face;
    std::vector<gp_Pnt> lost;
    double diameter = 0.0;
};

/// Bicubic with 7 x 6 poles: a height of up to a tenth of the size, tilted and moved.
occ::Handle<Geom_BSplineSurface> wave(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const double a = number(random), b = number(random), c = number(random), d = number(random);
    TColgp_Array2OfPnt poles(1, 7, 1, 6);
    gp_Trsf place;
    place.SetRotation(gp_Ax1({1, 2, 3}, gp_Dir(a, b, 1.5)), 3.0 * c);
    for (int i = 1; i <= 7; ++i) {
        for (int j = 1; j <= 6; ++j) {
            const double x = (i - 1) / 6.0;
            const double y = (j - 1) / 5.0;
            const double z = 0.1 * (a * std::sin(3.0 * x + b) + c * std::cos(2.5 * y + d * x));
            poles(i, j) = gp_Pnt(kSize * x, kSize * y, kSize * z).Transformed(place);
        }
    }
    TColStd_Array1OfReal u(1, 5);
    TColStd_Array1OfReal v(1, 4);
    TColStd_Array1OfInteger mu(1, 5);
    TColStd_Array1OfInteger mv(1, 4);
    for (int i = 1; i <= 5; ++i) {
        u(i) = 0.25 * (i - 1);
        mu(i) = i == 1 || i == 5 ? 4 : 1;
    }
    for (int i = 1; i <= 4; ++i) {
        v(i) = (i - 1) / 3.0;
        mv(i) = i == 1 || i == 4 ? 4 : 1;
    }
    return occ::make<Geom_BSplineSurface>(poles, u, v, mu, mv, 3, 3);
}

/// The outline is a polygon of 3 to 7 corners around the middle of the parameters.
Sheet random_sheet(std::mt19937& random) {
    std::uniform_real_distribution<double> number(0.0, 1.0);
    const auto surface = wave(random);
    const int corners = 3 + static_cast<int>(random() % 5);
    std::vector<gp_Pnt2d> outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + 0.5 * number(random)) / corners;
        const double radius = 0.15 + 0.15 * number(random);
        outline.emplace_back(0.5 + radius * std::cos(angle), 0.45 + radius * std::sin(angle));
    }
    std::vector<TopoDS_Vertex> vertices;
    for (const gp_Pnt2d& uv : outline) {
        vertices.push_back(BRepBuilderAPI_MakeVertex(surface->Value(uv.X(), uv.Y())));
    }
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t next = (i + 1) % outline.size();
        const gp_Vec2d along(outline[i], outline[next]);
        wire.Add(BRepBuilderAPI_MakeEdge(occ::make<Geom2d_Line>(outline[i], gp_Dir2d(along)),
                                         surface, vertices[i], vertices[next], 0.0,
                                         along.Magnitude())
                     .Edge());
    }
    BRepBuilderAPI_MakeFace face(surface, 1e-7);
    face.Add(TopoDS::Wire(wire.Wire().Reversed()));
    Sheet sheet;
    sheet.face = face.Face();
    BRepLib::BuildCurves3d(sheet.face, 1e-7);
    BRepLib::SameParameter(sheet.face, 1e-7, true);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        for (const double inward : {0.15, 0.5, 0.8}) {
            const gp_Pnt2d uv(outline[i].X() + inward * (0.5 - outline[i].X()),
                              outline[i].Y() + inward * (0.45 - outline[i].Y()));
            sheet.lost.push_back(surface->Value(uv.X(), uv.Y()));
        }
        for (const gp_Pnt2d& other : outline) {
            sheet.diameter =
                std::max(sheet.diameter, surface->Value(outline[i].X(), outline[i].Y())
                                             .Distance(surface->Value(other.X(), other.Y())));
        }
    }
    return sheet;
}

/// Largest gap and angle of all edges between two faces.
std::array<double, 2> worst(const TopoDS_Shape& shape, std::size_t edges) {
    const auto report = measure_continuity(shape, Profile{}, {}, Progress{});
    EXPECT_TRUE(report);
    EXPECT_EQ(report->edges.size(), edges);
    std::array<double, 2> worst = {0.0, 0.0};
    for (const EdgeContinuity& edge : report->edges) {
        worst = {std::max(worst[0], edge.max_gap), std::max(worst[1], edge.max_angle)};
    }
    return worst;
}

class RandomHoles : public testing::TestWithParam<int> {};

TEST_P(RandomHoles, AreFilledAsTheFileSaysToo) {
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    const Sheet sheet = random_sheet(random);
    ASSERT_TRUE(BRepCheck_Analyzer(sheet.face).IsValid());
    for (const char* method : {"auto", "mvs"}) {
        FillRequest request;
        request.method = method;
        const auto filled = fill_holes(sheet.face, occ::Numbering(sheet.face), request);
        ASSERT_TRUE(filled) << filled.error().message;
        // The sheet's own rim stays open.
        const auto found =
            std::ranges::find(filled->holes, FillStatus::Filled, &HoleReport::status);
        ASSERT_NE(found, filled->holes.end()) << method;
        const HoleReport& hole = *found;
        EXPECT_TRUE(hole.verdict.within()) << method << ": " << hole.reason;
        ASSERT_EQ(filled->new_faces.size(), 1) << method;
        EXPECT_TRUE(BRepCheck_Analyzer(filled->shape).IsValid()) << method;

        const auto [gap, angle] = worst(filled->shape, hole.sides.size());
        EXPECT_NEAR(gap, hole.max_gap, 1e-6);
        EXPECT_NEAR(angle, hole.max_angle, 1e-5);

        auto model = make_model(filled->shape, "sheet");
        ASSERT_TRUE(model) << model.error().message;
        const Folder folder;
        const auto file = folder / "sheet.step";
        ASSERT_TRUE(write_model(*model, file, Format::Step, {}));
        const TopoDS_Shape again = read(file).shape();
        const auto [gap_again, angle_again] = worst(again, hole.sides.size());
        EXPECT_NEAR(gap_again, gap, 1e-5) << method;
        EXPECT_NEAR(angle_again, angle, 1e-4) << method;
        EXPECT_LE(gap_again, 1e-3) << method;
        EXPECT_LE(angle_again, 0.01 * std::numbers::pi / 180.0) << method;

        // auto finds that it is the neighbour's surface; mvs only what is smoothest.
        const double most = std::string_view(method) == "auto" ? 1e-6 : 0.02;
        for (const gp_Pnt& point : sheet.lost) {
            const BRepExtrema_DistShapeShape distance(BRepBuilderAPI_MakeVertex(point).Vertex(),
                                                      again);
            EXPECT_LE(distance.Value(), most * sheet.diameter) << method;
        }
    }
}

/// SUTURE_RANDOM_HOLES: how many.
int seeds() {
    const char* wanted = std::getenv("SUTURE_RANDOM_HOLES");
    return wanted != nullptr ? std::atoi(wanted) : 12;
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomHoles, testing::Range(1, seeds() + 1));

}  // namespace
}  // namespace suture::io::test

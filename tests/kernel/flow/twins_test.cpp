#include "suture/fill_holes.h"
#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include "kernel/flow/placements.h"
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BezierSurface.hxx>
#include <Poly_Triangulation.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <set>
#include <vector>

namespace suture {
namespace {

using placements::placed;
using placements::Placement;
using Sheets = std::vector<occ::Handle<Geom_BezierSurface>>;

/// Faces sewn together, some turned over, one left out that is looked for, others left out as well.
struct Sewn {
    TopoDS_Shape open;
    TopoDS_Face lost;
};

Sewn sewn(const Sheets& sheets, std::size_t lost, const std::set<std::size_t>& turned,
          const std::set<std::size_t>& missing = {}) {
    BRepBuilderAPI_Sewing sewing(1e-6);
    std::vector<TopoDS_Face> faces;
    for (const auto& sheet : sheets) {
        faces.push_back(BRepBuilderAPI_MakeFace(sheet, 1e-7));
        sewing.Add(faces.back());
    }
    sewing.Perform();
    const BRep_Builder builder;
    TopoDS_Compound open;
    builder.MakeCompound(open);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const TopoDS_Shape face = sewing.Modified(faces[i]);
        if (i != lost && !missing.contains(i)) {
            builder.Add(open, turned.contains(i) ? face.Reversed() : face);
        }
    }
    return {open, faces[lost]};
}

/// Adds what is 0 in value and slope where the piece begins, in u or in v, or where it ends.
void bend(Geom_BezierSurface& sheet, bool in_u, bool from_end, double by) {
    const int n = in_u ? sheet.UDegree() : sheet.VDegree();
    for (int i = 0; i <= sheet.UDegree(); ++i) {
        for (int j = 0; j <= sheet.VDegree(); ++j) {
            const int k = in_u ? i : j;
            const int away = from_end ? n - k : k;
            gp_Pnt pole = sheet.Pole(i + 1, j + 1);
            pole.SetZ(pole.Z() + by * away * (away - 1) / (n * (n - 1)));
            sheet.SetPole(i + 1, j + 1, pole);
        }
    }
}

/// Pieces of a wavy sheet about the x axis, which is its mirror line: a middle one (0), those
/// around it in front (1), behind (2), beside (3) and in the corners (4, 5); and their mirror
/// images (6 to 11). They meet smoothly, and none is another one's continuation.
Sheets wavy() {
    const double heights[4][3] = {
        {0.0, 1.0, 2.5}, {3.0, -1.0, 2.0}, {-2.0, 2.0, -1.0}, {1.5, 0, 3}};
    TColgp_Array2OfPnt poles(1, 4, 1, 5);
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 5; ++j) {
            poles.SetValue(
                i + 1, j + 1,
                gp_Pnt(-5.0 + 20.0 * i / 3.0, -15.0 + 7.5 * j, heights[i][std::abs(j - 2)]));
        }
    }
    const auto all = occ::make<Geom_BezierSurface>(poles);
    Sheets sheets;
    for (const double side : {1.0, -1.0}) {
        const auto piece = [&](double x0, double x1, double y0, double y1) {
            const auto v = [&](double y) { return (side * y + 15.0) / 30.0; };
            const auto sheet = occ::cast<Geom_BezierSurface>(all->Copy());
            sheet->Segment((x0 + 5.0) / 20.0, (x1 + 5.0) / 20.0, std::min(v(y0), v(y1)),
                           std::max(v(y0), v(y1)));
            if (x0 != 0.0) {
                bend(*sheet, /*in_u=*/true, /*from_end=*/x0 < 0.0, 0.7);
            }
            if (y0 != 0.0) {
                bend(*sheet, /*in_u=*/false, /*from_end=*/side < 0.0, 0.5);
            } else {
                for (int i = 1; i <= 4; ++i) {
                    gp_Pnt pole = sheet->Pole(i, 3);
                    pole.SetZ(pole.Z() + 1.0);  // 0 in value and slope at either end
                    sheet->SetPole(i, 3, pole);
                }
            }
            sheets.push_back(sheet);
        };
        piece(0, 10, 0, 10);
        piece(-5, 0, 0, 10);
        piece(10, 15, 0, 10);
        piece(0, 10, 10, 15);
        piece(-5, 0, 10, 15);
        piece(10, 15, 10, 15);
    }
    return sheets;
}

constexpr std::size_t kLost = 6;
const std::set<std::size_t> kNone = {};
const std::set<std::size_t> kInFront = {1, 4};
const std::set<std::size_t> kInFrontOfLost = {7, 10};
const std::set<std::size_t> kInFrontOfBoth = {1, 4, 7, 10};

FillOutcome filled(const TopoDS_Shape& open, const FillRequest& request) {
    const auto outcome = fill_holes(open, occ::Numbering(open), request);
    if (!outcome) {
        ADD_FAILURE() << outcome.error().message;
    }
    return outcome.value_or(FillOutcome());
}

FillRequest by(const std::string& method) {
    FillRequest request;
    request.method = method;
    return request;
}

/// The hole, not the sheet's own rim.
HoleReport hole_of(const FillOutcome& outcome) {
    const auto hole = std::ranges::find_if(
        outcome.holes, [](const HoleReport& one) { return one.status != FillStatus::Skipped; });
    EXPECT_TRUE(hole != outcome.holes.end());
    return hole != outcome.holes.end() ? *hole : HoleReport();
}

double largest_distance(const TopoDS_Face& face, const occ::Handle<Geom_Surface>& surface,
                        double deflection) {
    BRepMesh_IncrementalMesh(face, deflection);
    TopLoc_Location place;
    const auto mesh = BRep_Tool::Triangulation(face, place);
    double largest = 0.0;
    for (int i = 1; i <= mesh->NbNodes(); i += 3) {
        const GeomAPI_ProjectPointOnSurf foot(mesh->Node(i).Transformed(place), surface);
        largest = std::max(largest, foot.LowerDistance());
    }
    return largest;
}

// The two in front have their outsides turned against all others', as inner and outer skins of real
// files: along the edges between, the angle is 180 degrees, with the lost face as well.
TEST(Twins, AreTakenAlongASideThatIsTurnedOverWhereTheFaceIsThatTheyCopy) {
    for (const Placement& placement : placements::all()) {
        SCOPED_TRACE(placement.name);
        Sewn model = sewn(wavy(), kLost, kInFrontOfBoth);
        model.open = placed(model.open, placement);
        for (const std::string method : {"recognise", "auto"}) {
            if (method == "auto" && !placement.name.empty()) {
                continue;
            }
            const FillOutcome outcome = filled(model.open, by(method));
            ASSERT_FALSE(outcome.holes.empty());
            const HoleReport hole = hole_of(outcome);
            ASSERT_EQ(hole.status, FillStatus::Filled) << hole.reason;
            ASSERT_TRUE(hole.recognised) << hole.reason;
            EXPECT_NE(hole.recognised->from.find("mirrored twin of face"), std::string::npos);
            EXPECT_TRUE(hole.verdict.within());
            ASSERT_FALSE(hole.verdict.findings.empty());
            EXPECT_TRUE(hole.verdict.findings.front().before);
            const TopoDS_Face lost = TopoDS::Face(placed(model.lost, placement));
            EXPECT_LT(largest_distance(outcome.new_faces.front(), BRep_Tool::Surface(lost),
                                       0.05 * placement.scale),
                      1e-7 * placement.scale);
        }
    }
}

TEST(Twins, StayOutAlongASideThatIsTurnedOverWhereTheFaceIsNotThatTheyCopy) {
    FillRequest request = by("recognise");
    request.continuity = Continuity::G1;  // else tangency would be given up, and that be told
    for (const auto& [turned, fits] : {std::pair(kInFrontOfLost, false), std::pair(kInFront, true),
                                       std::pair(kInFrontOfBoth, true)}) {
        const HoleReport hole = hole_of(filled(sewn(wavy(), kLost, turned).open, request));
        ASSERT_FALSE(hole.verdict.findings.empty() && !fits);
        EXPECT_EQ(hole.status, fits ? FillStatus::Filled : FillStatus::Refused) << hole.reason;
        if (!fits) {
            EXPECT_EQ(hole.verdict.findings.front().kind, FindingKind::Angle);
            EXPECT_EQ(hole.verdict.findings.front().severity, Severity::Bad);
            EXPECT_FALSE(hole.verdict.findings.front().before);
        }
    }
}

// What the edge of the other face meets is gone: that tells nothing of what this one's may meet.
TEST(Twins, StayOutAlongASideThatIsTurnedOverWhereTheFaceThatTheyCopyIsOpen) {
    FillRequest request = by("recognise");
    request.continuity = Continuity::G1;
    for (const auto& [turned, fits] : {std::pair(kInFrontOfLost, false), std::pair(kNone, true)}) {
        const HoleReport hole =
            hole_of(filled(sewn(wavy(), kLost, turned, /*missing=*/kInFront).open, request));
        EXPECT_EQ(hole.status, fits ? FillStatus::Filled : FillStatus::Refused) << hole.reason;
        if (!fits) {
            ASSERT_FALSE(hole.verdict.findings.empty());
            EXPECT_EQ(hole.verdict.findings.front().kind, FindingKind::Angle);
            EXPECT_FALSE(hole.verdict.findings.front().before);
        }
    }
}

/// Two skins over one rim without symmetry, one the other's mirror image: `degree` 3 meets the
/// rim's plane at an angle, 5 is tangent to it.
Sheets pillow(int degree, double x) {
    const gp_XYZ corners[2][2] = {{{0, 0, 0}, {0, 9, 0}}, {{10, 1, 0}, {8, 7, 0}}};
    const int flat = degree == 5 ? 2 : 1;
    Sheets skins;
    for (const double up : {1.0, -1.0}) {
        TColgp_Array2OfPnt poles(1, degree + 1, 1, degree + 1);
        for (int i = 0; i <= degree; ++i) {
            for (int j = 0; j <= degree; ++j) {
                const double s = static_cast<double>(i) / degree;
                const double t = static_cast<double>(j) / degree;
                gp_XYZ at = (1 - s) * (1 - t) * corners[0][0] + (1 - s) * t * corners[0][1] +
                            s * (1 - t) * corners[1][0] + s * t * corners[1][1];
                const bool inside = std::min({i, j, degree - i, degree - j}) >= flat;
                at += gp_XYZ(x, 0, inside ? up * (2.0 + 0.5 * i + 0.2 * j) : 0.0);
                poles.SetValue(i + 1, j + 1, gp_Pnt(at));
            }
        }
        skins.push_back(occ::make<Geom_BezierSurface>(poles));
    }
    return skins;
}

/// Whether nothing was put onto the skin that is there: below the rim's plane.
void expect_nothing_below(const FillOutcome& outcome) {
    for (const TopoDS_Face& face : outcome.new_faces) {
        BRepMesh_IncrementalMesh(face, 0.05);
        TopLoc_Location place;
        const auto mesh = BRep_Tool::Triangulation(face, place);
        for (int i = 1; i <= mesh->NbNodes(); ++i) {
            EXPECT_GT(mesh->Node(i).Transformed(place).Z(), -1e-6);
        }
    }
}

// The skin that is left fits into the hole above it, lying on itself, turned over all around. Not
// even where what is bad is kept is it taken for the lost one.
TEST(Twins, CloseNoPillowByLyingOnItsOtherSkin) {
    for (const int degree : {3, 5}) {
        for (const bool whole_one_too : {false, true}) {
            SCOPED_TRACE(degree);
            SCOPED_TRACE(whole_one_too);
            Sheets skins = pillow(degree, 0.0);
            if (whole_one_too) {
                for (const auto& skin : pillow(degree, 30.0)) {
                    skins.push_back(skin);
                }
            }
            FillRequest request = by("recognise");
            request.all_loops = true;
            request.keep_bad = true;
            expect_nothing_below(filled(sewn(skins, 0, {}).open, request));
        }
    }
}

}  // namespace
}  // namespace suture

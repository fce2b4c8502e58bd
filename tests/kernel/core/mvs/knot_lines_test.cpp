#include "suture/fill/mvs/knot_lines.h"

#include "support/ribbon_zoo.h"
#include "support/trim_of.h"
#include "suture/fill/mvs.h"
#include "suture/fill/mvs/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace suture::mvs {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSomeTwist = 0.04;

LinedLayout lined(const Hole& hole, const Eigen::Matrix2d& turn = Eigen::Matrix2d::Identity()) {
    Layout layout = lay_out(hole.loops[0], hole.diameter).value();
    for (DomainCurve& curve : layout.curves) {
        curve = curve.moved(turn, Vector2d::Zero());
    }
    Scale scale;
    scale.length = std::accumulate(layout.lengths.begin(), layout.lengths.end(), 0.0) / kPi;
    return with_knot_lines(hole.loops[0], layout, scale, kSomeTwist);
}

// The largest angle to the neighbours, at parameters that the method does not fit.
double angle_of(const Hole& hole, const FillResult& fill) {
    const auto& surface = std::get<SplineSurface>(fill.patches.front().surface);
    double worst = 0.0;
    const std::vector<Ribbon>& ribbons = hole.loops.front().ribbons;
    for (std::size_t i = 0; i < ribbons.size(); ++i) {
        for (int k = 0; k <= 301; ++k) {
            const double t = k / 301.0;
            const double s = t * t * (3.0 - 2.0 * t);  // denser at the ends
            const RibbonPoint q = ribbons[i].at(s);
            const Vector2d uv = test::trim_of(fill.patches.front(), 0, i)(s);
            const SurfaceJet j = evaluate(surface, uv.x(), uv.y());
            const Vector3d n = j.u.cross(j.v).normalized();
            worst = std::max(worst, std::atan2(n.cross(q.normal).norm(), n.dot(q.normal)));
        }
    }
    return degrees(worst);
}

TEST(KnotLines, AreNoneWhereOneSmoothSurfaceIsTangentToAll) {
    EXPECT_TRUE(lined(zoo::suitcase_corner(2.0)).lines.empty());
    EXPECT_TRUE(lined(zoo::pipe_end(1.0, 4)).lines.empty());
    EXPECT_TRUE(
        lined(zoo::window(zoo::wavy(0.1, 2.0), zoo::regular({0.3, 0.1}, 0.5, 5))).lines.empty());
}

// How often a corner lies on a line that is there for it, corner by corner.
std::vector<int> lines_through_corners(const LinedLayout& with) {
    std::vector<int> met;
    const double length =
        std::accumulate(with.layout.lengths.begin(), with.layout.lengths.end(), 0.0) / kPi;
    for (const DomainCurve& side : with.layout.curves) {
        const Vector2d corner = side.at(0.0) / length;
        met.push_back(0);
        for (const KnotLine& line : with.lines) {
            for (const KnotLine::Origin& origin : line.origins) {
                met.back() += std::abs(corner[line.axis] - line.at) < 1e-7 &&
                                      std::abs(corner[1 - line.axis] - origin.along) < 1e-9
                                  ? 1
                                  : 0;
            }
        }
    }
    return met;
}

TEST(KnotLines, PassThroughTheCornersWhoseNeighboursDisagree) {
    const LinedLayout with = lined(zoo::fillet_corner(3, 0.6, 0.0, 0.5).setback(2.7));
    EXPECT_EQ(lines_through_corners(with), std::vector<int>(6, 1));
    for (const KnotLine& line : with.lines) {
        EXPECT_EQ(line.weight(line.origins[0].along), 0.0);
        EXPECT_EQ(line.weight(line.origins[0].along + 100.0), 1.0);
    }
}

TEST(KnotLines, ServeSeveralCornersEach) {
    const Hole hole = zoo::fillet_corner(5, 0.6, 0.0, 1.0).setback(2.7);
    const Layout layout = lay_out(hole.loops[0], hole.diameter).value();
    const LinedLayout with = lined(hole);
    const std::vector<int> met = lines_through_corners(with);
    EXPECT_GE(std::ranges::min(met), 1);
    EXPECT_LE(with.lines.size(), 8U);
    EXPECT_GE(std::accumulate(met.begin(), met.end(), 0), 10);
    const std::size_t n = met.size();
    for (std::size_t i = 0; i < n; ++i) {
        // The sides still meet, and at the angles between two lines that lie as before.
        const DomainCurve& before = with.layout.curves[(i + n - 1) % n];
        const DomainCurve& after = with.layout.curves[i];
        EXPECT_LT((before.at(1.0) - after.at(0.0)).norm(), 1e-9 * hole.diameter);
        EXPECT_NEAR((after.at(1.0) - after.at(0.0)).norm(), layout.lengths[i],
                    0.6 * layout.lengths[i]);
    }
}

TEST(KnotLines, CrossAtAnySlantToEnterNarrowCorners) {
    // Corners of 33 and 36 degrees, in which no two lines at right angles lie.
    const std::vector<int> met =
        lines_through_corners(lined(zoo::fillet_corner(5, 0.6, 0.35, 0.5).tight()));
    EXPECT_GE(std::min({met[1], met[2], met[3], met[4]}), 1);  // the first one is hardly twisted
}

TEST(KnotLines, AreTwoWhereTheBoundaryGoesStraightOn) {
    // Two sides meet at 179.9 degrees: with one line, or none, tangency would take curvatures
    // across them hundreds of times the fillets'.
    const Hole hole = zoo::fillet_corner(7, 0.6, 0.0, 0.5).tight();
    EXPECT_EQ(lines_through_corners(lined(hole))[6], 2);
    const Result<FillResult> fill = fill_mvs(hole, {});
    ASSERT_TRUE(fill);
    EXPECT_LT(angle_of(hole, *fill), 0.01);
}

TEST(KnotLines, DoNotDependOnHowTheDomainLies) {
    const Hole hole = zoo::fillet_corner(3, 0.6, 0.0, 0.5).setback(2.7);
    const std::size_t count = lined(hole).lines.size();
    for (const double angle : {0.3, 1.5, 4.0}) {
        EXPECT_EQ(lined(hole, Eigen::Rotation2Dd(angle).toRotationMatrix()).lines.size(), count);
    }
}

TEST(KnotLines, DivideAnAxis) {
    const std::vector<KnotLine> lines = {{0, 0.3, {}}, {1, 0.7, {}}, {0, -0.2, {}}};
    const Axis axis = lined_axis(-1.0, 1.0, 0.25, 0, lines);
    EXPECT_EQ(axis.spans(), 3 + 3 + 2 + 3 + 3);  // three empty ones a line
    EXPECT_EQ(std::count(axis.knots.begin(), axis.knots.end(), 0.3), 4);
    EXPECT_EQ(std::count(axis.knots.begin(), axis.knots.end(), -0.2), 4);
    EXPECT_TRUE(axis.beside_line(axis.span_of(-0.201)));
    EXPECT_TRUE(axis.beside_line(axis.span_of(0.301)));
    EXPECT_FALSE(axis.beside_line(axis.span_of(0.9)));
    for (int k = 0; k < axis.spans(); ++k) {
        EXPECT_TRUE(axis.empty(k) || axis.upper(k) - axis.lower(k) < 0.3);
    }
}

TEST(KnotLines, MeasureTheJumpOfTheSecondAndThirdDerivatives) {
    const Axis axis = lined_axis(-1.0, 1.0, 0.25, 0, {{0, 0.3, {}}});
    Eigen::VectorXd poles(axis.count());
    for (Eigen::Index k = 0; k < poles.size(); ++k) {
        poles[k] = std::sin(3.0 * static_cast<double>(k * k));
    }
    const auto derivatives = [&](int span) {
        return Eigen::Vector4d(basis_row(axis, span, 0.3).values *
                               poles.segment<kOrder>(basis_row(axis, span, 0.3).first));
    };
    const int right = axis.span_of(0.3);
    const int left = axis.span_of(0.3 - 1e-9);
    const Eigen::Vector4d jump = derivatives(right) - derivatives(left);
    EXPECT_NEAR(jump[0], 0.0, 1e-12);
    EXPECT_NEAR(jump[1], 0.0, 1e-10);
    const JumpRow row = jump_row(axis, 0.3);
    const Vector2d found = row.values * poles.segment<kOrder>(row.first);
    const double shorter =
        std::min(axis.upper(left) - axis.lower(left), axis.upper(right) - axis.lower(right));
    EXPECT_NEAR(found[0], jump[2], 1e-9 * std::abs(jump[2]));
    EXPECT_NEAR(found[1], shorter * jump[3], 1e-9 * std::abs(shorter * jump[3]));
}

TEST(KnotLines, LetAFillBeTangentWhereFilletsOfUnequalRadiiMeet) {
    const Hole hole = zoo::fillet_corner(3, 0.6, 0.0, 0.5).setback(2.7);
    Schedule without;
    without.twisted = 1e9;
    const Result<FillResult> with_lines = fill_mvs(hole, {});
    const Result<FillResult> plain = fill_mvs(hole, {}, without);
    ASSERT_TRUE(with_lines && plain);
    EXPECT_LT(angle_of(hole, *with_lines), 0.01);
    EXPECT_GT(angle_of(hole, *plain), 0.03);
}

// Five fillets of unequal radii, convex and concave, that end in short sides: with the energy's
// weight falling as without lines, 44 x 50 poles missed by 0.034 degrees.
TEST(KnotLines, MeetManyShortSidesWithFewPoles) {
    FillOptions options;
    options.own["work"] = {OptionKind::Number, {0.3}, {}};
    const Hole hole = zoo::fillet_corner(5, 0.6, 0.35, 0.5).setback(2.7);
    const auto fill = fill_mvs(hole, options);
    ASSERT_TRUE(fill) << fill.error().message;
    EXPECT_LT(angle_of(hole, *fill), 0.004);
    const auto& surface = std::get<SplineSurface>(fill->patches.front().surface);
    EXPECT_LT(surface.poles.cols(), 1600);
}

}  // namespace
}  // namespace suture::mvs

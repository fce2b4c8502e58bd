#include "suture/judge/judge_fill.h"

#include <gtest/gtest.h>

#include <limits>

namespace suture {
namespace {

/// A hole of three sides, 100 across, all asked to be tangent, and a fill without fault.
struct Fill {
    Fill() {
        asked.hole = 7;
        asked.diameter = 100.0;
        for (int i = 0; i < 3; ++i) {
            AskedSide side;
            side.edge = 10 + i;
            asked.sides.push_back(side);
            EdgeContinuity edge;
            edge.edge = 20 + i;
            edge.samples = 50;
            measures.sides.push_back(edge);
            measures.edges.push_back({edge.edge, 1e-7, Eigen::Vector3d::Zero()});
        }
    }
    [[nodiscard]] Judgement judgement() const { return judge_fill(asked, measures); }
    [[nodiscard]] Finding only() const {
        const Judgement result = judgement();
        EXPECT_EQ(result.findings.size(), 1U);
        return result.findings.empty() ? Finding() : result.findings.front();
    }

    AskedFill asked;
    FillMeasures measures;
};

TEST(JudgeFill, HasNothingToSayOfAFillWithoutFault) {
    const Fill fill;
    EXPECT_TRUE(fill.judgement().within());
    EXPECT_TRUE(fill.judgement().findings.empty());
    EXPECT_EQ(reached_by(fill.asked, fill.measures), Continuity::G2);
}

TEST(JudgeFill, TellsTheNormalAtAPointThatIsMissed) {
    Fill fill;
    fill.measures.through_angle = 3.0 * fill.asked.tolerance.angular;
    fill.measures.through_angle_at = {1.0, 2.0, 3.0};
    const Finding finding = fill.only();
    EXPECT_EQ(finding.kind, FindingKind::ThroughAngle);
    EXPECT_EQ(finding.severity, Severity::Near);
    EXPECT_EQ(finding.at, Eigen::Vector3d(1.0, 2.0, 3.0));
    EXPECT_EQ(to_string(finding.kind), "through_angle");
    EXPECT_EQ(unit_of(finding.kind), "deg");
}

TEST(JudgeFill, CountsASideOnASupportAsSmoothThoughTheFaceEndsThere) {
    Fill fill;
    for (std::size_t i = 0; i < 3; ++i) {
        fill.asked.sides[i].alone = true;
        fill.measures.sides[i].faces = {1, 0};
        fill.measures.open_edges.push_back(
            {20 + static_cast<int>(i), 1e-7, Eigen::Vector3d::Zero()});
    }
    EXPECT_EQ(reached_by(fill.asked, fill.measures), Continuity::G0);
    fill.asked.sides[1].supported = true;
    fill.measures.sides[1].curvature_mismatch = 1.0;
    EXPECT_EQ(reached_by(fill.asked, fill.measures), Continuity::G1);
    EXPECT_TRUE(fill.judgement().within());
}

TEST(JudgeFill, GradesAMeasureByItsLimit) {
    const std::vector<std::pair<double, Severity>> grades = {{1.0, Severity::Good},
                                                             {1.01, Severity::Near},
                                                             {10.0, Severity::Near},
                                                             {10.1, Severity::Poor}};
    for (const auto& [times, severity] : grades) {
        SCOPED_TRACE(times);
        Fill gap;
        gap.measures.sides[1].max_gap = times * gap.asked.tolerance.linear;
        EXPECT_EQ(gap.judgement().severity, severity);
        EXPECT_NEAR(gap.judgement().score, times, 1e-12);
        Fill angle;
        angle.measures.sides[1].max_angle = times * angle.asked.tolerance.angular;
        EXPECT_EQ(angle.judgement().severity, severity);
        if (severity > Severity::Good) {
            EXPECT_EQ(gap.only().kind, FindingKind::Gap);
            EXPECT_EQ(gap.only().edge, 11);
            EXPECT_EQ(gap.only().hole, 7);
            EXPECT_EQ(angle.only().kind, FindingKind::Angle);
        }
    }
}

TEST(JudgeFill, CallsAGapBeyondAThousandthOfTheHoleBad) {
    Fill fill;
    fill.measures.sides[0].max_gap = 0.101;
    EXPECT_EQ(fill.only().severity, Severity::Bad);
    fill.asked.diameter = 1000.0;
    EXPECT_EQ(fill.only().severity, Severity::Poor);
}

TEST(JudgeFill, CallsASharpSideBadUnlessItsCornerForcesIt) {
    Fill fill;
    fill.measures.sides[2].max_angle = radians(6.0);
    EXPECT_EQ(fill.only().severity, Severity::Bad);
    fill.asked.sides[2].corner_angle = radians(6.0);
    EXPECT_EQ(fill.only().severity, Severity::Poor);
    fill.asked.sides[2].corner_angle = radians(3.0);
    EXPECT_EQ(fill.only().severity, Severity::Bad);
}

TEST(JudgeFill, AsksNoMoreThanTheNeighboursHaveThemselves) {
    Fill fill;
    fill.measures.sides[2].max_angle = radians(0.05);
    fill.asked.sides[2].corner_angle = radians(0.06);
    EXPECT_TRUE(fill.judgement().within());
    EXPECT_TRUE(fill.only().before);
    fill.asked.sides[2].corner_angle = radians(0.04);
    EXPECT_EQ(fill.judgement().severity, Severity::Near);
    EXPECT_FALSE(fill.only().before);
    // A hole between different surfaces is no noise.
    fill.measures.sides[2].max_angle = radians(2.0);
    fill.asked.sides[2].corner_angle = radians(2.5);
    EXPECT_EQ(fill.judgement().severity, Severity::Poor);
}

TEST(JudgeFill, TakesWhatTheFaceHasThatAFillCopiesForTheModelsOwn) {
    Fill fill;
    fill.asked.recognised = true;
    EdgeContinuity& side = fill.measures.sides[2];
    side.max_angle = radians(179.9);
    side.min_angle = radians(178.0);
    EXPECT_EQ(fill.judgement().severity, Severity::Bad);
    std::optional<AngleRange>& of_twin = fill.asked.sides[2].of_twin;
    of_twin = {radians(178.5), radians(179.5)};
    EXPECT_TRUE(fill.judgement().within());
    EXPECT_TRUE(fill.only().before);
    EXPECT_EQ(fill.only().edge, 12);
    // The one that it copies is sharp as well, but otherwise: an edge of a body is no skin turned
    // over. Or it is so in one place.
    of_twin = {radians(60.0), radians(61.0)};
    EXPECT_EQ(fill.judgement().severity, Severity::Bad);
    of_twin = {radians(60.0), radians(179.5)};
    EXPECT_EQ(fill.judgement().severity, Severity::Bad);
    side.min_angle = radians(60.0);
    of_twin = {radians(178.0), radians(179.5)};
    EXPECT_EQ(fill.judgement().severity, Severity::Bad);
    of_twin.reset();
    EXPECT_EQ(fill.judgement().severity, Severity::Bad);
}

TEST(JudgeFill, TakesAFoldForTheModelsOwnWhereTheFaceFoldsThatAFillCopies) {
    Fill fill;
    fill.asked.recognised = true;
    FaceFold fold;
    fold.face = 30;
    fold.verdict = FoldVerdict::Fold;
    fill.measures.folds.push_back(fold);
    EXPECT_EQ(fill.judgement().severity, Severity::Bad);
    fill.asked.twin_folds = true;
    EXPECT_TRUE(fill.judgement().within());
    EXPECT_TRUE(fill.only().before);
    // That it runs against its border is the fill's own.
    fill.measures.folds.front().backwards = true;
    EXPECT_EQ(fill.judgement().severity, Severity::Bad);
}

TEST(JudgeFill, LetsARecognisedFaceMissAnEdgeAsItsNeighbourDoes) {
    Fill fill;
    fill.measures.sides[1].max_gap = 0.05;
    fill.asked.sides[1].noise = 0.04;
    EXPECT_EQ(fill.only().severity, Severity::Poor);
    EXPECT_FALSE(fill.only().before);
    fill.asked.recognised = true;
    EXPECT_TRUE(fill.only().before);
    fill.measures.sides[1].max_gap = 0.061;
    EXPECT_FALSE(fill.only().before);
}

TEST(JudgeFill, JudgesGivenUpTangencyUnlessItWasAWall) {
    Fill fill;
    fill.asked.sides[0].continuity = Continuity::G0;
    fill.measures.sides[0].max_angle = radians(30.0);
    EXPECT_TRUE(fill.judgement().within());
    fill.asked.sides[0].given_up = true;
    EXPECT_EQ(fill.only().kind, FindingKind::TangencyGivenUp);
    EXPECT_EQ(fill.only().severity, Severity::Poor);
    fill.asked.sides[0].wall = true;
    EXPECT_TRUE(fill.judgement().within());
}

TEST(JudgeFill, HoldsNoSharpEdgeAgainstASurfaceThatWasRecognised) {
    Fill fill;
    fill.asked.sides[0].continuity = Continuity::G0;
    fill.asked.sides[0].given_up = true;
    fill.measures.sides[0].max_angle = radians(105.0);
    fill.measures.sides[0].min_angle = radians(90.0);
    EXPECT_EQ(fill.judgement().severity, Severity::Poor);
    fill.asked.recognised = true;
    EXPECT_TRUE(fill.judgement().within());
    fill.measures.sides[0].min_angle = radians(4.0);
    EXPECT_EQ(fill.only().kind, FindingKind::TangencyGivenUp);
    fill.asked.sides[0].continuity = Continuity::G1;
    EXPECT_EQ(fill.only().severity, Severity::Bad);
}

TEST(JudgeFill, CallsFoldsClashesAndDoubleFacesBad) {
    Fill folded;
    folded.measures.folds.push_back({});
    EXPECT_TRUE(folded.judgement().within());
    folded.measures.folds.back().verdict = FoldVerdict::Fold;
    EXPECT_EQ(folded.only().kind, FindingKind::Fold);
    EXPECT_EQ(folded.only().severity, Severity::Bad);
    Fill backwards;
    backwards.measures.folds.push_back({});
    backwards.measures.folds.back().backwards = true;
    EXPECT_EQ(backwards.only().severity, Severity::Bad);
    Fill clashing;
    clashing.measures.clashes.push_back({3, 5, {1.0, 2.0, 3.0}, 0.5, 1.0});
    EXPECT_EQ(clashing.only().severity, Severity::Bad);
    EXPECT_EQ(clashing.only().other_face, 5);
    Fill lying;
    Overlay overlay;
    overlay.face = 3;
    overlay.other = 5;
    overlay.share = 0.4;
    overlay.neighbours = true;
    lying.measures.overlays.push_back(overlay);
    EXPECT_TRUE(lying.judgement().within());
    lying.measures.overlays.back().share = 0.6;
    EXPECT_EQ(lying.only().severity, Severity::Bad);
    lying.measures.overlays.back().neighbours = false;
    lying.measures.overlays.back().distance = 0.002;  // the other side of a thin wall
    EXPECT_TRUE(lying.judgement().within());
}

TEST(JudgeFill, CallsABalloonBadButNotABall) {
    Fill fill;
    fill.measures.area = {16'470.0, 310.0, 1};
    EXPECT_EQ(fill.only().kind, FindingKind::Balloon);
    EXPECT_EQ(fill.only().severity, Severity::Bad);
    fill.asked.closed_form = true;
    EXPECT_TRUE(fill.judgement().within());
    fill.asked.closed_form = false;
    fill.measures.area = {620.0, 310.0, 1};  // half a ball
    EXPECT_TRUE(fill.judgement().within());
}

TEST(JudgeFill, FindsTolerancesThatGrewBeyondTheGap) {
    Fill fill;
    fill.measures.edges[1].tolerance = 0.03;
    fill.measures.sides[1].edge_gap = 2.6e-4;
    EXPECT_EQ(fill.only().kind, FindingKind::ToleranceGrown);
    EXPECT_EQ(fill.only().edge, 11);
    fill.asked.sides[1].tolerance = 0.03;  // as it was
    EXPECT_TRUE(fill.judgement().within());
    fill.asked.sides[1].tolerance = 0.0;
    fill.measures.sides[1].edge_gap = 0.021;  // the gap needs it
    EXPECT_TRUE(fill.judgement().within());
}

TEST(JudgeFill, JudgesEdgesAndKnotsInsideTheFill) {
    Fill inner;
    EdgeContinuity edge;
    edge.edge = 40;
    edge.samples = 50;
    edge.max_angle = radians(0.03);
    inner.measures.inner.push_back(edge);
    EXPECT_EQ(inner.judgement().severity, Severity::Near);
    EXPECT_EQ(reached_by(inner.asked, inner.measures), Continuity::G0);
    Fill crease;
    KnotLine line;
    line.face = 9;
    line.max_angle = radians(0.031);
    crease.measures.creases.push_back(line);
    EXPECT_EQ(crease.only().kind, FindingKind::Crease);
    EXPECT_EQ(crease.only().face, 9);
    // Where only position was asked for, a crease is the design's.
    for (AskedSide& side : crease.asked.sides) {
        side.continuity = Continuity::G0;
    }
    EXPECT_TRUE(crease.judgement().within());
}

TEST(JudgeFill, TakesNothingThatWasNotMeasuredForGood) {
    Fill lost;
    lost.measures.sides[0].samples = 0;
    EXPECT_EQ(lost.only().kind, FindingKind::NotMeasured);
    Fill no_number;
    no_number.measures.sides[0].max_gap = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(no_number.judgement().within());
    Fill open;
    open.measures.open_edges.push_back(open.measures.edges[1]);
    EXPECT_EQ(open.only().kind, FindingKind::OpenEdge);
    EXPECT_EQ(open.only().edge, 11);
    EXPECT_EQ(reached_by(open.asked, open.measures), Continuity::G0);
}

TEST(JudgeFill, PutsTheWorstFirst) {
    Fill fill;
    fill.measures.sides[0].max_gap = 0.002;
    fill.measures.sides[1].max_angle = radians(0.05);
    fill.measures.sides[2].max_angle = radians(0.2);
    const Judgement judgement = fill.judgement();
    ASSERT_EQ(judgement.findings.size(), 3U);
    EXPECT_EQ(judgement.findings[0].edge, 12);
    EXPECT_EQ(judgement.findings[1].edge, 11);
    EXPECT_NEAR(judgement.score, 20.0, 1e-9);
}

TEST(JudgeProblems, TellsTheInputsFromTheFills) {
    EXPECT_TRUE(judge_problems({"a"}, {"b", "c"}).before);
    EXPECT_FALSE(judge_problems({"a", "b"}, {"c"}).before);
    EXPECT_EQ(judge_problems({"a", "b"}, {"c"}).severity, Severity::Poor);
}

TEST(Finding, IsToldWithPlaceFigureAndLimit) {
    Fill fill;
    fill.measures.sides[1].max_angle = radians(0.05);
    fill.measures.sides[1].angle_at = {1.0, 2.5, -3.0};
    EXPECT_EQ(to_text(fill.only()), "angle 0.05 deg, allowed 0.01 deg, edge 11, at (1, 2.5, -3)");
}

}  // namespace
}  // namespace suture

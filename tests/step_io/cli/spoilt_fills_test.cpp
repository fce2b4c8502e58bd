#include "cli/spoilt_fills.h"

#include <gtest/gtest.h>

namespace suture::cli::test {
namespace {

HoleReport filled(int id, const std::string& method, Severity severity, double score) {
    HoleReport hole;
    hole.ids = {id};
    hole.method_used = method;
    hole.status = FillStatus::Filled;
    hole.reason = "as chosen";
    hole.verdict.severity = severity;
    hole.verdict.score = score;
    if (severity == Severity::Bad) {
        Finding finding;
        finding.kind = FindingKind::Gap;
        finding.severity = severity;
        finding.value = score;
        hole.verdict.findings.push_back(finding);
    }
    return hole;
}

HoleReport refused(int id) {
    HoleReport hole;
    hole.ids = {id};
    hole.status = FillStatus::Refused;
    return hole;
}

FillSummary summary(std::vector<HoleReport> holes, const std::vector<int>& lost = {}) {
    FillSummary result;
    result.holes = std::move(holes);
    for (const int id : lost) {
        result.lost_by_writing.push_back({{id}, WritingLoss::Kind::Angle, 1e-4, 1.0});
    }
    return result;
}

using Names = std::vector<std::string>;

TEST(SpoiltFills, AreNoneWhereTheFileHasWhatMemoryHad) {
    FillRequest request;
    SpoiltFills spoilt(request);
    EXPECT_FALSE(
        spoilt.take(summary({filled(1, "mvs", Severity::Near, 1.5), refused(2)}), request));
    EXPECT_TRUE(request.spoilt.empty());
}

TEST(SpoiltFills, GiveWayToTheNextMethod) {
    FillRequest request;
    SpoiltFills spoilt(request);
    EXPECT_TRUE(spoilt.take(
        summary({filled(1, "plane", Severity::Good, 0.1), filled(3, "mvs", Severity::Bad, 900.0)},
                {3}),
        request));
    EXPECT_EQ(request.spoilt.at(3), Names{"mvs"});
    EXPECT_FALSE(request.spoilt.contains(1));
    std::vector<HoleReport> holes = {filled(1, "plane", Severity::Good, 0.1),
                                     filled(3, "tube", Severity::Good, 0.2)};
    EXPECT_FALSE(spoilt.take(summary(holes), request));
    spoilt.put_back(holes);
    EXPECT_EQ(holes[1].method_used, "tube");
    EXPECT_EQ(holes[1].status, FillStatus::Filled);
}

TEST(SpoiltFills, LeaveTheHoleOpenWhereAllAreBad) {
    FillRequest request;
    SpoiltFills spoilt(request);
    EXPECT_TRUE(spoilt.take(summary({filled(3, "mvs", Severity::Bad, 90.0)}), request));
    EXPECT_TRUE(spoilt.take(summary({filled(3, "tube", Severity::Bad, 200.0)}), request));
    EXPECT_EQ(request.spoilt.at(3), (Names{"mvs", "tube"}));
    std::vector<HoleReport> holes = {refused(3)};  // no other method has anything
    EXPECT_TRUE(spoilt.take(summary(holes), request));
    EXPECT_EQ(request.leave_open, std::vector{3});
    EXPECT_FALSE(spoilt.take(summary(holes), request));
    spoilt.put_back(holes);
    EXPECT_EQ(holes[0].status, FillStatus::Refused);
    EXPECT_EQ(holes[0].method_used, "mvs");
    EXPECT_NE(holes[0].reason.find("bad in the written file"), std::string::npos);
}

TEST(SpoiltFills, GoBackToTheOneThatCameOutBest) {
    FillRequest request;
    SpoiltFills spoilt(request);
    EXPECT_TRUE(spoilt.take(summary({filled(3, "recognise", Severity::Poor, 70.0)}, {3}), request));
    EXPECT_TRUE(spoilt.take(summary({filled(3, "mvs", Severity::Near, 2.0)}, {3}), request));
    EXPECT_TRUE(spoilt.take(summary({filled(3, "tube", Severity::Bad, 900.0)}, {3}), request));
    EXPECT_EQ(request.spoilt.at(3), Names{"recognise"});
    EXPECT_TRUE(request.leave_open.empty());
    EXPECT_FALSE(spoilt.take(summary({filled(3, "mvs", Severity::Near, 2.0)}, {3}), request));
}

TEST(SpoiltFills, KeepTheMethodThatWasAskedFor) {
    FillRequest request;
    request.method = "mvs";
    SpoiltFills lost(request);
    EXPECT_FALSE(lost.take(summary({filled(3, "mvs", Severity::Poor, 70.0)}, {3}), request));
    SpoiltFills bad(request);
    EXPECT_TRUE(bad.take(summary({filled(3, "mvs", Severity::Bad, 70.0)}), request));
    EXPECT_EQ(request.leave_open, std::vector{3});
}

}  // namespace
}  // namespace suture::cli::test

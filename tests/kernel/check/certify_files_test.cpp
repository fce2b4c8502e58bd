#include "support/read_for_test.h"
#include "suture/check/certify/certify_edges.h"
#include "suture/check/trace_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace suture {
namespace {

namespace fs = std::filesystem;

struct File {
    const char* name;
    double certified;  ///< at least this part of the edges
};

class CertifiesFiles : public testing::TestWithParam<File> {};

/// Of every certified edge 1001 samples are taken anew; none may be above the bound, and the median
/// bound stays within the slack.
TEST_P(CertifiesFiles, NeverBelowDenseSamplesAndMostlyCloseAbove) {
    const fs::path file = fs::path(SUTURE_CAD_DIR) / "files" / GetParam().name;
    if (!fs::exists(file)) {
        GTEST_SKIP() << file << " is not there";
    }
    const TopoDS_Shape shape = test::read_for_test(file);
    const auto report = measure_continuity(shape, Profile{}, {}, Progress{});
    ASSERT_TRUE(report);
    constexpr double kSlack = 0.05;
    const auto proven = certify_edges(shape, report->edges, Profile{}, kSlack, Progress{});
    ASSERT_TRUE(proven);
    std::vector<int> certified;
    for (const EdgeCertificate& c : *proven) {
        EXPECT_NE(c.certified, !c.reason.empty()) << "Edge" << c.edge;
        if (c.certified) {
            certified.push_back(c.edge);
        }
    }
    EXPECT_GE(static_cast<double>(certified.size()),
              GetParam().certified * static_cast<double>(report->edges.size()));
    const auto traces = trace_edges(shape, certified, 1001, Progress{});
    ASSERT_TRUE(traces);
    std::size_t next = 0;
    std::vector<double> slacks;
    for (std::size_t i = 0; i < proven->size(); ++i) {
        const EdgeCertificate& c = (*proven)[i];
        if (!c.certified) {
            continue;
        }
        double gap = 0.0;
        double angle = 0.0;
        for (const TracePoint& p : (*traces)[next++].points) {
            gap = std::max(gap, p.gap);
            angle = std::isfinite(p.angle) ? std::max(angle, p.angle) : angle;
        }
        EXPECT_LE(gap, c.gap) << "Edge" << c.edge;
        EXPECT_LE(angle, c.angle) << "Edge" << c.edge;
        const Tolerance limit;
        slacks.push_back(std::max((c.gap - gap) / std::max(gap, 0.2 * limit.linear),
                                  (c.angle - angle) / std::max(angle, 0.2 * limit.angular)));
    }
    std::ranges::sort(slacks);
    EXPECT_LE(slacks.at(slacks.size() / 2), kSlack);
}

INSTANTIATE_TEST_SUITE_P(Public, CertifiesFiles,
                         testing::Values(File{"nacelle.stp", 0.7}, File{"ubend2.stp", 1.0},
                                         File{"Trigger_SO101.step", 1.0},
                                         File{"hip_aa_support.STEP", 0.95},
                                         File{"nist_ctc_05_asme1_rd.stp", 1.0},
                                         // Extrusions; poles.

                                         File{"Reflector_Definition.step", 0.99},
                                         File{"4040_base_mount.step", 1.0}));

}  // namespace
}  // namespace suture

#pragma once

#include "suture/check/certify/certify_edges.h"
#include "suture/check/trace_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

/// Certificates of all edges of a shape, compared with many samples.
namespace suture {

inline constexpr double kSlack = 0.05;

struct Certified {
    EdgeContinuity measured;
    EdgeCertificate certificate;
};

inline std::vector<Certified> certify_all(const TopoDS_Shape& shape) {
    const auto report = measure_continuity(shape, Profile{}, {}, Progress{});
    const auto proven = certify_edges(shape, report->edges, Profile{}, kSlack, Progress{});
    EXPECT_TRUE(proven) << proven.error().message;
    std::vector<Certified> result;
    for (std::size_t i = 0; i < report->edges.size(); ++i) {
        result.push_back({report->edges[i], (*proven)[i]});
    }
    return result;
}

/// No sample of many is above the bounds, and the bounds are no farther from the samples than was
/// asked for.
inline void expect_sound_and_tight(const TopoDS_Shape& shape, std::size_t least_certified) {
    std::size_t count = 0;
    for (const Certified& edge : certify_all(shape)) {
        const EdgeCertificate& c = edge.certificate;
        if (!c.certified) {
            EXPECT_FALSE(c.reason.empty());
            continue;
        }
        ++count;
        EXPECT_TRUE(c.within_slack) << "Edge" << c.edge;
        const auto traces = trace_edges(shape, {c.edge}, 2001, Progress{});
        for (const TracePoint& p : traces->at(0).points) {
            EXPECT_LE(p.gap, c.gap) << "Edge" << c.edge << " at " << p.along;
            if (std::isfinite(p.angle)) {
                EXPECT_LE(p.angle, c.angle) << "Edge" << c.edge << " at " << p.along;
            }
        }
        const Tolerance limit;
        EXPECT_LE(c.gap, edge.measured.max_gap +
                             kSlack * std::max(edge.measured.max_gap, 0.2 * limit.linear));
        EXPECT_LE(c.angle, edge.measured.max_angle +
                               kSlack * std::max(edge.measured.max_angle, 0.2 * limit.angular));
    }
    EXPECT_GE(count, least_certified);
}

}  // namespace suture

#include "suture/check/continuity.h"

#include "kernel/check/shapes.h"
#include <gtest/gtest.h>

namespace suture {
namespace {

/// z = x^2 for x < 0 and z = -(1 + steep (y - 1)) x^2 beyond, over y in [0, 2]: the curvatures 2
/// and -2 (1 + steep (y - 1)) are opposite and alike, a mismatch of 2, at y = 1 only; half as much
/// above 1 no farther from there than 1 / steep.
EdgeContinuity measure(double steep) {
    const auto left =
        shapes::height_field(-1.0, 0.0, 2, 1, [&](int i, int) { return i == 0 ? 1.0 : 0.0; });
    const auto right = shapes::height_field(0.0, 1.0, 2, 1, [&](int i, int j) {
        return i == 2 ? -(1.0 + steep * (j == 0 ? -1.0 : 1.0)) : 0.0;
    });
    const auto report = measure_continuity(
        shapes::sewn({shapes::face_on(left), shapes::face_on(right)}), Profile{}, {}, Progress{});
    EXPECT_TRUE(report);
    for (const EdgeContinuity& edge : report->edges) {
        if (edge.faces[0] != edge.faces[1]) {
            return edge;
        }
    }
    ADD_FAILURE() << "no edge";
    return {};
}

TEST(Peaks, FindsNarrowPeakWhereOppositeCurvaturesAreAlike) {
    for (const double steep : {3.0, 200.0, 1e4}) {
        const EdgeContinuity edge = measure(steep);
        EXPECT_NEAR(edge.curvature_mismatch, 2.0, 0.01) << steep;
        EXPECT_NEAR(edge.curvature_at.y(), 1.0, 0.02 / steep) << steep;
        EXPECT_TRUE(edge.opposite_concavity);
    }
}

}  // namespace
}  // namespace suture

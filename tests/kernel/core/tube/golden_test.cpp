#include "suture/fill/tube/curvature.h"
#include "suture/fill/tube/quality.h"

#include "kernel/core/tube/paper_holes.h"
#include <gtest/gtest.h>

namespace suture::tube {
namespace {

using paper::pentagon;
using paper::prepare;
using paper::suitcase;

/// The magnitudes on half a side, from its corner on.
void expect_magnitudes(const Fairing& fairing, const std::vector<double>& wanted) {
    for (std::size_t q = 0; q < wanted.size(); ++q) {
        EXPECT_NEAR(fairing.magnitudes[static_cast<Eigen::Index>(q) + 1], wanted[q], 2e-6) << q;
    }
}

struct Golden {
    paper::Corner corner;
    int columns;
    Functional functional;
    bool free_rows;
    double value;  ///< 0: not known
    std::vector<double> magnitudes;
};

TEST(TubeFairing, HasTheKnownMagnitudesAndValues) {
    const std::vector<Golden> all = {
        {suitcase(), 4, Functional::F1, true, 154.4153, {2.722325, 2.064396}},
        {suitcase(), 4, Functional::F2, true, 343.2860, {2.591804, 2.000922}},
        {suitcase(), 4, Functional::F3, true, 162.7799, {3.059037, 2.196639}},
        {suitcase(), 8, Functional::F2, true, 370.3337, {2.713496, 2.408715, 2.060719, 1.868891}},
        {suitcase(), 8, Functional::F3, true, 94.6711, {3.121361, 2.656272, 2.212746, 1.984377}},
        {pentagon(), 4, Functional::F2, true, 1259.6151, {4.697794, 4.227666}},
        {pentagon(), 4, Functional::F3, true, 344.4204, {5.071669, 4.422556}},
        {pentagon(), 8, Functional::F2, true, 0.0, {4.786920, 4.524213, 4.257530, 4.128990}},
        {pentagon(), 8, Functional::F3, true, 0.0, {5.103254, 4.756254, 4.444586, 4.301767}},
        {suitcase(), 4, Functional::F1, false, 0.0, {3.047333, 2.236103}},
        {suitcase(), 4, Functional::F2, false, 0.0, {2.965262, 2.206063}},
        {suitcase(), 4, Functional::F3, false, 0.0, {3.645567, 2.393616}},
        {pentagon(), 4, Functional::F2, false, 0.0, {5.008592, 4.415977}},
    };
    for (const Golden& golden : all) {
        const auto paper =
            prepare(golden.corner, golden.columns, golden.functional, golden.free_rows);
        const auto fairing = close(paper.net, paper.task);
        ASSERT_TRUE(fairing);
        SCOPED_TRACE(testing::Message() << golden.corner.sides.size() << " sides, F"
                                        << static_cast<int>(golden.functional) + 1);
        expect_magnitudes(*fairing, golden.magnitudes);
        if (golden.value > 0.0) {
            EXPECT_NEAR(fairing->value, golden.value, 6e-5);
        }
    }
}

TEST(TubeFairing, HouseCornerHasTheKnownValues) {
    const double values[] = {838.4387, 2569.6158, 1045.6956};
    const double lows[] = {4.1874, 4.1584, 4.4308};
    const double highs[] = {7.0712, 6.9305, 7.1968};
    for (const int k : {0, 1, 2}) {
        const auto paper = prepare(paper::house(), 4, static_cast<Functional>(k));
        const auto fairing = close(paper.net, paper.task);
        ASSERT_TRUE(fairing);
        EXPECT_NEAR(fairing->value, values[k], 1e-3) << k;
        EXPECT_NEAR(fairing->magnitudes.minCoeff(), lows[k], 1e-4) << k;
        EXPECT_NEAR(fairing->magnitudes.maxCoeff(), highs[k], 1e-4) << k;
    }
}

TEST(TubeFairing, MovesTheClosingPointAsKnown) {
    struct Shift {
        paper::Corner corner;
        bool free_rows;
        double weight, along;
    };
    const std::vector<Shift> all = {
        {suitcase(), true, 1.0, -0.528962},   {suitcase(), true, 10.0, -0.393716},
        {suitcase(), true, 100.0, -0.110693}, {suitcase(), false, 1.0, -0.07959},
        {pentagon(), true, 1.0, -0.649721},   {paper::house(), true, 1.0, -0.509702}};
    for (const Shift& shift : all) {
        auto paper = prepare(shift.corner, 4, Functional::F2, shift.free_rows);
        paper.task.moving = PoleWeight{shift.weight, /*relative=*/false};
        const auto fairing = close(paper.net, paper.task);
        ASSERT_TRUE(fairing);
        const Eigen::Vector3d moved = fairing->pole - shift.corner.pole.point;
        EXPECT_NEAR(moved.dot(shift.corner.pole.normal), shift.along, 6e-6)
            << shift.corner.sides.size() << " " << shift.weight;
        if (shift.corner.sides.size() == 5 && shift.corner.pole.normal.x() > 0.1) {
            EXPECT_NEAR(moved.norm(), 0.715524, 1e-5);
        }
    }
}

TEST(TubeFairing, MeetsCurvaturesAskedForWithTheKnownValues) {
    struct Bend {
        paper::Corner corner;
        double kappa, value;
    };
    const std::vector<Bend> all = {
        {suitcase(), -0.5, 349.1372},     {suitcase(), 0.5, 409.5162},
        {suitcase(), 0.0, 358.4262},      {pentagon(), -0.5, 1455.0116},
        {pentagon(), 0.5, 1719.8127},     {paper::house(), -0.5, 3155.8501},
        {paper::house(), 0.5, 3400.7400},
    };
    for (const Bend& bend : all) {
        auto paper = prepare(bend.corner, 4, Functional::F2);
        paper.task.curvatures = {bend.kappa};
        const auto fairing = close(paper.net, paper.task);
        ASSERT_TRUE(fairing) << fairing.error().message;
        EXPECT_NEAR(fairing->value, bend.value, 1e-3) << bend.kappa;
        for (int k = 0; k < fairing->net.columns(); ++k) {
            EXPECT_NEAR(pole_curvature(fairing->net, bend.corner.pole.normal, k, k + 0.5),
                        bend.kappa, 1e-12);
        }
    }
}

}  // namespace
}  // namespace suture::tube

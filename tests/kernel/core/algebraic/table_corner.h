#pragma once

#include "suture/fill/algebraic/parse.h"
#include "suture/fill/algebraic/partition.h"
#include "suture/fill/algebraic/system.h"

#include <gtest/gtest.h>

/// The corner of a table of the paper (section 4.1): two cones and a cylinder that meet in three
/// quarter circles about (1, 1, 1).
namespace suture::algebraic::table {

using Exact = Polynomial<Rational>;

inline Exact poly(std::string_view text) {
    const auto result = parse_polynomial(text);
    EXPECT_TRUE(result) << result.error().message;
    return result.value_or(Exact());
}

inline const char* kCone1 = "10yz - 25z^2 + 40z - y^2 + 10xy - 8y - 25x^2 + 40x - 16";
inline const char* kCone2 = "4z^2 + 4xz - 12z + 4y^2 + 4xy - 12y + x^2 - 6x + 9";
inline const char* kCylinder = "(x-1)^2 + (y-1)^2 - 1";

/// Corners in the order of the sides below: side i runs from corner i to corner i + 1.
inline const std::vector<Point<Rational>> kCorners = {{0, 1, 1}, {1, 1, 0}, {1, 0, 1}};
inline const Point<Rational> kCentre = {1, 1, 1};
inline const Point<Rational> kOuter = {Rational(2, 3), Rational(2, 3), Rational(2, 3)};

/// f1 at y = 1, f2 at x = 1, f3 at z = 1.
inline std::vector<Side<Rational>> sides(int k = 1) {
    return {{poly(kCone1), poly("y-1"), k},
            {poly(kCone2), poly("x-1"), k},
            {poly(kCylinder), poly("z-1"), k}};
}

inline std::vector<Side<Rational>> cylinders(int k = 1) {
    return {{poly("(x-1)^2 + (z-1)^2 - 1"), poly("y-1"), k},
            {poly("(y-1)^2 + (z-1)^2 - 1"), poly("x-1"), k},
            {poly(kCylinder), poly("z-1"), k}};
}

inline std::vector<Exact> planes(const Partition& partition) {
    const auto points = ray_points(partition, kCorners, kOuter);
    std::vector<Exact> result;
    for (const Interface& i : partition.interfaces) {
        result.push_back(plane_through(kCentre, points[static_cast<std::size_t>(i.from)],
                                       points[static_cast<std::size_t>(i.to)]));
    }
    return result;
}

inline System<Rational> system(const Partition& partition, const std::vector<Side<Rational>>& given,
                               int degree, int k = 1) {
    return make_system(partition, given, planes(partition), k, degree);
}

}  // namespace suture::algebraic::table

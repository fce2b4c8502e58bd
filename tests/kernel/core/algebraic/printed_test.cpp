#include "kernel/core/algebraic/table_corner.h"
#include <gtest/gtest.h>

/// The solutions that the paper prints, and the one that it says does not exist, in exact
/// arithmetic.
namespace suture::algebraic {
namespace {

using table::Exact;
using table::poly;

/// Whether a linear polynomial's n-th power divides p: with plane = t as a new variable in place of
/// one of the old, all terms have t^n.
bool divides(const Exact& plane, int n, const Exact& p) {
    std::size_t axis = 0;
    while (plane.coefficients[axis + 1] == 0) {
        ++axis;
    }
    std::array<Exact, 3> by = {poly("x"), poly("y"), poly("z")};
    const Rational c = plane.coefficients[axis + 1];
    by[axis] = (1 / c) * (by[axis] - (plane - c * by[axis]));
    const Exact q = substitute(p, by);
    const auto all = monomials(q.degree);
    for (std::size_t m = 0; m < all.size(); ++m) {
        const int exponent = axis == 0 ? all[m].i : axis == 1 ? all[m].j : all[m].k;
        if (exponent < n && q.coefficients[m] != 0) {
            return false;
        }
    }
    return true;
}

Exact joined(const char* gamma, const char* f, const char* beta, const char* F) {
    return poly(gamma) * poly(f) + poly(beta) * power(poly(F), 2);
}

TEST(PrintedSolutions, DivisibilityIsTold) {
    EXPECT_TRUE(divides(poly("2x-3z+1"), 2, poly("(2x-3z+1)^2(y+z)")));
    EXPECT_FALSE(divides(poly("2x-3z+1"), 2, poly("(2x-3z+1)(y+z)")));
}

TEST(PrintedSolutions, QuarticHoldsAsPrinted) {
    const Exact g1 = joined("25x^2-182y^2-21xy-25xz+10yz-60x+300y-16z", table::kCone1,
                            "-5730x^2+63y^2-4920z^2+4129/3 xy+3272xz-493yz+29027/3 x+1579y+10060z"
                            "-9537",
                            "y-1");
    const Exact g2 = joined(
        "1295/2 x^2-395/2 y^2+1565/4 xy+625/4 xz-125/2 yz-6745/4 x+915/2 y+100z", table::kCone2,
        "-8773/6 x^2-9705/2 y^2-4360z^2-10797/4 xy-6309/4 xz-2785/2 yz"
        "+80855/12 x+23471/2 y+9416z-9537",
        "x-1");
    const Exact g3 =
        joined("-625x^2-790y^2+4780z^2+775xy+625xz-250yz+1250x+2620y-9160z", table::kCylinder,
               "-5405x^2-6090y^2+z^2+1806xy+1375/3 xz-249yz+28157/3 x+13233y+402z-9537", "z-1");
    EXPECT_TRUE(divides(poly("x-y"), 2, g1 - g2));
    EXPECT_TRUE(divides(poly("x-z"), 2, g2 - g3));
    EXPECT_TRUE(divides(poly("y-z"), 2, g3 - g1));
}

/// The cubic in seven cells with the names of the first two surfaces exchanged.
bool cubic_holds(const char* alpha5) {
    const Exact gx = joined("-5/16 y-5/16 z+15/16", table::kCone2,
                            "40103/648 x+193/48 y-77539/1296 z-1033/432", "x-1");
    const Exact gy = joined("1/20 x+7/100 y+1/20 z-11/50", table::kCone1,
                            "-11/15 x+1070909/16200 y-209251/3240 z+3323/1350", "y-1");
    const Exact gz = joined("-5/4 x-5/4 y-5/4 z+5", table::kCylinder, "x+y+z+1", "z-1");
    const Exact g4 =
        gx + poly("-58219/5400 x-140317/16200 y+19459/1620 z+6193/900") * poly("(3x-2y-1)^2");
    const Exact g5 = gy + poly("-3/10 x-61219/5400 y+7447/1800 z+4691/675") * poly("(3y-2z-1)^2");
    const Exact g6 = gz + poly(alpha5) * poly("(-2x+3z-1)^2");
    const Exact g7 =
        g4 + poly("-28399/21600 x-30289/21600 y+95/72 z+13609/10800") * poly("(3x+3y-5z-1)^2");
    return divides(poly("-2x+3y-1"), 2, g4 - gy) && divides(poly("-2y+3z-1"), 2, g5 - gz) &&
           divides(poly("3x-2z-1"), 2, g6 - gx) && divides(poly("-5x+3y+3z-1"), 2, g7 - g5) &&
           divides(poly("3x-5y+3z-1"), 2, g7 - g6);
}

TEST(PrintedSolutions, CubicInSevenCellsHoldsWithItsErrataOnly) {
    EXPECT_TRUE(cubic_holds("-13711/1620 x-37/60 y+2599/1620 z+187/27"));
    EXPECT_FALSE(cubic_holds("-13711/1620 x-37/90 y+2599/1620 z+187/27"));
}

TEST(PrintedSolutions, CubicInThreeCellsExists) {
    const Exact g1 = joined("(22-5x-7y-5z)/125", table::kCone1, "(240x+43y+365z-698)/125", "y-1");
    const Exact g2 = joined("(y+z-3)/4", table::kCone2, "(36x-5y-13z-33)/20", "x-1");
    const Exact g3 = joined("x+y+z-4", table::kCylinder, "(3x+10y+4z-22)/5", "z-1");
    EXPECT_TRUE(divides(poly("x-y"), 2, g1 - g2));
    EXPECT_TRUE(divides(poly("x-z"), 2, g2 - g3));
    EXPECT_TRUE(divides(poly("y-z"), 2, g3 - g1));
}

}  // namespace
}  // namespace suture::algebraic

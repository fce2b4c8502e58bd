#include "suture/fill/algebraic/exact.h"

#include "kernel/core/algebraic/table_corner.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace suture::algebraic {
namespace {

using table::poly;
using Exact = Polynomial<Rational>;

TEST(ParsePolynomial, ReadsWhatItWrites) {
    for (const char* text : {"0", "-x", "x^2*y - 3/4*z + 1/2", "y*z^3 - 2*x*y*z - 7"}) {
        EXPECT_EQ(to_text(poly(text)), text);
    }
    EXPECT_EQ(to_text(poly("2(x-1)(x+1)z / 4 - .5e1y + 010")), "1/2*x^2*z - 1/2*z - 5*y + 10");
    EXPECT_EQ(to_text(rounded(poly("x/3"))), "0.33333333333333331*x");
}

TEST(ParsePolynomial, RefusesWhatIsNone) {
    for (const char* text :
         {"", "x+", "(x", "x)", "2/x", "1/0", "w", "x^y", "x^99", "x^20y", "1..2"}) {
        const auto result = parse_polynomial(text);
        ASSERT_FALSE(result) << text;
        EXPECT_EQ(result.error().code, ErrorCode::Usage);
    }
}

TEST(Polynomial, SubstitutesAsEvaluationsCompose) {
    const Exact p = poly("x^3 - 2xyz + 5y^2 - z + 4");
    const std::array<Exact, 3> by = {poly("x + 2y"), poly("3 - z"), poly("x y")};
    const Point<Rational> at = {Rational(2), Rational(-1, 3), Rational(5)};
    const Exact composed = substitute(p, by);
    EXPECT_EQ(evaluate(composed, at),
              evaluate(p, {evaluate(by[0], at), evaluate(by[1], at), evaluate(by[2], at)}));
}

struct Shape {
    int rows, columns, rank, dimension, polynomials;
    bool operator==(const Shape&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Shape& s) {
    return out << s.rows << "x" << s.columns << " rank " << s.rank << " dim " << s.dimension
               << " g " << s.polynomials;
}
Shape shape_of(const System<Rational>& system) {
    const ExactSpace space = solve_exactly(system);
    return {system.rows, system.columns, space.rank, space.dimension,
            static_cast<int>(space.basis.size())};
}

TEST(ExactSpace, HasTheRanksOfTheTableCorner) {
    // 3 of the 13 solutions are gamma = c F^2, beta = -c f: they leave g unchanged.
    EXPECT_EQ(shape_of(table::system(umbrella(3), table::sides(), 4)),
              (Shape{105, 90, 77, 13, 10}));
    // The paper prints rank 55 and dimension 5.
    EXPECT_EQ(shape_of(table::system(with_inner_cells(3), table::sides(), 3)),
              (Shape{100, 60, 54, 6, 6}));
    // The paper says that there is none.
    EXPECT_EQ(shape_of(table::system(umbrella(3), table::sides(), 3)), (Shape{60, 36, 35, 1, 1}));
}

TEST(ExactSpace, HasTheRanksOfThreeCylinders) {
    EXPECT_EQ(exact_rank(table::system(umbrella(3), table::cylinders(), 4)), 74);
    EXPECT_EQ(exact_rank(table::system(with_inner_cells(3), table::cylinders(), 3)), 51);
    EXPECT_EQ(exact_rank(table::system(umbrella(3), table::cylinders(), 3)), 32);
}

/// Whether a polynomial's gradient vanishes at a point where it is zero itself: the shifted
/// polynomial has no linear part.
bool is_singular_at(const Polynomial<Rational>& p, const Point<Rational>& at) {
    std::array<Polynomial<Rational>, 3> by;
    for (std::size_t c = 0; c < 3; ++c) {
        std::array<Rational, 3> axis{0, 0, 0};
        axis[c] = 1;
        by[c] = Polynomial<Rational>::linear(axis, at[c]);
    }
    const Polynomial<Rational> shifted = substitute(p, by);
    return shifted.coefficients.size() < 4 ||
           std::all_of(shifted.coefficients.begin(), shifted.coefficients.begin() + 4,
                       [](const Rational& c) { return c == 0; });
}

TEST(ExactSpace, IsSingularAtTheTablesCornersWithCurvature) {
    // The cones and the cylinder have different curvatures there.
    const int degree = 5;
    const ExactSpace space = solve_exactly(table::system(umbrella(3), table::sides(2), degree, 2));
    ASSERT_FALSE(space.basis.empty());
    for (const auto& member : space.basis) {
        const auto cells = split_cells(member, degree);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_TRUE(is_singular_at(cells[i], table::kCorners[i])) << i;
            EXPECT_TRUE(is_singular_at(cells[(i + 2) % 3], table::kCorners[i])) << i;
        }
    }
    // With tangency there are regular ones.
    const ExactSpace tangent = solve_exactly(table::system(umbrella(3), table::sides(), 3));
    EXPECT_FALSE(is_singular_at(split_cells(tangent.basis.front(), 3)[0], table::kCorners[0]));
}

}  // namespace
}  // namespace suture::algebraic

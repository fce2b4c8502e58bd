#pragma once

#include "suture/base/result.h"
#include "suture/fill/algebraic/polynomial.h"
#include "suture/fill/algebraic/rational.h"

#include <string>
#include <string_view>

namespace suture::algebraic {

/// Reads "10yz - 25z^2 + 3/4 (x - 1)^2 - 0.5": variables x, y, z, + - * / ^, parentheses, products
/// without a sign; decimals are taken as the exact fractions that they are.
///
/// Refuses  (Usage) anything else, with the place; division by anything but a number; a degree
///          above 20, more than 100 parentheses within each other, more than 20,000 characters.
[[nodiscard]] Result<Polynomial<Rational>> parse_polynomial(std::string_view text);

/// The same text again: exact coefficients, highest degree first; "0" for nothing.
[[nodiscard]] std::string to_text(const Polynomial<Rational>& polynomial);

/// With 17 significant digits.
[[nodiscard]] std::string to_text(const Polynomial<double>& polynomial);

/// The nearest doubles.
[[nodiscard]] Polynomial<double> rounded(const Polynomial<Rational>& polynomial);

}  // namespace suture::algebraic

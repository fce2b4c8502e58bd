#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace suture::algebraic {

/// Exact numbers, without expression templates so that they can be deduced as template arguments.
using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                               boost::multiprecision::et_off>;

}  // namespace suture::algebraic

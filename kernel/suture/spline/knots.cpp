#include "suture/spline/knots.h"

#include "suture/base/contract.h"

#include <algorithm>
#include <cmath>

namespace suture {

int find_span(const std::vector<double>& knots, int degree, double t) {
    const int count = static_cast<int>(knots.size()) - degree - 1;
    SUTURE_EXPECTS(count > degree);
    const auto first = knots.begin() + degree;
    const auto last = knots.begin() + count;
    // The last knot that is not above t, kept inside the domain.
    auto it = std::upper_bound(first, last, t);
    if (it == last) {
        it = std::lower_bound(first, last, knots[static_cast<std::size_t>(count)]);
    }
    if (it == first) {
        it = std::upper_bound(first, last, *first);
    }
    return static_cast<int>(it - knots.begin()) - 1;
}

Eigen::MatrixXd basis_derivatives(const std::vector<double>& knots, int degree, int span, double t,
                                  int orders) {
    const auto knot = [&](int i) { return knots[static_cast<std::size_t>(i)]; };
    // ndu: basis functions above the diagonal, knot differences below it, as in A2.3.
    Eigen::MatrixXd ndu(degree + 1, degree + 1);
    Eigen::VectorXd left(degree + 1), right(degree + 1);
    ndu(0, 0) = 1.0;
    for (int j = 1; j <= degree; ++j) {
        left[j] = t - knot(span + 1 - j);
        right[j] = knot(span + j) - t;
        double saved = 0.0;
        for (int r = 0; r < j; ++r) {
            ndu(j, r) = right[r + 1] + left[j - r];
            const double term = ndu(r, j - 1) / ndu(j, r);
            ndu(r, j) = saved + right[r + 1] * term;
            saved = left[j - r] * term;
        }
        ndu(j, j) = saved;
    }
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(orders + 1, degree + 1);
    result.row(0) = ndu.col(degree).transpose();
    const int highest = std::min(orders, degree);
    for (int r = 0; r <= degree; ++r) {
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2, degree + 1);
        a(0, 0) = 1.0;
        int now = 0;
        for (int k = 1; k <= highest; ++k) {
            const int next = 1 - now;
            const int rk = r - k;
            const int pk = degree - k;
            double d = 0.0;
            if (rk >= 0) {
                a(next, 0) = a(now, 0) / ndu(pk + 1, rk);
                d = a(next, 0) * ndu(rk, pk);
            }
            const int j1 = rk >= -1 ? 1 : -rk;
            const int j2 = r - 1 <= pk ? k - 1 : degree - r;
            for (int j = j1; j <= j2; ++j) {
                a(next, j) = (a(now, j) - a(now, j - 1)) / ndu(pk + 1, rk + j);
                d += a(next, j) * ndu(rk + j, pk);
            }
            if (r <= pk) {
                a(next, k) = -a(now, k - 1) / ndu(pk + 1, r);
                d += a(next, k) * ndu(r, pk);
            }
            result(k, r) = d;
            now = next;
        }
    }
    double factor = degree;
    for (int k = 1; k <= highest; ++k) {
        result.row(k) *= factor;
        factor *= degree - k;
    }
    return result;
}

}  // namespace suture

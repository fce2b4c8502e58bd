#include "suture/fill/mvs/net.h"

#include "suture/base/contract.h"
#include "suture/spline/knots.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <numeric>

namespace suture::mvs {

int Axis::span_of(double t) const {
    return find_span(knots, kDegree, t) - kDegree;
}

Axis uniform_axis(double lower, double upper, int spans) {
    SUTURE_EXPECTS(spans >= 1 && lower < upper);
    Axis axis;
    axis.knots.assign(kDegree, lower);
    for (int k = 0; k <= spans; ++k) {
        const double t = static_cast<double>(k) / spans;
        axis.knots.push_back((1.0 - t) * lower + t * upper);
    }
    axis.knots.insert(axis.knots.end(), kDegree, upper);
    return axis;
}

Axis halved(const Axis& axis, const std::vector<bool>& marked) {
    SUTURE_EXPECTS(static_cast<int>(marked.size()) == axis.spans());
    Axis result = axis;
    for (int k = 0; k < axis.spans(); ++k) {
        if (marked[static_cast<std::size_t>(k)]) {
            result.knots.push_back(0.5 * (axis.lower(k) + axis.upper(k)));
        }
    }
    std::sort(result.knots.begin(), result.knots.end());
    return result;
}

Eigen::MatrixXd refine(const Axis& coarse, const Axis& fine, const Eigen::MatrixXd& coefficients) {
    std::vector<double> inserted;
    std::set_difference(fine.knots.begin(), fine.knots.end(), coarse.knots.begin(),
                        coarse.knots.end(), std::back_inserter(inserted));
    std::vector<double> knots = coarse.knots;
    Eigen::MatrixXd now = coefficients;
    for (const double t : inserted) {
        const int span = find_span(knots, kDegree, t);
        Eigen::MatrixXd next(now.rows(), now.cols() + 1);
        next.leftCols(span - kDegree + 1) = now.leftCols(span - kDegree + 1);
        next.rightCols(now.cols() - span) = now.rightCols(now.cols() - span);
        for (int i = span - kDegree + 1; i <= span; ++i) {
            const double left = knots[static_cast<std::size_t>(i)];
            const double right = knots[static_cast<std::size_t>(i + kDegree)];
            const double a = (t - left) / (right - left);
            next.col(i) = a * now.col(i) + (1.0 - a) * now.col(i - 1);
        }
        knots.insert(knots.begin() + span + 1, t);
        now = std::move(next);
    }
    SUTURE_EXPECTS(knots == fine.knots);
    return now;
}

BasisRow basis_row(const Axis& axis, double t) {
    return basis_row(axis, axis.span_of(t), t);
}

BasisRow basis_row(const Axis& axis, int span, double t) {
    return {span, basis_derivatives(axis.knots, kDegree, span + kDegree, t, 3)};
}

LocalBasis local_basis(const BasisRow& u, const BasisRow& v) {
    // The orders in u and v of the nine derivatives of variation.h.
    constexpr std::array<std::array<int, 2>, kDerivatives> kOrders = {
        {{1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}}};
    LocalBasis basis;
    for (int d = 0; d < kDerivatives; ++d) {
        const auto [du, dv] = kOrders[static_cast<std::size_t>(d)];
        for (int b = 0; b < kOrder; ++b) {
            basis.col(d).segment<kOrder>(kOrder * b) = v.values(dv, b) * u.values.row(du);
        }
    }
    return basis;
}

LocalValues local_values(const BasisRow& u, const BasisRow& v) {
    LocalValues values;
    for (int b = 0; b < kOrder; ++b) {
        values.segment<kOrder>(kOrder * b) = v.values(0, b) * u.values.row(0);
    }
    return values;
}

Eigen::Matrix<double, 3, kLocal> Net::local_poles(int span_u, int span_v) const {
    Eigen::Matrix<double, 3, kLocal> local;
    for (int b = 0; b < kOrder; ++b) {
        local.middleCols<kOrder>(kOrder * b) =
            poles.middleCols<kOrder>(span_u + u.count() * (span_v + b));
    }
    return local;
}

namespace {

// Changes both axes of a net by a linear map of the coefficients along each: dim x count to
// dim x new count.
template <class AlongU, class AlongV>
Net mapped(const Net& net, const Axis& u, const Axis& v, const AlongU& along_u,
           const AlongV& along_v) {
    const int old_u = net.u.count();
    const int old_v = net.v.count();
    // Rows of poles along u, then columns along v.
    Eigen::MatrixXd rows(3 * old_v, old_u);
    for (int j = 0; j < old_v; ++j) {
        rows.middleRows(3 * j, 3) = net.poles.middleCols(old_u * j, old_u);
    }
    rows = along_u(rows);
    Eigen::MatrixXd before(3 * u.count(), old_v);
    for (int j = 0; j < old_v; ++j) {
        for (int i = 0; i < u.count(); ++i) {
            before.block<3, 1>(3 * i, j) = rows.block<3, 1>(3 * j, i);
        }
    }
    const Eigen::MatrixXd after = along_v(before);
    Net result{u, v, Eigen::Matrix3Xd(3, u.count() * v.count())};
    for (int j = 0; j < v.count(); ++j) {
        for (int i = 0; i < u.count(); ++i) {
            result.poles.col(i + u.count() * j) = after.block<3, 1>(3 * i, j);
        }
    }
    return result;
}

// The values of an axis's functions at these places: places x count.
Eigen::MatrixXd values_at(const Axis& axis, const std::vector<double>& places) {
    Eigen::MatrixXd values =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(places.size()), axis.count());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const BasisRow row = basis_row(axis, places[k]);
        values.row(static_cast<Eigen::Index>(k)).segment<kOrder>(row.first) = row.values.row(0);
    }
    return values;
}

// What turns coefficients over one axis, as rows, into those that interpolate them over another.
Eigen::MatrixXd interpolation(const Axis& from, const Axis& to) {
    std::vector<double> places;
    for (int k = 0; k < to.count(); ++k) {
        const auto first = to.knots.begin() + k + 1;
        places.push_back(std::accumulate(first, first + kDegree, 0.0) / kDegree);
    }
    return values_at(to, places).partialPivLu().solve(values_at(from, places)).transpose();
}

}  // namespace

Net refine(const Net& net, const Axis& u, const Axis& v) {
    return mapped(
        net, u, v, [&](const Eigen::MatrixXd& rows) { return refine(net.u, u, rows); },
        [&](const Eigen::MatrixXd& rows) { return refine(net.v, v, rows); });
}

Net interpolated(const Net& net, const Axis& u, const Axis& v) {
    const Eigen::MatrixXd along_u = interpolation(net.u, u);
    const Eigen::MatrixXd along_v = interpolation(net.v, v);
    return mapped(
        net, u, v, [&](const Eigen::MatrixXd& rows) { return Eigen::MatrixXd(rows * along_u); },
        [&](const Eigen::MatrixXd& rows) { return Eigen::MatrixXd(rows * along_v); });
}

std::vector<Eigen::MatrixXd> gram_matrices(const Axis& axis) {
    // Six points integrate products of two quintics exactly.
    const GaussRule& rule = gauss_rule(kOrder);
    std::vector<Eigen::MatrixXd> gram(4, Eigen::MatrixXd::Zero(axis.count(), kOrder));
    for (int k = 0; k < axis.spans(); ++k) {
        if (axis.empty(k)) {
            continue;
        }
        const double h = axis.upper(k) - axis.lower(k);
        for (std::size_t q = 0; q < rule.nodes.size(); ++q) {
            const BasisRow row = basis_row(axis, axis.lower(k) + h * rule.nodes[q]);
            for (int d = 0; d < 4; ++d) {
                for (int a = 0; a < kOrder; ++a) {
                    for (int b = a; b < kOrder; ++b) {
                        gram[static_cast<std::size_t>(d)](k + a, b - a) +=
                            h * rule.weights[q] * row.values(d, a) * row.values(d, b);
                    }
                }
            }
        }
    }
    return gram;
}

const GaussRule& gauss_rule(int points) {
    // Abscissae and weights of Gauss and Legendre on [-1,1], moved to [0,1].
    static const GaussRule two = {{0.2113248654051871, 0.7886751345948129}, {0.5, 0.5}};
    static const GaussRule three = {{0.1127016653792583, 0.5, 0.8872983346207417},
                                    {0.2777777777777778, 0.4444444444444444, 0.2777777777777778}};
    static const GaussRule four = {
        {0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263},
        {0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269}};
    static const GaussRule six = {{0.0337652428984240, 0.1693953067668677, 0.3806904069584015,
                                   0.6193095930415985, 0.8306046932331323, 0.9662347571015760},
                                  {0.0856622461895852, 0.1803807865240693, 0.2339569672863455,
                                   0.2339569672863455, 0.1803807865240693, 0.0856622461895852}};
    SUTURE_EXPECTS(points == 2 || points == 3 || points == 4 || points == kOrder);
    return points == 2 ? two : points == 3 ? three : points == 4 ? four : six;
}

}  // namespace suture::mvs

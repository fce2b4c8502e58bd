#include "suture/fill/mvs/outside.h"

#include "suture/fill/mvs/polygon.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>

namespace suture::mvs {
namespace {

// Points a polygon's edge, by which the spans are found that it runs through.
constexpr int kAlong = 8;
// The polygon lies off the boundary by less than this part of the box.
constexpr double kBeside = 1e-3;

/// Which spans of a net have a part of the domain; u fastest.
std::vector<bool> spans_inside(const std::vector<Eigen::Matrix2Xd>& polygons, const Net& net) {
    const auto width = static_cast<std::size_t>(net.u.spans());
    std::vector<bool> inside(width * static_cast<std::size_t>(net.v.spans()), false);
    const auto mark = [&](const Eigen::Vector2d& uv) {
        inside[static_cast<std::size_t>(net.u.span_of(uv.x())) +
               width * static_cast<std::size_t>(net.v.span_of(uv.y()))] = true;
    };
    const Eigen::Vector2d beside =
        kBeside * Eigen::Vector2d(net.u.knots.back() - net.u.knots.front(),
                                  net.v.knots.back() - net.v.knots.front());
    for (const Eigen::Matrix2Xd& polygon : polygons) {
        for (Eigen::Index k = 0; k < polygon.cols(); ++k) {
            const Eigen::Vector2d from = polygon.col(k);
            const Eigen::Vector2d step = (polygon.col((k + 1) % polygon.cols()) - from) / kAlong;
            for (int q = 0; q < kAlong; ++q) {
                const Eigen::Vector2d uv = from + q * step;
                for (const Eigen::Vector2d& sign :
                     {Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, -1),
                      Eigen::Vector2d(-1, -1)}) {
                    mark(uv + sign.cwiseProduct(beside));
                }
            }
        }
    }
    for (int j = 0; j < net.v.spans(); ++j) {
        const std::vector<double> cut =
            crossings(polygons, 0.5 * (net.v.lower(j) + net.v.upper(j)));
        for (int i = 0; i < net.u.spans(); ++i) {
            const double middle = 0.5 * (net.u.lower(i) + net.u.upper(i));
            if ((std::lower_bound(cut.begin(), cut.end(), middle) - cut.begin()) % 2 == 1) {
                inside[static_cast<std::size_t>(i) + width * static_cast<std::size_t>(j)] = true;
            }
        }
    }
    return inside;
}

/// The number of each pole that is free to move, -1 for the others; u fastest.
std::vector<int> free_poles(const std::vector<bool>& inside, const Net& net) {
    std::vector<int> numbers;
    int next = 0;
    for (int j = 0; j < net.v.count(); ++j) {
        for (int i = 0; i < net.u.count(); ++i) {
            bool used = false;
            for (int b = std::max(0, j - kDegree); b <= std::min(j, net.v.spans() - 1); ++b) {
                for (int a = std::max(0, i - kDegree); a <= std::min(i, net.u.spans() - 1); ++a) {
                    used = used || inside[static_cast<std::size_t>(a + net.u.spans() * b)];
                }
            }
            numbers.push_back(used ? -1 : next++);
        }
    }
    return numbers;
}

/// Entry (i, k) of a symmetric band that is given by its upper diagonals, one a column.
double entry(const Eigen::MatrixXd& band, int i, int k) {
    return band(std::min(i, k), std::abs(i - k));
}

}  // namespace

void settle_outside(const std::vector<Eigen::Matrix2Xd>& polygons, Net& net) {
    const std::vector<int> number = free_poles(spans_inside(polygons, net), net);
    const int unknowns = 1 + *std::max_element(number.begin(), number.end());
    if (unknowns == 0) {
        return;
    }
    const std::vector<Eigen::MatrixXd> gu = gram_matrices(net.u);
    const std::vector<Eigen::MatrixXd> gv = gram_matrices(net.v);
    const int nu = net.u.count();
    const int nv = net.v.count();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(unknowns, 3);
    for (int j = 0; j < nv; ++j) {
        for (int i = 0; i < nu; ++i) {
            const int row = number[static_cast<std::size_t>(i + nu * j)];
            if (row < 0) {
                continue;
            }
            for (int b = std::max(0, j - kDegree); b <= std::min(nv - 1, j + kDegree); ++b) {
                for (int a = std::max(0, i - kDegree); a <= std::min(nu - 1, i + kDegree); ++a) {
                    const double value = entry(gu[2], i, a) * entry(gv[0], j, b) +
                                         2.0 * entry(gu[1], i, a) * entry(gv[1], j, b) +
                                         entry(gu[0], i, a) * entry(gv[2], j, b);
                    const int column = number[static_cast<std::size_t>(a + nu * b)];
                    if (column >= 0) {
                        entries.emplace_back(row, column, value);
                    } else {
                        right.row(row) -= value * net.poles.col(a + nu * b).transpose();
                    }
                }
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    if (factors.info() != Eigen::Success) {
        return;  // the poles stay where the objective has laid them
    }
    const Eigen::MatrixX3d poles = factors.solve(right);
    for (Eigen::Index k = 0; k < net.poles.cols(); ++k) {
        const int row = number[static_cast<std::size_t>(k)];
        if (row >= 0) {
            net.poles.col(k) = poles.row(row).transpose();
        }
    }
}

}  // namespace suture::mvs

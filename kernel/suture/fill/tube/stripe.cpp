#include "suture/fill/tube/stripe.h"

#include "suture/base/contract.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suture::tube {
namespace {

using Eigen::Vector3d;

/// Quadratic B-splines along pieces, with the intervals before and after them.
struct Line {
    std::vector<double> intervals;
    Ends ends;

    [[nodiscard]] int count() const { return static_cast<int>(intervals.size()); }
    [[nodiscard]] double interval(int k) const {
        const int m = count();
        if (ends == Ends::Clamped && (k < 0 || k >= m)) {
            return 0.0;
        }
        return intervals[static_cast<std::size_t>(ends == Ends::Closed ? (k + m) % m
                                                                       : std::clamp(k, 0, m - 1))];
    }
    /// The two inner knots of column k + j on interval k, in the parameter x of that interval: a
    /// column's point is the blossom of the polynomial there.
    [[nodiscard]] std::array<double, 2> inner_knots(int k, int j) const {
        const double g = interval(k);
        const double before = -interval(k - 1) / g;
        const double after = 1.0 + interval(k + 1) / g;
        const std::array knots = {before, 0.0, 1.0, after};
        return {knots[static_cast<std::size_t>(j)], knots[static_cast<std::size_t>(j) + 1]};
    }
};

Vector3d blossom(const Piece& piece, double x, double y) {
    return piece.col(0) + piece.col(1) * (0.5 * (x + y)) + piece.col(2) * (x * y);
}

/// The polynomial's coefficients as combinations of columns k, k + 1, k + 2 (one column each): the
/// inverse of the three blossoms.
Eigen::Matrix3d coefficients(const Line& line, int k) {
    Eigen::Matrix3d blossoms;
    for (int j = 0; j < 3; ++j) {
        const auto [x, y] = line.inner_knots(k, j);
        blossoms.row(j) << 1.0, 0.5 * (x + y), x * y;
    }
    return blossoms.inverse().transpose();
}

}  // namespace

std::vector<Piece> bezier_pieces(const Curve& curve, const std::vector<double>& t) {
    std::vector<Piece> pieces;
    for (std::size_t k = 0; k + 1 < t.size(); ++k) {
        const Vector3d begin = curve(t[k]);
        const Vector3d end = curve(t[k + 1]);
        const Vector3d inner = 2.0 * curve(0.5 * (t[k] + t[k + 1])) - 0.5 * (begin + end);
        Piece piece;
        piece << begin, 2.0 * (inner - begin), begin - 2.0 * inner + end;
        pieces.push_back(piece);
    }
    return pieces;
}

std::vector<Piece> taylor_pieces(const Curve& curve, const Curve& first, const Curve& second,
                                 const std::vector<double>& t) {
    std::vector<Piece> pieces;
    for (std::size_t k = 0; k + 1 < t.size(); ++k) {
        const double h = t[k + 1] - t[k];
        Piece piece;
        piece << curve(t[k]), h * first(t[k]), 0.5 * h * h * second(t[k]);
        pieces.push_back(piece);
    }
    return pieces;
}

std::vector<double> chord_lengths(const std::vector<Piece>& pieces) {
    std::vector<double> lengths;
    lengths.reserve(pieces.size());
    for (const Piece& piece : pieces) {
        lengths.push_back((piece.col(1) + piece.col(2)).norm());
    }
    const double mean =
        std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(lengths.size());
    for (double& length : lengths) {
        length /= mean;
    }
    return lengths;
}

Eigen::Matrix3Xd march(const std::vector<Piece>& pieces, const std::vector<double>& intervals,
                       Ends ends) {
    SUTURE_EXPECTS(pieces.size() == intervals.size() && pieces.size() >= 3);
    const Line line{intervals, ends};
    const bool closed = ends == Ends::Closed;
    const int m = line.count();
    Eigen::Matrix3Xd columns(3, m + 2);
    // (10) for the rows of points, (11) for those of tangents, one after the other.
    for (int k = 0; k < m; ++k) {
        for (int j = 0; j < 3; ++j) {
            const auto [x, y] = line.inner_knots(k, j);
            const int column = closed ? (k + j) % m : k + j;
            columns.col(column) = blossom(pieces[static_cast<std::size_t>(k)], x, y);
        }
    }
    if (closed) {
        columns.rightCols<2>() = columns.leftCols<2>().eval();
    }
    return columns;
}

Eigen::Matrix3Xd fit_all(const std::vector<Piece>& pieces, const std::vector<double>& intervals,
                         Ends ends) {
    SUTURE_EXPECTS(pieces.size() == intervals.size() && pieces.size() >= 3);
    const Line line{intervals, ends};
    const bool closed = ends == Ends::Closed;
    const int m = line.count();
    // The square of a quadratic's coefficients in Legendre polynomials on [0,1] is its integral.
    Eigen::Matrix3d legendre;
    legendre << 1.0, 0.5, 1.0 / 3.0, 0.0, 0.5 / std::sqrt(3.0), 0.5 / std::sqrt(3.0), 0.0, 0.0,
        1.0 / (6.0 * std::sqrt(5.0));
    const int unknowns = closed ? m : m + 2;
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(3 * m, unknowns);
    Eigen::MatrixXd right(3 * m, 3);
    for (int k = 0; k < m; ++k) {
        const double weight = std::sqrt(line.interval(k));
        const Eigen::Matrix3d shares = weight * legendre * coefficients(line, k).transpose();
        for (int j = 0; j < 3; ++j) {
            system.block<3, 1>(3 * k, (k + j) % unknowns) += shares.col(j);
        }
        right.middleRows<3>(3 * k) =
            weight * legendre * pieces[static_cast<std::size_t>(k)].transpose();
    }
    const Eigen::MatrixXd solution = system.colPivHouseholderQr().solve(right);
    Eigen::Matrix3Xd columns(3, m + 2);
    columns.leftCols(unknowns) = solution.transpose();
    if (closed) {
        columns.rightCols<2>() = columns.leftCols<2>().eval();
    }
    return columns;
}

std::array<std::array<Vector3d, 3>, 2> closing_points(const Vector3d& pole, const Vector3d& first,
                                                      const Vector3d& other,
                                                      const std::array<Vector3d, 3>& third) {
    std::array<std::array<Vector3d, 3>, 2> rows;
    // Solves (12), (13), (14), (15), (16) and (17): (18), (19), (20) in row 0 and (21), (22), (23)
    // in row 1, for j = 0, 1, 2.
    for (std::size_t j = 0; j < 3; ++j) {
        const Vector3d tangent = j < 2 ? first : Vector3d(2.0 * other - first);
        rows[0][j] = third[j] - 2.0 * tangent;
        rows[1][j] = (6.0 * pole - 2.0 * third[j] + 2.0 * tangent) / 4.0;
    }
    return rows;
}

Eigen::Matrix3Xd phantom_rows(const Net& net) {
    SUTURE_EXPECTS(net.rows() == 5 && net.first_step() == 1.0 && net.last_step() == 1.0);
    Eigen::Matrix3Xd rows(3, net.points.cols());
    for (int j = 0; j < net.columns(); ++j) {
        const Vector3d pole = net.point(0, j);
        const Vector3d inner = 3.0 * (net.point(1, j) - pole);
        const Vector3d middle = net.point(2, j);
        const Vector3d border = net.point(4, j);
        const Vector3d outer = 3.0 * (border - net.point(3, j));
        rows.col(net.index(0, j)) = middle - 2.0 * inner;
        rows.col(net.index(1, j)) = (6.0 * pole - 2.0 * middle + 2.0 * inner) / 4.0;
        rows.col(net.index(2, j)) = middle;
        rows.col(net.index(3, j)) = (6.0 * border - 2.0 * middle - 2.0 * outer) / 4.0;
        rows.col(net.index(4, j)) = middle + 2.0 * outer;
    }
    return rows;
}

}  // namespace suture::tube

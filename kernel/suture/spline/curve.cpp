#include "suture/spline/curve.h"

#include "suture/base/contract.h"
#include "suture/spline/knots.h"

#include <algorithm>

namespace suture {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The blossom of a Bezier piece by de Casteljau's scheme, each step with an argument of its own.
VectorXd blossom(const BezierPiece& piece, const std::vector<double>& arguments) {
    MatrixXd b = piece.poles;
    for (int r = 1; r <= piece.degree(); ++r) {
        const double s =
            (arguments[static_cast<std::size_t>(r - 1)] - piece.from) / (piece.to - piece.from);
        for (int i = 0; i + r <= piece.degree(); ++i) {
            b.col(i) = (1.0 - s) * b.col(i) + s * b.col(i + 1);
        }
    }
    return b.col(0);
}

/// Every knot once more.
std::vector<double> once_more(const std::vector<double>& knots) {
    std::vector<double> more;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        more.push_back(knots[i]);
        if (i + 1 == knots.size() || knots[i + 1] != knots[i]) {
            more.push_back(knots[i]);
        }
    }
    return more;
}

}  // namespace

MatrixXd evaluate(const SplineCurve& curve, double t, int orders) {
    const int span = find_span(curve.knots, curve.degree, t);
    const MatrixXd basis = basis_derivatives(curve.knots, curve.degree, span, t, orders);
    return curve.poles.middleCols(span - curve.degree, curve.degree + 1) * basis.transpose();
}

VectorXd blossom(const SplineCurve& curve, int span, const std::vector<double>& arguments) {
    const int p = curve.degree;
    MatrixXd b = curve.poles.middleCols(span - p, p + 1);
    for (int r = 1; r <= p; ++r) {
        for (int i = p; i >= r; --i) {
            const double low = curve.knots[static_cast<std::size_t>(span - p + i)];
            const double high = curve.knots[static_cast<std::size_t>(span + 1 + i - r)];
            const double s = (arguments[static_cast<std::size_t>(r - 1)] - low) / (high - low);
            b.col(i) = (1.0 - s) * b.col(i - 1) + s * b.col(i);
        }
    }
    return b.col(p);
}

SplineCurve refined(const SplineCurve& curve, const std::vector<double>& knots) {
    const int p = curve.degree;
    SplineCurve result{p, knots, {}};
    const auto count = static_cast<int>(knots.size()) - p - 1;
    result.poles.resize(curve.poles.rows(), count);
    for (int i = 0; i < count; ++i) {
        const auto first = knots.begin() + i + 1;
        const int span = find_span(curve.knots, p, knots[static_cast<std::size_t>(i)]);
        result.poles.col(i) = blossom(curve, span, {first, first + p});
    }
    return result;
}

SplineCurve with_knots(const SplineCurve& curve, const std::vector<double>& more) {
    std::vector<double> knots = curve.knots;
    knots.insert(knots.end(), more.begin(), more.end());
    std::sort(knots.begin(), knots.end());
    return refined(curve, knots);
}

SplineCurve elevated(const SplineCurve& curve, int degree) {
    SplineCurve result = curve;
    while (result.degree < degree) {
        const int p = result.degree;
        SplineCurve next{p + 1, once_more(result.knots), {}};
        const auto count = static_cast<int>(next.knots.size()) - p - 2;
        next.poles = MatrixXd::Zero(curve.poles.rows(), count);
        for (int i = 0; i < count; ++i) {
            // The blossom of one degree more: the mean over all ways to leave one argument out.
            const double at = next.knots[static_cast<std::size_t>(i)];
            const int span = find_span(result.knots, p, at);
            for (int out = 0; out <= p; ++out) {
                std::vector<double> arguments(next.knots.begin() + i + 1,
                                              next.knots.begin() + i + 2 + p);
                arguments.erase(arguments.begin() + out);
                next.poles.col(i) += blossom(result, span, arguments) / (p + 1);
            }
        }
        result = std::move(next);
    }
    return result;
}

std::vector<double> greville(const SplineCurve& curve) {
    std::vector<double> nodes;
    for (int i = 0; i < curve.count(); ++i) {
        double sum = 0.0;
        for (int k = 1; k <= curve.degree; ++k) {
            sum += curve.knots[static_cast<std::size_t>(i + k)];
        }
        nodes.push_back(sum / curve.degree);
    }
    return nodes;
}

std::vector<BezierPiece> bezier_pieces(const SplineCurve& curve) {
    const int p = curve.degree;
    std::vector<BezierPiece> pieces;
    for (int span = p; span < curve.count(); ++span) {
        const double a = curve.knots[static_cast<std::size_t>(span)];
        const double b = curve.knots[static_cast<std::size_t>(span + 1)];
        if (!(a < b)) {
            continue;
        }
        BezierPiece piece{a, b, MatrixXd(curve.poles.rows(), p + 1)};
        for (int k = 0; k <= p; ++k) {
            std::vector<double> arguments(static_cast<std::size_t>(p - k), a);
            arguments.resize(static_cast<std::size_t>(p), b);
            piece.poles.col(k) = blossom(curve, span, arguments);
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

BezierPiece part_of(const BezierPiece& piece, double from, double to) {
    if (from == piece.from && to == piece.to) {
        return piece;
    }
    const int p = piece.degree();
    BezierPiece part{from, to, MatrixXd(piece.poles.rows(), p + 1)};
    for (int k = 0; k <= p; ++k) {
        std::vector<double> arguments(static_cast<std::size_t>(p - k), from);
        arguments.resize(static_cast<std::size_t>(p), to);
        part.poles.col(k) = blossom(piece, arguments);
    }
    return part;
}

SplineCurve joined(const std::vector<BezierPiece>& pieces) {
    SUTURE_EXPECTS(!pieces.empty());
    const int p = pieces.front().degree();
    SplineCurve curve{p, {}, {}};
    curve.poles.resize(pieces.front().poles.rows(), static_cast<int>(pieces.size()) * p + 1);
    curve.knots.assign(static_cast<std::size_t>(p + 1), pieces.front().from);
    int at = 0;
    for (const BezierPiece& piece : pieces) {
        curve.poles.middleCols(at, p + 1) = piece.poles;
        at += p;
        curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(p), piece.to);
    }
    curve.knots.push_back(pieces.back().to);
    return curve;
}

}  // namespace suture

#include "suture/fill/manifold/border_samples.h"

#include <algorithm>

namespace suture::manifold {
namespace {

/// Samples of the border a knot interval.
constexpr int kSamples = 4;

/// The parameter s at which a piece has come to a share of its length.
double at_share(const Piece& piece, double share) {
    double low = 0.0;
    double high = 1.0;
    constexpr int kHalvings = 50;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (low + high);
        (piece.along(middle) < share ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The knots of a side within a piece, as shares of the piece's length from 0 to 1.
std::vector<double> knots_on(const BorderModel& model, int side, const Piece& piece) {
    const auto m = static_cast<std::size_t>(side);
    const double from = model.y_at(side, piece.from);
    const double to = model.y_at(side, piece.to);
    std::vector<double> shares = {0.0};
    for (const double y : model.knots[m]) {
        const double share = (y - from) / (to - from);
        constexpr double kSame = 1e-6;
        if (share > shares.back() + kSame && share < 1.0 - kSame) {
            shares.push_back(share);
        }
    }
    shares.push_back(1.0);
    return shares;
}

}  // namespace

double BorderModel::y_at(int side, double share) const {
    const auto m = static_cast<std::size_t>(side);
    const double c = centres.empty() ? 0.0 : centres[m];
    const double t = 2.0 * share - 1.0;
    const double moved = t - c * (1.0 - t * t) / (1.0 - c * c);
    return knots[m].front() + (knots[m].back() - knots[m].front()) * 0.5 * (1.0 + moved);
}

double BorderModel::y_of(int side, const Piece& piece, double s) const {
    return y_at(side, piece.from + (piece.to - piece.from) * piece.along(s));
}

Eigen::Matrix3Xd derivatives(const Sample& sample, const Eigen::Matrix3Xd& points) {
    Eigen::Matrix3Xd own(3, static_cast<Eigen::Index>(sample.row.points.size()));
    for (std::size_t k = 0; k < sample.row.points.size(); ++k) {
        own.col(static_cast<Eigen::Index>(k)) = points.col(sample.row.points[k]);
    }
    return own * sample.row.weights.transpose();
}

std::vector<Sample> samples_of(const BorderModel& model, const Hole& hole, const Sides& sides,
                               double offset) {
    std::vector<Sample> samples;
    for (std::size_t m = 0; m < sides.sides.size(); ++m) {
        const auto side = static_cast<int>(m);
        for (const Piece& piece : sides.sides[m].pieces) {
            const Ribbon& ribbon =
                hole.loops.front().ribbons[static_cast<std::size_t>(piece.ribbon)];
            const std::vector<double> shares = knots_on(model, side, piece);
            for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
                const int last = i + 2 < shares.size() ? kSamples - 1 : kSamples;
                for (int q = 0; q <= last; ++q) {
                    const double within = std::min(1.0, (q + offset) / kSamples);
                    const double share = shares[i] + within * (shares[i + 1] - shares[i]);
                    const double s = at_share(piece, share);
                    Sample sample;
                    sample.row = model.row(side, model.y_of(side, piece, s));
                    sample.ribbon = &ribbon;
                    sample.side = m;
                    sample.share = piece.from + (piece.to - piece.from) * piece.along(s);
                    sample.wanted = ribbon.at(s);
                    sample.wanted.point = piece.meeting_point(sample.wanted.point, s);
                    samples.push_back(std::move(sample));
                }
            }
        }
    }
    for (Sample& sample : samples) {
        sample.weight = 1.0 / static_cast<double>(samples.size());
    }
    return samples;
}

}  // namespace suture::manifold

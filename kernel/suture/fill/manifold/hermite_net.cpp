#include "suture/fill/manifold/hermite_net.h"

namespace suture::manifold {
namespace {

constexpr int kDegree = 5;

/// A pole as a blossom about a node: three or more of its arguments are the node, two lie s and t
/// away, so that it is f + f' (s + t) / 5 + f'' s t / 20 there.
struct PoleRule {
    int node = 0;
    int side = 0;
    std::array<double, 3> weights{};
};

PoleRule rule(int node, int side, double s, double t) {
    return {node, side, {1.0, (s + t) / kDegree, s * t / (kDegree * (kDegree - 1.0))}};
}

std::vector<PoleRule> rules_for(const std::vector<double>& breaks, int smoothness) {
    std::vector<PoleRule> rules;
    const int last = static_cast<int>(breaks.size()) - 1;
    for (int i = 0; i <= last; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double before = i > 0 ? breaks[k - 1] - breaks[k] : 0.0;
        const double after = i < last ? breaks[k + 1] - breaks[k] : 0.0;
        if (i > 0) {
            rules.push_back(rule(i, -1, before, before));
        }
        if (i == last) {
            rules.push_back(rule(i, -1, before, 0.0));
            rules.push_back(rule(i, -1, 0.0, 0.0));
            break;
        }
        if (i == 0) {
            rules.push_back(rule(i, 1, 0.0, 0.0));
            rules.push_back(rule(i, 1, 0.0, after));
        } else if (smoothness == 2) {
            rules.push_back(rule(i, -1, before, after));
        } else {
            rules.push_back(rule(i, -1, before, 0.0));
            if (smoothness == 0) {
                rules.push_back(rule(i, -1, 0.0, 0.0));
            }
            rules.push_back(rule(i, 1, 0.0, after));
        }
        rules.push_back(rule(i, 1, after, after));
    }
    return rules;
}

}  // namespace

HermiteNet::HermiteNet(std::vector<double> breaks, int smoothness)
    : breaks_(std::move(breaks)),
      smoothness_(smoothness),
      jets_(4 * breaks_.size() * breaks_.size()) {}

SplineSurface HermiteNet::spline() const {
    SplineSurface spline;
    spline.degree_u = spline.degree_v = kDegree;
    for (int i = 0; i < nodes(); ++i) {
        const bool end = i == 0 || i == nodes() - 1;
        spline.knots_u.insert(spline.knots_u.end(),
                              static_cast<std::size_t>(end ? kDegree + 1 : kDegree - smoothness_),
                              at(i));
    }
    spline.knots_v = spline.knots_u;
    const std::vector<PoleRule> rules = rules_for(breaks_, smoothness_);
    spline.poles.resize(3, static_cast<Eigen::Index>(rules.size() * rules.size()));
    Eigen::Index next = 0;
    for (const PoleRule& v : rules) {
        for (const PoleRule& u : rules) {
            const NodeJet& jet = jets_[slot(u.node, v.node, u.side, v.side)];
            Eigen::Vector3d pole = Eigen::Vector3d::Zero();
            for (std::size_t a = 0; a < 3; ++a) {
                for (std::size_t b = 0; b < 3; ++b) {
                    pole += u.weights[a] * v.weights[b] * jet[a][b];
                }
            }
            spline.poles.col(next++) = pole;
        }
    }
    return spline;
}

}  // namespace suture::manifold

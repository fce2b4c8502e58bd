#include "suture/fill/mvs/shared_lines.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suture::mvs {
namespace {

using Groups = std::vector<std::vector<std::size_t>>;

// How much a side's ends may move against each other, as part of its length.
constexpr double kStretch = 0.15;
// Of a corner by itself, and of being in line, against that.
constexpr double kStay = 1e-2;
constexpr double kInLine = 1e8;
// Points a side for the box.
constexpr int kBoxPoints = 48;

// The corners' least moves along one axis that bring each group in line: least squares of the
// moves of sides' ends against each other, in parts of their lengths.
Eigen::VectorXd moves_of(const Groups& groups, const Eigen::VectorXd& at,
                         const Eigen::VectorXd& lengths) {
    const Eigen::Index n = at.size();
    Eigen::MatrixXd matrix = kStay * Eigen::MatrixXd::Identity(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    const auto tie = [&](Eigen::Index i, Eigen::Index j, double weight, double apart) {
        matrix(i, i) += weight;
        matrix(j, j) += weight;
        matrix(i, j) -= weight;
        matrix(j, i) -= weight;
        right[i] += weight * apart;
        right[j] -= weight * apart;
    };
    for (Eigen::Index i = 0; i < n; ++i) {
        tie(i, (i + 1) % n, 1.0 / (lengths[i] * lengths[i]), 0.0);
    }
    for (const std::vector<std::size_t>& group : groups) {
        for (std::size_t k = 1; k < group.size(); ++k) {
            const auto i = static_cast<Eigen::Index>(group[k - 1]);
            const auto j = static_cast<Eigen::Index>(group[k]);
            tie(i, j, kInLine, at[j] - at[i]);
        }
    }
    return matrix.ldlt().solve(right);
}

bool bearable(const Eigen::VectorXd& moves, const Eigen::VectorXd& lengths) {
    const Eigen::Index n = moves.size();
    for (Eigen::Index i = 0; i < n; ++i) {
        if (std::abs(moves[(i + 1) % n] - moves[i]) > kStretch * lengths[i]) {
            return false;
        }
    }
    return true;
}

// A line through both ends of a side would run along it.
bool hold_a_side(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b,
                 std::size_t sides) {
    return std::ranges::any_of(a, [&](std::size_t i) {
        return std::ranges::any_of(
            b, [&](std::size_t j) { return (i + 1) % sides == j || (j + 1) % sides == i; });
    });
}

double middle_of(const std::vector<std::size_t>& group, const Eigen::VectorXd& at) {
    double sum = 0.0;
    for (const std::size_t i : group) {
        sum += at[static_cast<Eigen::Index>(i)];
    }
    return sum / static_cast<double>(group.size());
}

// Joins groups, the nearest first, as long as that is bearable.
Groups join(Groups groups, const Eigen::VectorXd& at, const Eigen::VectorXd& lengths) {
    const auto sides = static_cast<std::size_t>(at.size());
    struct Pair {
        std::size_t a, b;
        double distance;
    };
    for (bool joined = true; joined;) {
        joined = false;
        std::vector<Pair> pairs;
        for (std::size_t a = 0; a < groups.size(); ++a) {
            for (std::size_t b = a + 1; b < groups.size(); ++b) {
                pairs.push_back(
                    {a, b, std::abs(middle_of(groups[a], at) - middle_of(groups[b], at))});
            }
        }
        std::ranges::stable_sort(pairs, {}, &Pair::distance);
        for (const Pair& pair : pairs) {
            if (pair.distance > kSameLine && hold_a_side(groups[pair.a], groups[pair.b], sides)) {
                continue;
            }
            Groups tried = groups;
            tried[pair.a].insert(tried[pair.a].end(), tried[pair.b].begin(), tried[pair.b].end());
            tried.erase(tried.begin() + static_cast<std::ptrdiff_t>(pair.b));
            if (bearable(moves_of(tried, at, lengths), lengths)) {
                groups = std::move(tried);
                joined = true;
                break;
            }
        }
    }
    return groups;
}

}  // namespace

std::array<Groups, 2> share_lines(const std::array<std::vector<std::size_t>, 2>& through,
                                  const Scale& scale, Layout& layout) {
    const auto n = static_cast<Eigen::Index>(layout.curves.size());
    Eigen::VectorXd lengths(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        lengths[i] = layout.lengths[static_cast<std::size_t>(i)] / scale.length;
    }
    std::array<Groups, 2> groups;
    Eigen::MatrixX2d moves(n, 2);
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        Eigen::VectorXd at(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            at[i] = layout.curves[static_cast<std::size_t>(i)].at(0.0)[axis] / scale.length;
        }
        for (const std::size_t i : through[a]) {
            groups[a].push_back({i});
        }
        groups[a] = join(std::move(groups[a]), at, lengths);
        moves.col(axis) = scale.length * moves_of(groups[a], at, lengths);
    }
    Eigen::AlignedBox2d box;
    for (Eigen::Index i = 0; i < n; ++i) {
        DomainCurve& curve = layout.curves[static_cast<std::size_t>(i)];
        curve = curve.with_ends_moved(moves.row(i), moves.row((i + 1) % n));
        for (int k = 0; k <= kBoxPoints; ++k) {
            box.extend(curve.at(static_cast<double>(k) / kBoxPoints));
        }
    }
    layout.lower = box.min();
    layout.upper = box.max();
    return groups;
}

}  // namespace suture::mvs

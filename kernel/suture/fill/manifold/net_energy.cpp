#include "suture/fill/manifold/net_energy.h"

#include <vector>

namespace suture::manifold {
namespace {

/// Differences of some order along one direction: alternating binomial coefficients.
const std::vector<double>& differences(int order) {
    static const std::vector<std::vector<double>> kRows = {
        {1.0}, {-1.0, 1.0}, {1.0, -2.0, 1.0}, {-1.0, 3.0, -3.0, 1.0}};
    return kRows[static_cast<std::size_t>(order)];
}

}  // namespace

// NOLINTNEXTLINE(readability-function-cognitive-complexity)
Eigen::SparseMatrix<double> net_energy(const Star& star, double flat) {
    struct Term {
        int i, j;
        double weight;
    };
    const Term terms[] = {{3, 0, 1.0},  {2, 1, 3.0},        {1, 2, 3.0}, {0, 3, 1.0},
                          {2, 0, flat}, {1, 1, 2.0 * flat}, {0, 2, flat}};
    std::vector<Eigen::Triplet<double>> entries;
    for (int m = 0; m < star.n(); ++m) {
        for (const Term& term : terms) {
            const std::vector<double>& across = differences(term.i);
            const std::vector<double>& along = differences(term.j);
            for (int j = 0; j + term.j < star.charts_y(m); ++j) {
                for (int i = 0; i + term.i < star.charts_x(); ++i) {
                    std::vector<std::pair<int, double>> row;
                    for (int b = 0; b <= term.j; ++b) {
                        for (int a = 0; a <= term.i; ++a) {
                            row.emplace_back(star.point_of(m, i + a, j + b),
                                             across[static_cast<std::size_t>(a)] *
                                                 along[static_cast<std::size_t>(b)]);
                        }
                    }
                    for (const auto& [p, x] : row) {
                        for (const auto& [q, y] : row) {
                            entries.emplace_back(p, q, term.weight * x * y);
                        }
                    }
                }
            }
        }
    }
    Eigen::SparseMatrix<double> form(star.count(), star.count());
    form.setFromTriplets(entries.begin(), entries.end());
    return form;
}

}  // namespace suture::manifold

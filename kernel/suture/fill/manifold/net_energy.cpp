#include "suture/fill/manifold/net_energy.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace suture::manifold {
namespace {

/// Where a control point has its place along one direction: the mean of its inner knots.
std::vector<double> greville_of(const std::vector<double>& knots, int degree, int count) {
    std::vector<double> places;
    for (int i = 0; i < count; ++i) {
        double sum = 0.0;
        for (int a = 1; a <= degree; ++a) {
            sum += knots[static_cast<std::size_t>(i + a)];
        }
        places.push_back(sum / degree);
    }
    return places;
}

/// The derivative of some order by neighbouring control points: divided differences, on evenly
/// spaced knots plain ones.
struct Difference {
    std::vector<double> weights;
    double spacing = 1.0;  ///< of these control points
};

std::vector<Difference> differences(const std::vector<double>& places, int order) {
    std::vector<Difference> result;
    const auto wide = static_cast<std::size_t>(order);
    for (std::size_t i = 0; i + wide < places.size(); ++i) {
        Difference& difference = result.emplace_back();
        for (std::size_t a = i; a <= i + wide; ++a) {
            double weight = 1.0;
            for (std::size_t b = i; b <= i + wide; ++b) {
                weight *= b == a ? 1.0 : 1.0 / (places[a] - places[b]);
            }
            for (int c = 2; c <= order; ++c) {
                weight *= c;
            }
            difference.weights.push_back(weight);
        }
        const std::size_t last = std::min(i + std::max<std::size_t>(wide, 1), places.size() - 1);
        difference.spacing =
            (places[last] - places[i]) / std::max(1.0, static_cast<double>(last - i));
    }
    return result;
}

}  // namespace

// NOLINTNEXTLINE(readability-function-cognitive-complexity)
Eigen::SparseMatrix<double> net_energy(const Star& star, const NetWeights& weights) {
    struct Term {
        int i, j;
        double weight;
    };
    const auto& [variation, plate, membrane] = weights;
    const Term all[] = {{3, 0, variation}, {2, 1, 3.0 * variation}, {1, 2, 3.0 * variation},
                        {0, 3, variation}, {2, 0, plate},           {1, 1, 2.0 * plate},
                        {0, 2, plate},     {1, 0, membrane},        {0, 1, membrane}};
    std::vector<Term> terms;
    std::copy_if(std::begin(all), std::end(all), std::back_inserter(terms),
                 [](const Term& term) { return term.weight > 0.0; });
    std::vector<Eigen::Triplet<double>> entries;
    for (int m = 0; m < star.n(); ++m) {
        const auto places_x = greville_of(star.knots_x(m), star.degree(), star.charts_x());
        const auto places_y = greville_of(star.knots_y(m), star.degree(), star.charts_y(m));
        for (const Term& term : terms) {
            const std::vector<Difference> across = differences(places_x, term.i);
            const std::vector<Difference> along = differences(places_y, term.j);
            for (std::size_t j = 0; j < along.size(); ++j) {
                for (std::size_t i = 0; i < across.size(); ++i) {
                    std::vector<std::pair<int, double>> row;
                    for (int b = 0; b <= term.j; ++b) {
                        for (int a = 0; a <= term.i; ++a) {
                            row.emplace_back(
                                star.point_of(m, static_cast<int>(i) + a, static_cast<int>(j) + b),
                                across[i].weights[static_cast<std::size_t>(a)] *
                                    along[j].weights[static_cast<std::size_t>(b)]);
                        }
                    }
                    const double weight = term.weight * across[i].spacing * along[j].spacing;
                    for (const auto& [p, x] : row) {
                        for (const auto& [q, y] : row) {
                            entries.emplace_back(p, q, weight * x * y);
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

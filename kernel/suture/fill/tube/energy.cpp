#include "suture/fill/tube/fairing.h"

#include <vector>

namespace suture::tube {
namespace {

/// weight |d^(a+b) r / du^a dv^b|^2
struct Term {
    int a, b;
    double weight;
};

std::vector<Term> terms_of(Functional functional) {
    // F1 is (24), F2 (25), F3 (26).
    std::vector<Term> terms = {{2, 0, 1.0}, {1, 1, 2.0}, {0, 2, 1.0}};
    if (functional == Functional::F2) {
        terms.push_back({1, 0, 1.0});
        terms.push_back({0, 1, 1.0});
    } else if (functional == Functional::F3) {
        terms.push_back({3, 0, 1.0});
    }
    return terms;
}

}  // namespace

RealSparse energy_matrix(const Net& net, Functional functional) {
    const int rows = net.rows();
    std::vector<Eigen::Triplet<Real>> entries;
    for (const Term& term : terms_of(functional)) {
        const RealMatrix across = cubic_gram(net.knots_u, term.a);
        const RealSparse around = net.ring.gram(term.b);
        for (int j = 0; j < around.outerSize(); ++j) {
            for (RealSparse::InnerIterator it(around, j); it; ++it) {
                for (int r = 0; r < rows; ++r) {
                    for (int c = std::max(0, r - kDegreeU); c <= std::min(rows - 1, r + kDegreeU);
                         ++c) {
                        entries.emplace_back(
                            r + rows * static_cast<int>(it.row()),
                            c + rows * static_cast<int>(it.col()),
                            static_cast<Real>(term.weight) * across(r, c) * it.value());
                    }
                }
            }
        }
    }
    RealSparse matrix(net.points.cols(), net.points.cols());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

double energy(const Net& net, const RealSparse& matrix) {
    const RealMatrix points = net.points.cast<Real>();
    return static_cast<double>((points * matrix * points.transpose()).trace());
}

}  // namespace suture::tube

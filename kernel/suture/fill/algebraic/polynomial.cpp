#include "suture/fill/algebraic/polynomial.h"

namespace suture::algebraic {

std::vector<Monomial> monomials(int degree) {
    std::vector<Monomial> all;
    all.reserve(static_cast<std::size_t>(monomial_count(degree)));
    for (int d = 0; d <= degree; ++d) {
        for (int rest = 0; rest <= d; ++rest) {
            for (int k = 0; k <= rest; ++k) {
                all.push_back({d - rest, rest - k, k});
            }
        }
    }
    return all;
}

}  // namespace suture::algebraic

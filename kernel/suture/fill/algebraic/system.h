#pragma once

#include "suture/fill/algebraic/partition.h"
#include "suture/fill/algebraic/polynomial.h"

#include <cstddef>
#include <vector>

namespace suture::algebraic {

/// A side of the hole: the neighbour f = 0, cut by the plane F = 0, met with G^k.
template <class T>
struct Side {
    Polynomial<T> f;
    Polynomial<T> F;
    int k = 1;
};

/// All G^k conditions of a piecewise algebraic surface of one degree, as a linear system
///   matrix x = 0 for x = (gamma_0, beta_0, gamma_1, ..., alpha_0, alpha_1, ...),
/// and the polynomials g = image x that a solution stands for, cell after cell.
///
/// Source  Chen, Chen, Deng, Feng 2000, section 3.2: g = gamma f + beta F^(k+1) at a side
///         (Corollary 2.3; for three sides the system is (4)),
///         g_b = g_a + alpha pi^(k+1) at an interface.
template <class T>
struct System {
    int degree = 0;
    int rows = 0, columns = 0, image_rows = 0;
    std::vector<T> matrix;  ///< column after column
    std::vector<T> image;   ///< column after column

    [[nodiscard]] const T& at(int row, int column) const {
        return matrix[static_cast<std::size_t>(column) * static_cast<std::size_t>(rows) +
                      static_cast<std::size_t>(row)];
    }
    [[nodiscard]] const T& image_at(int row, int column) const {
        return image[static_cast<std::size_t>(column) * static_cast<std::size_t>(image_rows) +
                     static_cast<std::size_t>(row)];
    }
};

/// How each cell is reached from cell 0, and which interfaces close a cycle.
struct Paths {
    struct Step {
        int interface = 0;
        int sign = 1;
    };
    std::vector<std::vector<Step>> to;  ///< for each cell
    std::vector<int> closing;           ///< interfaces that are on no path
};
[[nodiscard]] Paths paths_of(const Partition& partition);

namespace detail {

/// Fills the columns of a System one after the other.
template <class T>
class SystemBuilder {
  public:
    SystemBuilder(const Partition& partition, const std::vector<Side<T>>& sides,
                  const std::vector<Polynomial<T>>& planes, int interface_k, int degree)
        : partition_(partition), paths_(paths_of(partition)), block_(monomial_count(degree)) {
        system_.degree = degree;
        system_.rows = block_ * (partition.sides - 1 + static_cast<int>(paths_.closing.size()));
        system_.image_rows = block_ * partition.cells;
        for (int i = 0; i < partition.sides; ++i) {
            const Side<T>& side = sides[static_cast<std::size_t>(i)];
            add_side(i, side.f);
            add_side(i, power(side.F, side.k + 1));
        }
        for (int j = 0; j < static_cast<int>(partition.interfaces.size()); ++j) {
            add_interface(j, power(planes[static_cast<std::size_t>(j)], interface_k + 1));
        }
    }
    System<T> take() { return std::move(system_); }

  private:
    const Partition& partition_;
    Paths paths_;
    int block_;
    System<T> system_;

    /// Calls column(m f) for each monomial m that keeps the degree, with room for its entries.
    template <class Column>
    void multiples(const Polynomial<T>& f, const Column& column) {
        for (const Monomial& m : monomials(system_.degree - f.degree)) {
            auto monomial = Polynomial<T>::zero(m.degree());
            monomial[m] = T(1);
            const Polynomial<T> product = monomial * f;
            system_.matrix.resize(system_.matrix.size() + static_cast<std::size_t>(system_.rows),
                                  T(0));
            system_.image.resize(
                system_.image.size() + static_cast<std::size_t>(system_.image_rows), T(0));
            ++system_.columns;
            column(product);
        }
    }
    void put(std::vector<T>& to, int rows, int block, int sign, const Polynomial<T>& p) {
        const std::size_t start =
            to.size() - static_cast<std::size_t>(rows) +
            static_cast<std::size_t>(block) * static_cast<std::size_t>(block_);
        for (std::size_t n = 0; n < p.coefficients.size(); ++n) {
            to[start + n] += T(sign) * p.coefficients[n];
        }
    }
    void put_condition(int number, int sign, const Polynomial<T>& p) {
        put(system_.matrix, system_.rows, number, sign, p);
    }
    void put_image(int cell, int sign, const Polynomial<T>& p) {
        put(system_.image, system_.image_rows, cell, sign, p);
    }

    void add_side(int i, const Polynomial<T>& f) {
        multiples(f, [&](const Polynomial<T>& p) {
            if (i > 0) {
                put_condition(i - 1, -1, p);
                return;
            }
            for (int other = 1; other < partition_.sides; ++other) {
                put_condition(other - 1, 1, p);
            }
            for (int cell = 0; cell < partition_.cells; ++cell) {
                put_image(cell, 1, p);
            }
        });
    }

    void add_interface(int j, const Polynomial<T>& plane) {
        multiples(plane, [&](const Polynomial<T>& p) {
            for (int cell = 0; cell < partition_.cells; ++cell) {
                const int sign = sign_on_path(cell, j);
                if (sign != 0) {
                    put_image(cell, sign, p);
                }
                if (sign != 0 && cell > 0 && cell < partition_.sides) {
                    put_condition(cell - 1, sign, p);
                }
            }
            // g_a + alpha pi^(k+1) = g_b for the interfaces that close a cycle.
            int condition = partition_.sides - 1;
            for (const int c : paths_.closing) {
                const Interface& closing = partition_.interfaces[static_cast<std::size_t>(c)];
                const int sign =
                    (c == j ? 1 : 0) + sign_on_path(closing.a, j) - sign_on_path(closing.b, j);
                if (sign != 0) {
                    put_condition(condition, sign, p);
                }
                ++condition;
            }
        });
    }

    [[nodiscard]] int sign_on_path(int cell, int j) const {
        for (const Paths::Step& step : paths_.to[static_cast<std::size_t>(cell)]) {
            if (step.interface == j) {
                return step.sign;
            }
        }
        return 0;
    }
};

}  // namespace detail

/// Input   planes: of the interfaces; interface_k: how smoothly cells meet; degree: of all cells,
///         at least that of every f.
template <class T>
System<T> make_system(const Partition& partition, const std::vector<Side<T>>& sides,
                      const std::vector<Polynomial<T>>& planes, int interface_k, int degree) {
    return detail::SystemBuilder<T>(partition, sides, planes, interface_k, degree).take();
}

/// The polynomials of all cells from their coefficients, cell after cell.
template <class T>
std::vector<Polynomial<T>> split_cells(const std::vector<T>& coefficients, int degree) {
    const auto block = static_cast<std::size_t>(monomial_count(degree));
    std::vector<Polynomial<T>> cells;
    for (std::size_t start = 0; start < coefficients.size(); start += block) {
        Polynomial<T> cell;
        cell.degree = degree;
        const auto first = coefficients.begin() + static_cast<std::ptrdiff_t>(start);
        cell.coefficients.assign(first, first + static_cast<std::ptrdiff_t>(block));
        cells.push_back(std::move(cell));
    }
    return cells;
}

}  // namespace suture::algebraic

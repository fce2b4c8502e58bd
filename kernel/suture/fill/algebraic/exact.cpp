#include "suture/fill/algebraic/exact.h"

#include <algorithm>
#include <utility>

namespace suture::algebraic {
namespace {

using Row = std::vector<Rational>;

/// Reduced row echelon form in place, without its empty rows; the pivots' columns.
std::vector<int> reduce(std::vector<Row>& rows) {
    std::vector<int> pivots;
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    std::size_t done = 0;
    for (std::size_t c = 0; c < columns && done < rows.size(); ++c) {
        const auto found = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(done),
                                        rows.end(), [&](const Row& row) { return row[c] != 0; });
        if (found == rows.end()) {
            continue;
        }
        std::swap(rows[done], *found);
        Row& pivot = rows[done];
        const Rational scale = 1 / pivot[c];
        for (std::size_t d = c; d < columns; ++d) {
            if (pivot[d] != 0) {
                pivot[d] *= scale;
            }
        }
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const Rational factor = rows[r][c];
            if (r == done || factor == 0) {
                continue;
            }
            for (std::size_t d = c; d < columns; ++d) {
                if (pivot[d] != 0) {
                    rows[r][d] -= factor * pivot[d];
                }
            }
        }
        pivots.push_back(static_cast<int>(c));
        ++done;
    }
    rows.resize(done);
    return pivots;
}

std::vector<Row> rows_of(const System<Rational>& system) {
    std::vector<Row> rows(static_cast<std::size_t>(system.rows));
    for (int r = 0; r < system.rows; ++r) {
        Row& row = rows[static_cast<std::size_t>(r)];
        for (int c = 0; c < system.columns; ++c) {
            row.push_back(system.at(r, c));
        }
    }
    return rows;
}

/// image x
Row image_of(const System<Rational>& system, const Row& x) {
    Row g(static_cast<std::size_t>(system.image_rows), Rational(0));
    for (int c = 0; c < system.columns; ++c) {
        const Rational& factor = x[static_cast<std::size_t>(c)];
        for (int r = 0; factor != 0 && r < system.image_rows; ++r) {
            if (system.image_at(r, c) != 0) {
                g[static_cast<std::size_t>(r)] += factor * system.image_at(r, c);
            }
        }
    }
    return g;
}

}  // namespace

int exact_rank(const System<Rational>& system) {
    std::vector<Row> rows = rows_of(system);
    return static_cast<int>(reduce(rows).size());
}

ExactSpace solve_exactly(const System<Rational>& system) {
    std::vector<Row> rows = rows_of(system);
    const std::vector<int> pivots = reduce(rows);
    ExactSpace space;
    space.rank = static_cast<int>(pivots.size());
    space.dimension = system.columns - space.rank;
    for (int free = 0; free < system.columns; ++free) {
        if (std::binary_search(pivots.begin(), pivots.end(), free)) {
            continue;
        }
        Row x(static_cast<std::size_t>(system.columns), Rational(0));
        x[static_cast<std::size_t>(free)] = 1;
        for (std::size_t r = 0; r < pivots.size(); ++r) {
            x[static_cast<std::size_t>(pivots[r])] = -rows[r][static_cast<std::size_t>(free)];
        }
        space.basis.push_back(image_of(system, x));
    }
    space.pivots = reduce(space.basis);
    return space;
}

}  // namespace suture::algebraic

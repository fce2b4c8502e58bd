#include "suture/fill/algebraic/partition.h"

#include "suture/base/contract.h"

namespace suture::algebraic {

/// The cells of (4), for any number of sides.
Partition umbrella(int sides) {
    SUTURE_EXPECTS(sides >= 3);
    Partition result;
    result.sides = result.cells = sides;
    result.rays = sides + 1;
    for (int i = 0; i < sides; ++i) {
        const int next = (i + 1) % sides;
        result.sectors.push_back({{i, next, sides}, i, i});
        result.interfaces.push_back({i, next, next, sides});
    }
    return result;
}

/// The cells between the planes of (5), for any number of sides.
Partition with_inner_cells(int sides) {
    SUTURE_EXPECTS(sides >= 3);
    Partition result;
    result.sides = sides;
    result.rays = 2 * sides;
    result.cells = 2 * sides + 1;
    const int middle = 2 * sides;
    for (int i = 0; i < sides; ++i) {
        result.sectors.push_back({{i, (i + 1) % sides, sides + i}, i, i});
    }
    for (int i = 0; i < sides; ++i) {
        // Corner i lies between the inner rays of the sides before and after it.
        const int before = (i + sides - 1) % sides;
        const int cell = sides + i;
        result.sectors.push_back({{i, sides + i, sides + before}, cell, -1});
        result.interfaces.push_back({before, cell, i, sides + before});
        result.interfaces.push_back({i, cell, i, sides + i});
        result.interfaces.push_back({cell, middle, sides + before, sides + i});
    }
    for (int i = 1; i + 1 < sides; ++i) {
        result.sectors.push_back({{sides, sides + i, sides + i + 1}, middle, -1});
    }
    return result;
}

}  // namespace suture::algebraic

#pragma once

#include "suture/fill/algebraic/polynomial.h"

#include <array>
#include <vector>

namespace suture::algebraic {

template <class T>
using Point = std::array<T, 3>;

/// The two cells on the sides of a plane, g[b] = g[a] + alpha plane^(k+1); the plane goes through
/// the centre and two of the rays.
struct Interface {
    int a = 0, b = 0;
    int from = 0, to = 0;  ///< the rays
};

/// A cone over a triangle of rays, seen counterclockwise from outside; part of a cell.
struct Sector {
    std::array<int, 3> rays = {0, 0, 0};
    int cell = 0;
    int side = -1;  ///< rays 0 and 1 are the corners of this side of the hole
};

/// How space around the centre is divided; one polynomial for each cell. Ray i < sides is that
/// through corner i, where side i begins.
struct Partition {
    int sides = 0;
    int rays = 0;
    int cells = 0;
    std::vector<Sector> sectors;  ///< side i lies in sector i, whose cell is i
    std::vector<Interface> interfaces;
};

/// n cells around an axis, one for each side; ray n is the axis.
///
/// Source  Chen, Chen, Deng, Feng 2000, section 4.2 (figure 1), for any n >= 3.
[[nodiscard]] Partition umbrella(int sides);

/// A cell for each side, one for each corner, and one in the middle; ray n + i is the inner one
/// opposite side i.
///
/// Source  section 4.3 (figure 3, right), for any n >= 3.
[[nodiscard]] Partition with_inner_cells(int sides);

/// How far the inner rays lie from the outer point, on the way to the middle of their side: the
/// paper's choice.
inline constexpr int kInnerShare = 4;

/// Where the rays pass: the corners, then what the partition adds.
///
/// Input   outer: the point that the axis, or the middle of the inner cells, goes through.
template <class T>
std::vector<Point<T>> ray_points(const Partition& partition, const std::vector<Point<T>>& corners,
                                 const Point<T>& outer) {
    std::vector<Point<T>> points = corners;
    const std::size_t n = corners.size();
    if (partition.rays == partition.sides + 1) {
        points.push_back(outer);
        return points;
    }
    for (std::size_t i = 0; i < n; ++i) {
        Point<T> inner = outer;
        for (std::size_t c = 0; c < 3; ++c) {
            const T middle = (corners[i][c] + corners[(i + 1) % n][c]) / T(2);
            inner[c] += (middle - outer[c]) / T(kInnerShare);
        }
        points.push_back(inner);
    }
    return points;
}

/// The plane through three points, as a linear polynomial.
template <class T>
Polynomial<T> plane_through(const Point<T>& o, const Point<T>& p, const Point<T>& q) {
    const Point<T> a = {p[0] - o[0], p[1] - o[1], p[2] - o[2]};
    const Point<T> b = {q[0] - o[0], q[1] - o[1], q[2] - o[2]};
    const Point<T> n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                        a[0] * b[1] - a[1] * b[0]};
    return Polynomial<T>::linear(n, -(n[0] * o[0] + n[1] * o[1] + n[2] * o[2]));
}

}  // namespace suture::algebraic

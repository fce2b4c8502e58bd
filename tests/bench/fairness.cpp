#include "bench/fairness.h"

#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace suture::bench {
namespace {

constexpr double kSmallestSine = 1e-9;  // of the angle between the derivatives: else a pole
constexpr double kCountedGauss = 0.01;  // against half of the mean of k1^2 + k2^2
constexpr double kFlatBending = 1e-6;   // k1^2 + k2^2 times the area: below, a face is flat
constexpr double kCountedCells = 1e-3;  // of all that lie in the face
constexpr double kWholePeriod = 1e-6;   // what may be missing of it
constexpr std::array<int, 2> kBoth = {0, 1};

/// What a surface does at a point.
struct Point {
    bool regular = false;
    double area = 0.0, variation = 0.0, bending = 0.0, gauss = 0.0;
};

/// From the derivatives in any parameters: the covariant derivative of the second fundamental form,
/// its square taken with the inverse metric.
Point look(const Geom_Surface& surface, double u, double v) {
    gp_Pnt p;
    std::array<gp_Vec, 2> d1;
    std::array<std::array<gp_Vec, 2>, 2> d2;
    gp_Vec uuu, vvv, uuv, uvv;
    surface.D3(u, v, p, d1[0], d1[1], d2[0][0], d2[1][1], d2[0][1], uuu, vvv, uuv, uvv);
    d2[1][0] = d2[0][1];
    const std::array<gp_Vec, 4> d3 = {uuu, uuv, uvv, vvv};  // by how many are in v
    Point result;
    const gp_Vec cross = d1[0].Crossed(d1[1]);
    result.area = cross.Magnitude();
    if (!(result.area > kSmallestSine * d1[0].Magnitude() * d1[1].Magnitude())) {
        return result;
    }
    result.regular = true;
    const gp_Vec n = cross / result.area;
    const double det = result.area * result.area;
    const double g12 = d1[0].Dot(d1[1]);
    const double inverse[2][2] = {{d1[1].SquareMagnitude() / det, -g12 / det},
                                  {-g12 / det, d1[0].SquareMagnitude() / det}};
    double form[2][2], christoffel[2][2][2];  // [l][i][j]
    for (const int i : kBoth) {
        for (const int j : kBoth) {
            form[i][j] = n.Dot(d2[i][j]);
            for (const int l : kBoth) {
                christoffel[l][i][j] =
                    inverse[l][0] * d1[0].Dot(d2[i][j]) + inverse[l][1] * d1[1].Dot(d2[i][j]);
            }
        }
    }
    double T[2][2][2];
    for (const int i : kBoth) {
        for (const int j : kBoth) {
            for (const int k : kBoth) {
                T[i][j][k] = n.Dot(d3[i + j + k]);
                for (const int l : kBoth) {
                    T[i][j][k] -= christoffel[l][i][j] * form[l][k] +
                                  christoffel[l][k][i] * form[l][j] +
                                  christoffel[l][k][j] * form[i][l];
                }
            }
        }
    }
    double shape[2][2] = {};  // of one index raised: its eigenvalues are the curvatures
    for (const int i : kBoth) {
        for (const int j : kBoth) {
            shape[i][j] = inverse[i][0] * form[0][j] + inverse[i][1] * form[1][j];
        }
    }
    const double trace = shape[0][0] + shape[1][1];
    result.gauss = shape[0][0] * shape[1][1] - shape[0][1] * shape[1][0];
    result.bending = trace * trace - 2.0 * result.gauss;
    for (int c = 0; c < 64; ++c) {
        const int i = c & 1, j = c >> 1 & 1, k = c >> 2 & 1;
        const int a = c >> 3 & 1, b = c >> 4 & 1, d = c >> 5 & 1;
        result.variation += inverse[i][a] * inverse[j][b] * inverse[k][d] * T[i][j][k] * T[a][b][d];
    }
    return result;
}

/// Cells of an even grid with a sign each; rows and columns may be closed.
class Signs {
  public:
    Signs(int across, bool round_u, bool round_v)
        : across_(across),
          round_u_(round_u),
          round_v_(round_v),
          signs_(static_cast<std::size_t>(across) * static_cast<std::size_t>(across), 0) {}

    int& at(int i, int j) { return signs_[static_cast<std::size_t>(j * across_ + i)]; }

    /// Connected parts of one sign with more cells than this. Spends the signs.
    int parts(double least) {
        int count = 0;
        for (int j = 0; j < across_; ++j) {
            for (int i = 0; i < across_; ++i) {
                if (at(i, j) != 0 && spend(i, j) > least) {
                    ++count;
                }
            }
        }
        return count;
    }

  private:
    // The cells that hang together with this one.
    int spend(int i, int j) {
        const int sign = at(i, j);
        std::vector<std::array<int, 2>> open = {{i, j}};
        at(i, j) = 0;
        int cells = 0;
        while (!open.empty()) {
            const auto [a, b] = open.back();
            open.pop_back();
            ++cells;
            for (const auto& [da, db] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                const int x = round_u_ ? (a + da + across_) % across_ : a + da;
                const int y = round_v_ ? (b + db + across_) % across_ : b + db;
                if (x >= 0 && x < across_ && y >= 0 && y < across_ && at(x, y) == sign) {
                    at(x, y) = 0;
                    open.push_back({x, y});
                }
            }
        }
        return cells;
    }

    int across_;
    bool round_u_, round_v_;
    std::vector<int> signs_;
};

}  // namespace

Fairness fairness_of(const TopoDS_Face& face, int across) {
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const double du = (u1 - u0) / across;
    const double dv = (v1 - v0) / across;
    double a0 = 0.0, a1 = 0.0, b0 = 0.0, b1 = 0.0;
    surface->Bounds(a0, a1, b0, b1);
    const bool round_u = surface->IsUClosed() && u1 - u0 > (1.0 - kWholePeriod) * (a1 - a0);
    const bool round_v = surface->IsVClosed() && v1 - v0 > (1.0 - kWholePeriod) * (b1 - b0);
    BRepTopAdaptor_FClass2d inside(face, 1e-9);
    std::vector<double> gauss(static_cast<std::size_t>(across) * static_cast<std::size_t>(across));
    int cells = 0;
    Fairness result;
    for (int j = 0; j < across; ++j) {
        for (int i = 0; i < across; ++i) {
            const double u = u0 + (i + 0.5) * du;
            const double v = v0 + (j + 0.5) * dv;
            if (inside.Perform(gp_Pnt2d(u, v)) == TopAbs_OUT) {
                continue;
            }
            const Point point = look(*surface, u, v);
            if (!point.regular) {
                continue;
            }
            const double area = point.area * du * dv;
            ++cells;
            result.area += area;
            result.variation += area * point.variation;
            result.bending += area * point.bending;
            gauss[static_cast<std::size_t>(j * across + i)] = point.gauss;
        }
    }
    if (result.bending <= kFlatBending) {
        return result;
    }
    const double counted = kCountedGauss * 0.5 * result.bending / result.area;
    Signs signs(across, round_u, round_v);
    for (int j = 0; j < across; ++j) {
        for (int i = 0; i < across; ++i) {
            const double value = gauss[static_cast<std::size_t>(j * across + i)];
            signs.at(i, j) = value > counted ? 1 : value < -counted ? -1 : 0;
        }
    }
    result.sign_changes = std::max(0, signs.parts(kCountedCells * cells) - 1);
    return result;
}

}  // namespace suture::bench

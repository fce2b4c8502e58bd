#include "suture/fill/mvs/jumps.h"

#include "suture/base/contract.h"
#include "suture/fill/mvs/polygon.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace suture::mvs {
namespace {

// Places a span along a line.
constexpr int kLooksPerSpan = 3;

bool inside(const std::vector<Eigen::Matrix2Xd>& polygons, const Eigen::Vector2d& p,
            double from_boundary) {
    const std::vector<double> cut = crossings(polygons, p.y());
    return (std::lower_bound(cut.begin(), cut.end(), p.x()) - cut.begin()) % 2 == 1 &&
           std::ranges::all_of(polygons, [&](const Eigen::Matrix2Xd& polygon) {
               return (polygon.colwise() - p).colwise().squaredNorm().minCoeff() >
                      from_boundary * from_boundary;
           });
}

// The spans before and after a line.
std::array<int, 2> beside(const Axis& axis, double at) {
    int before = 0;
    while (before < axis.spans() && !(axis.upper(before) == at && !axis.empty(before))) {
        ++before;
    }
    int after = before + 1;
    while (after < axis.spans() && axis.empty(after)) {
        ++after;
    }
    SUTURE_EXPECTS(after < axis.spans());
    return {before, after};
}

// |n . [X_cc]| for a unit direction c square to the line. X_c is the same on both sides.
double jump_at(const Net& net, const KnotLine& line, const std::array<int, 2>& spans, double t) {
    const bool of_u = line.axis == 0;
    std::array<Eigen::Matrix<double, 3, kDerivatives>, 2> X;
    for (std::size_t side = 0; side < 2; ++side) {
        const BasisRow across = basis_row(of_u ? net.u : net.v, spans[side], line.at);
        const BasisRow along = basis_row(of_u ? net.v : net.u, t);
        const BasisRow& u = of_u ? across : along;
        const BasisRow& v = of_u ? along : across;
        X[side] = net.local_poles(u.first, v.first) * local_basis(u, v);
    }
    const Eigen::Vector3d c = X[0].col(of_u ? 0 : 1);
    const Eigen::Vector3d a = X[0].col(of_u ? 1 : 0);
    const Eigen::Vector3d normal = c.cross(a);
    const Eigen::Index second = of_u ? 2 : 4;
    const double jump = normal.dot(X[1].col(second) - X[0].col(second)) / normal.norm();
    return std::abs(jump) * a.squaredNorm() / normal.squaredNorm();
}

}  // namespace

double largest_jump(const Net& net, const std::vector<KnotLine>& lines,
                    const std::vector<Eigen::Matrix2Xd>& polygons, double from_boundary) {
    double largest = 0.0;
    for (const KnotLine& line : lines) {
        const bool of_u = line.axis == 0;
        const Axis& along = of_u ? net.v : net.u;
        const std::array<int, 2> spans = beside(of_u ? net.u : net.v, line.at);
        for (int k = 0; k < along.spans(); ++k) {
            for (int q = 0; q < kLooksPerSpan && !along.empty(k); ++q) {
                const double t =
                    along.lower(k) + (along.upper(k) - along.lower(k)) * q / kLooksPerSpan;
                const Eigen::Vector2d uv =
                    of_u ? Eigen::Vector2d(line.at, t) : Eigen::Vector2d(t, line.at);
                if (inside(polygons, uv, from_boundary)) {
                    largest = std::max(largest, jump_at(net, line, spans, t));
                }
            }
        }
    }
    return largest;
}

}  // namespace suture::mvs

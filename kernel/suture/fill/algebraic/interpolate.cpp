#include "suture/fill/algebraic/interpolate.h"

#include "suture/spline/knots.h"

#include <Eigen/LU>

#include <vector>

namespace suture::algebraic {
namespace {

using Eigen::MatrixXd;

std::vector<double> uniform_knots(int degree, int spans) {
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
    for (int n = 1; n < spans; ++n) {
        knots.push_back(static_cast<double>(n) / spans);
    }
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
    return knots;
}

std::vector<double> greville_sites(const std::vector<double>& knots, int degree) {
    std::vector<double> sites;
    for (std::size_t i = 1; i + static_cast<std::size_t>(degree) < knots.size(); ++i) {
        double sum = 0.0;
        for (int k = 0; k < degree; ++k) {
            sum += knots[i + static_cast<std::size_t>(k)];
        }
        sites.push_back(sum / degree);
    }
    return sites;
}

}  // namespace

SplineSurface interpolate(const std::function<Eigen::Vector3d(double u, double v)>& map, int degree,
                          int spans) {
    SplineSurface surface;
    surface.degree_u = surface.degree_v = degree;
    surface.knots_u = surface.knots_v = uniform_knots(degree, spans);
    const std::vector<double> sites = greville_sites(surface.knots_u, degree);
    const auto count = static_cast<Eigen::Index>(sites.size());
    MatrixXd collocation = MatrixXd::Zero(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double t = sites[static_cast<std::size_t>(i)];
        const int span = find_span(surface.knots_u, degree, t);
        collocation.block(i, span - degree, 1, degree + 1) =
            basis_derivatives(surface.knots_u, degree, span, t, 0);
    }
    const Eigen::PartialPivLU<MatrixXd> lu(collocation);
    std::array<MatrixXd, 3> values{MatrixXd(count, count), MatrixXd(count, count),
                                   MatrixXd(count, count)};
    for (Eigen::Index j = 0; j < count; ++j) {
        for (Eigen::Index i = 0; i < count; ++i) {
            const Eigen::Vector3d p =
                map(sites[static_cast<std::size_t>(i)], sites[static_cast<std::size_t>(j)]);
            for (std::size_t c = 0; c < 3; ++c) {
                values[c](i, j) = p[static_cast<Eigen::Index>(c)];
            }
        }
    }
    surface.poles.resize(3, count * count);
    for (std::size_t c = 0; c < 3; ++c) {
        const MatrixXd along_u = lu.solve(values[c]);
        const MatrixXd poles = lu.solve(along_u.transpose()).transpose();
        surface.poles.row(static_cast<Eigen::Index>(c)) = poles.reshaped().transpose();
    }
    return surface;
}

}  // namespace suture::algebraic

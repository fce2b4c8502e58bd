#include "suture/fill/manifold/star_border.h"

#include "suture/fill/manifold/layout.h"
#include "suture/fill/manifold/net_energy.h"
#include "suture/spline/knots.h"

namespace suture::manifold {
namespace {

BorderRow row_at(const Star& star, int m, double y) {
    BorderRow row;
    const int degree = star.degree();
    const std::vector<double>& kx = star.knots_x(m);
    const std::vector<double>& ky = star.knots_y(m);
    const double x = star.border(m);
    const int span_x = find_span(kx, degree, x);
    const int span_y = find_span(ky, degree, y);
    const Eigen::MatrixXd bx = basis_derivatives(kx, degree, span_x, x, 2);
    const Eigen::MatrixXd by = basis_derivatives(ky, degree, span_y, y, 1);
    const int width = degree + 1;
    row.weights.resize(4, width * width);
    for (int b = 0; b < width; ++b) {
        for (int a = 0; a < width; ++a) {
            row.points.push_back(star.point_of(m, span_x - degree + a, span_y - degree + b));
            row.weights.col(a + width * b) << bx(0, a) * by(0, b), bx(1, a) * by(0, b),
                bx(0, a) * by(1, b), bx(2, a) * by(0, b);
        }
    }
    return row;
}

}  // namespace

BorderModel border_model(const Star& star, double diameter, std::vector<double> centres) {
    BorderModel model;
    model.centres = std::move(centres);
    model.k = star.k();
    model.points = star.count();
    for (int m = 0; m < star.n(); ++m) {
        const double low = lower_end(star, m);
        const double high = upper_end(star, m);
        std::vector<double>& knots = model.knots.emplace_back();
        knots.push_back(low);
        for (const double y : star.knots_y(m)) {
            if (y > low && y < high) {
                knots.push_back(y);
            }
        }
        knots.push_back(high);
    }
    // From the border to the middle it is about a third of the diameter.
    constexpr double kShare = 0.35;
    model.depth = kShare * diameter / star.border(0);
    model.energy = net_energy(star, NetWeights());
    model.membrane = net_energy(star, NetWeights{0.0, 0.0, 1.0});
    model.fold = [star](const Eigen::Matrix3Xd& points) {
        return find_fold(StarSurface(star, points));
    };
    model.row = [star](int m, double y) { return row_at(star, m, y); };
    return model;
}

}  // namespace suture::manifold

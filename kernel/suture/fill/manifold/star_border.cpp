#include "suture/fill/manifold/star_border.h"

#include "suture/fill/manifold/layout.h"
#include "suture/fill/manifold/net_energy.h"
#include "suture/fill/manifold/quad_map.h"
#include "suture/spline/knots.h"

#include <cmath>

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

/// Places in the middle and in the border zones, a few in every knot interval.
std::vector<BorderRow> inner_rows(const Star& star) {
    const QuadMap map(star);
    std::vector<BorderRow> rows;
    const auto add = [&](const Eigen::Vector2d& p) {
        Shares shares = shares_at(star, p);
        rows.push_back({std::move(shares.points), shares.weights});
    };
    constexpr double kPerSpan = 2.0;
    const auto grid = [](double spans) { return static_cast<int>(std::ceil(kPerSpan * spans)); };
    const double inner = star.inner();
    const int middle = grid(inner + star.f_x());
    for (int m = 0; m < star.n(); ++m) {
        for (int i = 0; i < middle; ++i) {
            for (int j = 0; j < middle; ++j) {
                add(map.at(m, {(i + 0.5) / middle, (j + 0.5) / middle}));
            }
        }
        const double wide = star.border(m) - inner;
        const int across = grid(wide);
        const int along = grid(star.charts_y(m));
        for (int i = 0; i < across; ++i) {
            const double s = (i + 0.5) / across;
            const double low = (1.0 - s) * -map.reach() + s * lower_end(star, m);
            const double high = (1.0 - s) * map.reach() + s * upper_end(star, m);
            for (int j = 0; j < along; ++j) {
                const double y = low + (high - low) * (j + 0.5) / along;
                add(star.from_side(m, {inner + s * wide + star.mu(y), y}));
            }
        }
    }
    return rows;
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
    model.inner = [star] { return inner_rows(star); };
    model.row = [star](int m, double y) { return row_at(star, m, y); };
    return model;
}

}  // namespace suture::manifold

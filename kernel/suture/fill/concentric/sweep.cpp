#include "suture/fill/concentric/sweep.h"

#include "suture/base/contract.h"

#include <algorithm>

namespace suture::concentric {
namespace {

/// Knots of both, each as often as in that which has it more often.
std::vector<double> union_of(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
}

}  // namespace

SplineCurve linear_spline(const std::vector<Course>& courses,
                          const std::vector<Eigen::Vector2d>& nodes) {
    const auto n = static_cast<int>(courses.size());
    SplineCurve curve{1, {courses.front().from}, Eigen::MatrixXd(2, n + 1)};
    for (int k = 0; k < n; ++k) {
        const Course& course = courses[static_cast<std::size_t>(k)];
        curve.poles.col(k) = nodes[static_cast<std::size_t>(course.start)];
        curve.poles.col(k + 1) = nodes[static_cast<std::size_t>(course.end)];
        curve.knots.push_back(course.from);
    }
    curve.knots.push_back(courses.back().to);
    curve.knots.push_back(courses.back().to);
    return curve;
}

void make_compatible(SplineCurve& a, SplineCurve& b) {
    const int degree = std::max(a.degree, b.degree);
    a = elevated(a, degree);
    b = elevated(b, degree);
    const std::vector<double> knots = union_of(a.knots, b.knots);
    a = refined(a, knots);
    b = refined(b, knots);
}

SplineSurface from_rows(const std::vector<SplineCurve>& rows, std::vector<double> knots_v) {
    const SplineCurve& first = rows.front();
    SplineSurface surface;
    surface.degree_u = first.degree;
    surface.degree_v = static_cast<int>(knots_v.size() - rows.size()) - 1;
    surface.knots_u = first.knots;
    surface.knots_v = std::move(knots_v);
    const int n = first.count();
    surface.poles.resize(3, n * static_cast<int>(rows.size()));
    for (std::size_t j = 0; j < rows.size(); ++j) {
        SUTURE_EXPECTS(rows[j].knots == first.knots);
        surface.poles.middleCols(n * static_cast<int>(j), n) = rows[j].poles;
    }
    return surface;
}

}  // namespace suture::concentric

#include "suture/fill/manifold/cells.h"

#include "suture/fill/manifold/knot_curves.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <optional>

namespace suture::manifold {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// Of the largest weight of a cell: smaller ones lose digits, and below zero there is no patch.
constexpr double kLeastWeight = 1e-3;
/// Directions that enclose an angle with a smaller sine span no parallelogram.
constexpr double kLeastSine = 0.3;

/// Whether a point lies within the inner ends of all border zones.
bool in_middle(const Star& star, const Vector2d& p) {
    constexpr double kOn = 1e-9;
    // Sides meet along the middles between the v_m: the nearest v_m tells which one counts.
    const double turns = std::atan2(p.y(), p.x()) / star.alpha();
    const Vector2d local = star.to_side(static_cast<int>(std::lround(turns)), p);
    return local.x() - star.mu(local.y()) <= star.inner() + kOn;
}

/// Points of a cell's outline, in order.
std::vector<Vector2d> outline(const Arrangement& arrangement,
                              const std::vector<Arrangement::Use>& cell) {
    std::vector<Vector2d> points;
    constexpr int kPoints = 8;
    for (const Arrangement::Use& use : cell) {
        const PlaneCurve& c = arrangement.edges[static_cast<std::size_t>(use.edge)].curve;
        for (int k = 0; k < kPoints; ++k) {
            const double s = static_cast<double>(use.backwards ? kPoints - k : k) / kPoints;
            points.push_back(c.at(c.from + s * (c.to - c.from)));
        }
    }
    return points;
}

/// A point inside a cell, next to its longest edge.
Vector2d inner_point(const Arrangement& arrangement, const std::vector<Arrangement::Use>& cell) {
    double longest = 0.0;
    Vector2d point = Vector2d::Zero();
    constexpr double kBeside = 1e-7;
    for (const Arrangement::Use& use : cell) {
        const PlaneCurve& c = arrangement.edges[static_cast<std::size_t>(use.edge)].curve;
        const double length = c.to - c.from;
        if (length > longest) {
            longest = length;
            const double t = 0.5 * (c.from + c.to);
            const Vector2d along = (use.backwards ? -1.0 : 1.0) * c.tangent(t).normalized();
            point = c.at(t) + kBeside * length * Vector2d(-along.y(), along.x());
        }
    }
    return point;
}

/// The parallelogram origin + axes (u, v), u and v in [0, 1].
struct Parallelogram {
    Vector2d origin;
    Matrix2d axes;

    [[nodiscard]] Vector2d inverse(const Vector2d& p) const {
        return axes.inverse() * (p - origin);
    }
};

/// Around points, with sides along two directions. A little larger: an outline may bulge between
/// its points.
Parallelogram around(const std::vector<Vector2d>& points, const Matrix2d& directions) {
    Vector2d low = Vector2d::Constant(INFINITY);
    Vector2d high = -low;
    const Matrix2d inverse = directions.inverse();
    for (const Vector2d& p : points) {
        low = low.cwiseMin(inverse * p);
        high = high.cwiseMax(inverse * p);
    }
    constexpr double kMargin = 0.02;
    const Vector2d margin = kMargin * (high - low);
    low -= margin;
    high += margin;
    return {directions * low, directions * (high - low).asDiagonal()};
}

/// Bernstein coefficients on [0, 1] of t^i as a polynomial of some degree, t = 2 u - 1: blossoms,
/// the elementary symmetric polynomials of arguments 1 and -1.
Eigen::MatrixXd bernstein_of_powers(int degree) {
    Eigen::MatrixXd result(degree + 1, degree + 1);
    for (int j = 0; j <= degree; ++j) {
        Eigen::VectorXd symmetric = Eigen::VectorXd::Zero(degree + 1);
        symmetric[0] = 1.0;
        for (int a = 0; a < degree; ++a) {
            for (int i = a + 1; i > 0; --i) {
                symmetric[i] += (a < j ? 1.0 : -1.0) * symmetric[i - 1];
            }
        }
        double binomial = 1.0;
        for (int i = 0; i <= degree; ++i) {
            result(j, i) = symmetric[i] / binomial;
            binomial *= static_cast<double>(degree - i) / (i + 1);
        }
    }
    return result;
}

/// Homogeneous poles on a parallelogram of the polynomials next to `near`.
Eigen::Matrix4Xd poles_on(const StarSurface& surface, const Parallelogram& box, int degree,
                          const Vector2d& near) {
    const Vector2d half[] = {0.5 * box.axes.col(0), 0.5 * box.axes.col(1)};
    const Vector2d centre = box.origin + half[0] + half[1];
    const Series<1> u = variable(0.0, 0, degree);
    const Series<1> v = variable(0.0, 1, degree);
    const Series<4> sum =
        surface.expand_sum(constant(centre.x(), degree) + half[0].x() * u + half[1].x() * v,
                           constant(centre.y(), degree) + half[0].y() * u + half[1].y() * v, near);
    const Eigen::MatrixXd bernstein = bernstein_of_powers(degree);
    const int count = degree + 1;
    Eigen::Matrix4Xd poles = Eigen::Matrix4Xd::Zero(4, count * count);
    for (int i = 0; i <= degree; ++i) {
        for (int j = 0; i + j <= degree; ++j) {
            for (int b = 0; b < count; ++b) {
                for (int a = 0; a < count; ++a) {
                    poles.col(a + count * b) += bernstein(a, i) * bernstein(b, j) * sum.term(i, j);
                }
            }
        }
    }
    return poles;
}

SplineSurface bezier_patch(const Eigen::Matrix4Xd& poles, int degree) {
    SplineSurface spline;
    spline.degree_u = spline.degree_v = degree;
    spline.knots_u.assign(static_cast<std::size_t>(degree) + 1, 0.0);
    spline.knots_u.insert(spline.knots_u.end(), static_cast<std::size_t>(degree) + 1, 1.0);
    spline.knots_v = spline.knots_u;
    spline.weights = poles.row(3).transpose();
    spline.poles = poles.topRows(3).array().rowwise() / poles.row(3).array();
    return spline;
}

/// A cell's patch, and where it lies in X.
struct CellPatch {
    SplineSurface spline;
    Parallelogram box;
};

/// Of the parallelograms along the cell's own edges the one on which the weights vary least.
std::optional<CellPatch> patch_of(const StarSurface& surface, const Arrangement& arrangement,
                                  const std::vector<Arrangement::Use>& cell) {
    const Vector2d near = inner_point(arrangement, cell);
    const int degree = polynomial_degree(surface.star(), near);
    const std::vector<Vector2d> points = outline(arrangement, cell);
    std::vector<Vector2d> directions = {Vector2d::UnitX(), Vector2d::UnitY()};
    for (const Arrangement::Use& use : cell) {
        const PlaneCurve& c = arrangement.edges[static_cast<std::size_t>(use.edge)].curve;
        directions.push_back((c.at(c.to) - c.at(c.from)).normalized());
    }
    double best = kLeastWeight;
    std::optional<CellPatch> result;
    for (std::size_t a = 0; a < directions.size(); ++a) {
        for (std::size_t b = a + 1; b < directions.size(); ++b) {
            Matrix2d axes;
            axes << directions[a], directions[b];
            if (std::abs(axes.determinant()) < kLeastSine) {
                continue;
            }
            // Right-handed, so that the patch faces the way the surface does.
            axes.col(1) *= axes.determinant() > 0.0 ? 1.0 : -1.0;
            const Parallelogram box = around(points, axes);
            const Eigen::Matrix4Xd poles = poles_on(surface, box, degree, near);
            const double even = poles.row(3).minCoeff() / poles.row(3).maxCoeff();
            if (even > best) {
                best = even;
                result = CellPatch{bezier_patch(poles, degree), box};
            }
        }
    }
    return result;
}

class Cells {
  public:
    Cells(const StarSurface& surface, Arrangement arrangement)
        : surface_(surface), star_(surface.star()), arrangement_(std::move(arrangement)) {}

    Result<Middle> run() {
        for (const Vector2d& p : arrangement_.vertices) {
            result_.vertices.push_back(surface_.at(p));
        }
        for (const Arrangement::Edge& edge : arrangement_.edges) {
            result_.edges.push_back({{-1, edge.from}, {-1, edge.to}});
        }
        for (const std::vector<Arrangement::Use>& cell : in_reach()) {
            const auto patch = patch_of(surface_, arrangement_, cell);
            if (!patch) {
                const Vector2d at = inner_point(arrangement_, cell);
                return fail(ErrorCode::Refused,
                            "the denominator varies more than {:.0f}-fold around the cell at "
                            "({:.4g}, {:.4g}) of the parameters: a smaller aperture helps",
                            1.0 / kLeastWeight, at.x(), at.y());
            }
            add(cell, *patch);
        }
        find_outer();
        return std::move(result_);
    }

  private:
    const StarSurface& surface_;
    const Star& star_;
    Arrangement arrangement_;
    Middle result_;

    [[nodiscard]] const PlaneCurve& curve(int edge) const {
        return arrangement_.edges[static_cast<std::size_t>(edge)].curve;
    }

    /// The cells from the outside to the inside, so that each has an edge of one before it.
    [[nodiscard]] std::vector<std::vector<Arrangement::Use>> in_reach() const {
        std::vector<std::vector<Arrangement::Use>> rest = arrangement_.cells;
        const auto far = [&](const std::vector<Arrangement::Use>& cell) {
            double reach = 0.0;
            for (const Vector2d& p : outline(arrangement_, cell)) {
                reach = std::max(reach, p.norm());
            }
            return reach;
        };
        std::stable_sort(rest.begin(), rest.end(),
                         [&](const auto& a, const auto& b) { return far(a) > far(b); });
        std::vector<bool> known(arrangement_.edges.size(), false);
        for (std::size_t e = 0; e < known.size(); ++e) {
            known[e] = side_of(static_cast<int>(e)).has_value();
        }
        std::vector<std::vector<Arrangement::Use>> result;
        while (!rest.empty()) {
            const auto next = std::find_if(rest.begin(), rest.end(), [&](const auto& cell) {
                return std::any_of(cell.begin(), cell.end(), [&](const Arrangement::Use& use) {
                    return known[static_cast<std::size_t>(use.edge)];
                });
            });
            for (const Arrangement::Use& use : *next) {
                known[static_cast<std::size_t>(use.edge)] = true;
            }
            result.push_back(std::move(*next));
            rest.erase(next);
        }
        return result;
    }

    void add(const std::vector<Arrangement::Use>& cell, const CellPatch& made) {
        Patch patch;
        patch.surface = made.spline;
        std::vector<EdgeUse>& wire = patch.wires.emplace_back();
        for (const Arrangement::Use& use : cell) {
            const PlaneCurve& c = curve(use.edge);
            wire.push_back({-1, use.edge, use.backwards, [c, box = made.box](double s) -> Vector2d {
                                return box.inverse(c.at(c.from + s * (c.to - c.from)));
                            }});
        }
        result_.patches.push_back(std::move(patch));
    }

    /// The side at the inner end of whose border zone an edge lies.
    [[nodiscard]] std::optional<int> side_of(int edge) const {
        const PlaneCurve& c = curve(edge);
        const Vector2d p = c.at(0.5 * (c.from + c.to));
        const double turns = std::atan2(p.y(), p.x()) / star_.alpha();
        const int m = static_cast<int>(std::lround(turns) + star_.n()) % star_.n();
        const Vector2d local = star_.to_side(m, p);
        constexpr double kOn = 1e-8;
        return std::abs(local.x() - star_.mu(local.y()) - star_.inner()) < kOn
                   ? std::optional<int>(m)
                   : std::nullopt;
    }

    void find_outer() {
        result_.outer.resize(static_cast<std::size_t>(star_.n()));
        result_.corners.resize(static_cast<std::size_t>(star_.n()));
        for (std::size_t e = 0; e < arrangement_.edges.size(); ++e) {
            const auto edge = static_cast<int>(e);
            if (const auto m = side_of(edge)) {
                const PlaneCurve& c = curve(edge);
                const double from = star_.to_side(*m, c.at(c.from)).y();
                const double to = star_.to_side(*m, c.at(c.to)).y();
                result_.outer[static_cast<std::size_t>(*m)].push_back(
                    {edge, std::min(from, to), std::max(from, to), from > to});
            }
        }
        for (std::size_t m = 0; m < result_.outer.size(); ++m) {
            auto& along = result_.outer[m];
            std::sort(along.begin(), along.end(),
                      [](const auto& a, const auto& b) { return a.from < b.from; });
            const Arrangement::Edge& last =
                arrangement_.edges[static_cast<std::size_t>(along.back().edge)];
            result_.corners[m] = along.back().backwards ? last.from : last.to;
        }
    }
};

}  // namespace

Result<Arrangement> find_cells(const Star& star) {
    const double size = 2.0 * (star.inner() + star.aperture());
    return arrange(knot_curves(star), size, [&](const Vector2d& p) { return in_middle(star, p); });
}

Result<Middle> make_cells(const StarSurface& surface) {
    const int k = surface.star().k();
    if (k > kMostExactOrder) {
        return fail(ErrorCode::Refused,
                    "k = {}: the exact middle has cells of degree {}; it is written for k up to "
                    "{}",
                    k, (k + 1) * (2 * k + 1), kMostExactOrder);
    }
    auto arrangement = find_cells(surface.star());
    if (!arrangement) {
        return tl::unexpected(arrangement.error());
    }
    return Cells(surface, std::move(*arrangement)).run();
}

}  // namespace suture::manifold

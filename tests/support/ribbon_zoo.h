#pragma once

#include "suture/base/tolerance.h"
#include "suture/model/ribbon.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

/// Holes in closed-form surfaces, for tests of the fill methods: no OCCT, exact derivatives.
namespace suture::zoo {

/// A truncated Taylor expansion in two variables: value, first and second derivatives.
struct Jet {
    double value = 0.0;
    Eigen::Vector2d first = Eigen::Vector2d::Zero();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

    Jet(double constant = 0.0) : value(constant) {}  // NOLINT: numbers are constant jets
    static Jet variable(double value, int which) {
        Jet jet(value);
        jet.first[which] = 1.0;
        return jet;
    }
};
inline Jet operator+(const Jet& a, const Jet& b) {
    Jet r(a.value + b.value);
    r.first = a.first + b.first;
    r.second = a.second + b.second;
    return r;
}
inline Jet operator*(const Jet& a, const Jet& b) {
    Jet r(a.value * b.value);
    r.first = a.value * b.first + b.value * a.first;
    r.second = a.value * b.second + b.value * a.second + a.first * b.first.transpose() +
               b.first * a.first.transpose();
    return r;
}
inline Jet operator-(const Jet& a, const Jet& b) {
    return a + Jet(-1.0) * b;
}
/// A function of one variable, given its value and two derivatives at a.value.
inline Jet chain(const Jet& a, double f, double df, double ddf) {
    Jet r(f);
    r.first = df * a.first;
    r.second = df * a.second + ddf * a.first * a.first.transpose();
    return r;
}
inline Jet sin(const Jet& a) {
    return chain(a, std::sin(a.value), std::cos(a.value), -std::sin(a.value));
}
inline Jet cos(const Jet& a) {
    return chain(a, std::cos(a.value), -std::sin(a.value), -std::cos(a.value));
}

using Point = std::array<Jet, 3>;
/// A parametric surface; its normal is X_u x X_v.
using Surface = std::function<Point(const Jet& u, const Jet& v)>;
/// A curve in a surface's parameters: point and derivative.
using Curve = std::function<std::pair<Eigen::Vector2d, Eigen::Vector2d>(double s)>;

struct Local {
    Eigen::Vector3d point, u, v, normal;
    Eigen::Matrix3d curvature;
};
inline Local local(const Surface& surface, double u, double v) {
    const Point p = surface(Jet::variable(u, 0), Jet::variable(v, 1));
    Local l;
    for (int c = 0; c < 3; ++c) {
        const Jet& jet = p[static_cast<std::size_t>(c)];
        l.point[c] = jet.value;
        l.u[c] = jet.first[0];
        l.v[c] = jet.first[1];
    }
    l.normal = l.u.cross(l.v).normalized();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (int c = 0; c < 3; ++c) {
        second += l.normal[c] * p[static_cast<std::size_t>(c)].second;
    }
    Eigen::Matrix<double, 3, 2> E;
    E << l.u, l.v;
    const Eigen::Matrix<double, 3, 2> dual = E * (E.transpose() * E).inverse();
    l.curvature = dual * second * dual.transpose();
    return l;
}

/// The largest distance of a point from a surface, by Newton's method from the nearest of a grid.
inline double distance(const Surface& surface, const Eigen::Vector3d& q, const Eigen::Vector2d& lo,
                       const Eigen::Vector2d& hi) {
    constexpr int kGrid = 24;
    Eigen::Vector2d x = lo;
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kGrid; ++i) {
        for (int j = 0; j <= kGrid; ++j) {
            const Eigen::Vector2d t(static_cast<double>(i) / kGrid, static_cast<double>(j) / kGrid);
            const Eigen::Vector2d uv = lo + t.cwiseProduct(hi - lo);
            const Point p = surface(uv.x(), uv.y());
            const double d = (Eigen::Vector3d(p[0].value, p[1].value, p[2].value) - q).norm();
            if (d < best) {
                best = d;
                x = uv;
            }
        }
    }
    for (int step = 0; step < 20; ++step) {
        const Local l = local(surface, x.x(), x.y());
        Eigen::Matrix<double, 3, 2> E;
        E << l.u, l.v;
        x -= (E.transpose() * E).inverse() * (E.transpose() * (l.point - q));
    }
    const Local l = local(surface, x.x(), x.y());
    return std::min(best, (l.point - q).norm());
}

inline Ribbon ribbon(const Surface& surface, const Curve& curve, Continuity continuity, int edge) {
    Ribbon r;
    r.continuity = continuity;
    r.edge = edge;
    r.face = edge;
    r.at = [surface, curve](double s) {
        const auto [uv, duv] = curve(s);
        const Local l = local(surface, uv.x(), uv.y());
        RibbonPoint p;
        p.point = l.point;
        p.tangent = l.u * duv.x() + l.v * duv.y();
        p.normal = l.normal;
        p.inward = l.normal.cross(p.tangent).normalized();
        p.curvature = l.curvature;
        return p;
    };
    return r;
}

inline double diameter_of(const std::vector<RibbonLoop>& loops) {
    constexpr int kPoints = 64;
    Eigen::AlignedBox3d box;
    for (const RibbonLoop& loop : loops) {
        for (const Ribbon& r : loop.ribbons) {
            for (int k = 0; k <= kPoints; ++k) {
                box.extend(r.at(static_cast<double>(k) / kPoints).point);
            }
        }
    }
    return box.diagonal().norm();
}

inline Hole hole_of(std::vector<Ribbon> ribbons) {
    Hole hole;
    hole.loops.push_back({std::move(ribbons)});
    hole.diameter = diameter_of(hole.loops);
    return hole;
}

/// A window in one surface, bounded counterclockwise by curves in its parameters.
inline Hole window(const Surface& surface, const std::vector<Curve>& curves,
                   Continuity continuity = Continuity::G1) {
    std::vector<Ribbon> ribbons;
    int edge = 1;
    for (const Curve& curve : curves) {
        ribbons.push_back(ribbon(surface, curve, continuity, edge++));
    }
    return hole_of(std::move(ribbons));
}

// Curves in the parameters --------------------------------------------------------------------

/// r(phi) = radius (1 + depth cos(lobes phi)) about a centre, in pieces.
inline std::vector<Curve> star(Eigen::Vector2d centre, double radius, double depth, int lobes,
                               int pieces) {
    std::vector<Curve> curves;
    for (int k = 0; k < pieces; ++k) {
        curves.push_back([=](double s) {
            const double step = 2.0 * kPi / pieces;
            const double phi = step * (k + s);
            const double r = radius * (1.0 + depth * std::cos(lobes * phi));
            const double dr = -radius * depth * lobes * std::sin(lobes * phi);
            const Eigen::Vector2d e(std::cos(phi), std::sin(phi));
            const Eigen::Vector2d f(-e.y(), e.x());
            return std::pair<Eigen::Vector2d, Eigen::Vector2d>(centre + r * e,
                                                               step * (dr * e + r * f));
        });
    }
    return curves;
}
inline std::vector<Curve> circle(Eigen::Vector2d centre, double radius, int pieces) {
    return star(centre, radius, 0.0, 1, pieces);
}
inline std::vector<Curve> polygon(const std::vector<Eigen::Vector2d>& corners) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d a = corners[i];
        const Eigen::Vector2d d = corners[(i + 1) % corners.size()] - a;
        curves.push_back(
            [a, d](double s) { return std::pair<Eigen::Vector2d, Eigen::Vector2d>(a + s * d, d); });
    }
    return curves;
}
inline std::vector<Curve> regular(Eigen::Vector2d centre, double radius, int sides) {
    std::vector<Eigen::Vector2d> corners;
    for (int k = 0; k < sides; ++k) {
        const double phi = 2.0 * kPi * k / sides + 0.2;
        corners.emplace_back(centre + radius * Eigen::Vector2d(std::cos(phi), std::sin(phi)));
    }
    return polygon(corners);
}
/// An L: one reentrant corner.
inline std::vector<Curve> concave(Eigen::Vector2d c, double r) {
    return polygon({c + Eigen::Vector2d(-r, -r), c + Eigen::Vector2d(r, -0.9 * r),
                    c + Eigen::Vector2d(0.8 * r, 0.1 * r), c + Eigen::Vector2d(0.0, 0.0),
                    c + Eigen::Vector2d(-0.1 * r, r), c + Eigen::Vector2d(-0.9 * r, 0.8 * r)});
}

// Surfaces ------------------------------------------------------------------------------------

/// Longitude and latitude.
inline Surface sphere(double radius) {
    return [radius](const Jet& u, const Jet& v) {
        return Point{Jet(radius) * cos(v) * cos(u), Jet(radius) * cos(v) * sin(u),
                     Jet(radius) * sin(v)};
    };
}
/// Angle and height, about a given axis by cyclic permutation of the coordinates.
inline Surface cylinder(double radius) {
    return [radius](const Jet& u, const Jet& v) {
        return Point{Jet(radius) * cos(u), Jet(radius) * sin(u), v};
    };
}
inline Surface torus(double major, double minor) {
    return [major, minor](const Jet& u, const Jet& v) {
        const Jet rho = Jet(major) + Jet(minor) * cos(v);
        return Point{rho * cos(u), rho * sin(u), Jet(minor) * sin(v)};
    };
}
/// z = f(x, y)
inline Surface graph(std::function<Jet(const Jet&, const Jet&)> f) {
    return [f = std::move(f)](const Jet& u, const Jet& v) { return Point{u, v, f(u, v)}; };
}
inline Surface saddle(double k) {
    return graph([k](const Jet& u, const Jet& v) { return Jet(0.5 * k) * (u * u - v * v); });
}
inline Surface monkey_saddle(double k) {
    return graph(
        [k](const Jet& u, const Jet& v) { return Jet(k) * (u * u * u - Jet(3.0) * u * v * v); });
}
inline Surface wavy(double amplitude, double frequency) {
    return graph([=](const Jet& u, const Jet& v) {
        return Jet(amplitude) * sin(Jet(frequency) * u) * cos(Jet(0.8 * frequency) * v);
    });
}
/// A surface moved by a rigid motion and a scale.
inline Surface moved(const Surface& surface, const Eigen::Matrix3d& linear,
                     const Eigen::Vector3d& shift) {
    return [=](const Jet& u, const Jet& v) {
        const Point p = surface(u, v);
        Point q;
        for (int r = 0; r < 3; ++r) {
            Jet sum(shift[r]);
            for (int c = 0; c < 3; ++c) {
                sum = sum + Jet(linear(r, c)) * p[static_cast<std::size_t>(c)];
            }
            q[static_cast<std::size_t>(r)] = sum;
        }
        return q;
    };
}

// Holes between several surfaces ---------------------------------------------------------------

/// The corner of a box with rounded edges: an octant of a sphere between three quarter cylinders.
inline Hole suitcase_corner(double radius, Continuity continuity = Continuity::G1) {
    std::vector<Ribbon> ribbons;
    for (int k = 0; k < 3; ++k) {
        // The cylinder about axis k, whose other end goes to minus infinity; seen from outside, the
        // corner's boundary runs from axis k + 1 to axis k + 2.
        Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
        axes((k + 1) % 3, 0) = axes((k + 2) % 3, 1) = axes(k, 2) = 1.0;
        const Surface side = moved(cylinder(radius), axes, Eigen::Vector3d::Zero());
        ribbons.push_back(
            ribbon(side, polygon({{0.0, 0.0}, {kPi / 2, 0.0}})[0], continuity, k + 1));
    }
    return hole_of(std::move(ribbons));
}
/// The end of a round pipe, in pieces.
inline Hole pipe_end(double radius, int pieces, Continuity continuity = Continuity::G1) {
    std::vector<Ribbon> ribbons;
    for (int k = 0; k < pieces; ++k) {
        const double a = 2.0 * kPi * k / pieces;
        const double b = 2.0 * kPi * (k + 1) / pieces;
        ribbons.push_back(
            ribbon(cylinder(radius), polygon({{a, 0.0}, {b, 0.0}})[0], continuity, k + 1));
    }
    return hole_of(std::move(ribbons));
}
/// What is missing of a sphere above a latitude.
inline Hole sphere_cap(double radius, double latitude, int pieces,
                       Continuity continuity = Continuity::G1) {
    std::vector<Ribbon> ribbons;
    for (int k = 0; k < pieces; ++k) {
        const double a = 2.0 * kPi * k / pieces;
        const double b = 2.0 * kPi * (k + 1) / pieces;
        ribbons.push_back(
            ribbon(sphere(radius), polygon({{a, latitude}, {b, latitude}})[0], continuity, k + 1));
    }
    return hole_of(std::move(ribbons));
}

/// A corner at which filleted edges meet: edge i leaves the origin along a unit direction, and has
/// a fillet of this radius. The directions run counterclockwise seen from outside; edges may be
/// convex or concave.
struct FilletedEdge {
    Eigen::Vector3d direction;
    double radius;
};
/// The fillets without their ends: cylinders tangent to the planes between the edges.
class FilletCorner {
  public:
    explicit FilletCorner(const std::vector<FilletedEdge>& edges) : edges_(edges) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            fillets_.push_back(fillet(i));
        }
    }

    /// What a model of the corner is made of: one fillet, a part of a cylinder.
    struct Strip {
        Eigen::Matrix3d frame;        ///< columns: towards angle 0, a quarter turn on, along
        Eigen::Vector3d axis;         ///< a point of it
        double radius, angle;         ///< it runs from angle 0 to this one
        double from, to;              ///< the tight hole's border on it at either angle: along
        double outwards;              ///< 1 or -1: in which sense along leads away from the corner
        Eigen::Vector3d first, last;  ///< points of its lines at either angle
        Eigen::Vector3d direction;    ///< of the edge that it rounds, away from the corner
        Eigen::Vector3d meeting;      ///< where it meets the next one in the tight hole
    };
    [[nodiscard]] std::vector<Strip> strips() const {
        std::vector<Strip> result;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const Fillet& f = fillets_[i];
            const Eigen::Vector3d& e = edges_[i].direction;
            result.push_back({f.frame, f.axis, edges_[i].radius, f.angle,
                              height(i, meeting((i + edges_.size() - 1) % edges_.size())),
                              height(i, meeting(i)), e.dot(f.along) > 0.0 ? 1.0 : -1.0, f.first,
                              f.last, e, meeting(i)});
        }
        return result;
    }

    /// The hole of n sides whose corners are where neighbouring fillets meet on a plane: n fillets.
    [[nodiscard]] Hole tight(Continuity continuity = Continuity::G1) const {
        std::vector<Ribbon> ribbons;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const double from = height(i, meeting((i + edges_.size() - 1) % edges_.size()));
            const double to = height(i, meeting(i));
            ribbons.push_back(ribbon(fillets_[i].surface,
                                     polygon({{0.0, from}, {fillets_[i].angle, to}})[0], continuity,
                                     static_cast<int>(i) + 1));
        }
        return hole_of(std::move(ribbons));
    }

    /// The hole of 2 n sides around which fillets end straight at distance s from the origin, and
    /// the loop runs straight over the planes between them.
    [[nodiscard]] Hole setback(double s, Continuity continuity = Continuity::G1) const {
        std::vector<Ribbon> ribbons;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const int edge = static_cast<int>(2 * i) + 1;
            const std::size_t next = (i + 1) % edges_.size();
            const double h = height(i, s * edges_[i].direction);
            ribbons.push_back(ribbon(fillets_[i].surface,
                                     polygon({{0.0, h}, {fillets_[i].angle, h}})[0], continuity,
                                     edge));
            const Eigen::Vector3d from = fillets_[i].last + s * edges_[i].direction;
            const Eigen::Vector3d along = fillets_[next].first + s * edges_[next].direction - from;
            const Eigen::Vector3d across = outward(i).cross(along);
            const Surface plane = [from, along, across](const Jet& u, const Jet& v) {
                Point p;
                for (int c = 0; c < 3; ++c) {
                    p[static_cast<std::size_t>(c)] =
                        Jet(from[c]) + Jet(along[c]) * u + Jet(across[c]) * v;
                }
                return p;
            };
            ribbons.push_back(
                ribbon(plane, polygon({{0.0, 0.0}, {1.0, 0.0}})[0], continuity, edge + 1));
        }
        return hole_of(std::move(ribbons));
    }

  private:
    struct Fillet {
        Surface surface;
        double angle;                 // between the planes' normals
        Eigen::Vector3d along;        // unit vector in which the surface's second parameter grows
        Eigen::Vector3d first, last;  // points of the lines in which it touches the two planes
        Eigen::Matrix3d frame;
        Eigen::Vector3d axis;
    };

    // Of the plane between edges i and i + 1.
    [[nodiscard]] Eigen::Vector3d outward(std::size_t i) const {
        return edges_[i].direction.cross(edges_[(i + 1) % edges_.size()].direction).normalized();
    }
    [[nodiscard]] double height(std::size_t i, const Eigen::Vector3d& point) const {
        return point.dot(fillets_[i].along);
    }
    // Where the lines in which fillets i and i + 1 touch the plane between them cross.
    [[nodiscard]] Eigen::Vector3d meeting(std::size_t i) const {
        const std::size_t next = (i + 1) % edges_.size();
        const Eigen::Vector3d normal = outward(i);
        const Eigen::Vector3d across = normal.cross(edges_[next].direction);
        const double t =
            across.dot(fillets_[next].first - fillets_[i].last) / across.dot(edges_[i].direction);
        return fillets_[i].last + t * edges_[i].direction;
    }
    [[nodiscard]] Fillet fillet(std::size_t i) const {
        const auto& [e, r] = edges_[i];
        const Eigen::Vector3d before = outward((i + edges_.size() - 1) % edges_.size());
        const Eigen::Vector3d after = outward(i);
        const double sign = before.cross(after).dot(e) < 0.0 ? 1.0 : -1.0;  // convex: 1
        // The axis, at distance r inside both planes (outside of a concave edge).
        Eigen::Matrix3d planes;
        planes << before.transpose(), after.transpose(), e.transpose();
        const Eigen::Vector3d axis = planes.inverse() * Eigen::Vector3d(-sign * r, -sign * r, 0.0);
        Eigen::Matrix3d frame;
        frame.col(0) = sign * before;
        frame.col(1) = sign * (after - after.dot(before) * before).normalized();
        frame.col(2) = sign * frame.col(0).cross(frame.col(1));
        return {moved(cylinder(r), frame, axis),
                std::acos(before.dot(after)),
                frame.col(2),
                axis + sign * r * before,
                axis + sign * r * after,
                frame,
                axis};
    }

    std::vector<FilletedEdge> edges_;
    std::vector<Fillet> fillets_;
};
/// Corners of 3 and more edges with unequal radii and directions, by fixed patterns; `rise` lifts
/// every other edge, so that convex and concave ones meet.
inline FilletCorner fillet_corner(int edges, double slope, double rise, double vary) {
    std::vector<FilletedEdge> result;
    for (int k = 0; k < edges; ++k) {
        const double phi =
            2.0 * kPi * (k + 0.25 * vary * std::sin(2.3 * k + 0.7)) / static_cast<double>(edges);
        const double z = -slope + (k % 2 == 0 ? rise : -rise);
        result.push_back({Eigen::Vector3d(std::cos(phi), std::sin(phi), z).normalized(),
                          1.0 + 0.6 * vary * std::sin(1.7 * k * k + 0.4)});
    }
    return FilletCorner(result);
}

}  // namespace suture::zoo

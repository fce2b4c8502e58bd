#include "suture/check/surface_tree.h"

#include "suture/occ/handle.h"

#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <BndLib_AddSurface.hxx>
#include <Bnd_Box.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace suture {

namespace {

// Nine points tell the shape of a part of a turn no longer than this, and of half as many parts of
// a polynomial piece as it has degrees.
constexpr double kTurn = std::numbers::pi / 4;
constexpr int kOtherPieces = 4;  // of a surface of another kind, each of its intervals

// No face goes around its surface more often; a damaged one would be split until memory is full.
constexpr double kMostTurns = 100.0;

// No cell is divided below this part of the face's parameters: it may never become flat, where the
// surface is singular.
constexpr double kSmallest = 1e-7;

// What nine points show of the distance from two triangles, and of the box, may be too little.
constexpr double kSafety = 2.0;

Eigen::Vector3d to_eigen(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}
Eigen::Vector3d to_eigen(const gp_Vec& v) {
    return {v.X(), v.Y(), v.Z()};
}

occ::Handle<Geom_Surface> untrimmed(occ::Handle<Geom_Surface> surface) {
    while (const auto trimmed = occ::cast<Geom_RectangularTrimmedSurface>(surface)) {
        surface = trimmed->BasisSurface();
    }
    return surface;
}

std::vector<double> intervals(const GeomAdaptor_Surface& surface, bool is_u) {
    if (surface.GetType() == GeomAbs_BSplineSurface) {
        const auto spline = surface.BSpline();
        const TColStd_Array1OfReal& knots = is_u ? spline->UKnots() : spline->VKnots();
        return {knots.begin(), knots.end()};
    }
    const int count = is_u ? surface.NbUIntervals(GeomAbs_CN) : surface.NbVIntervals(GeomAbs_CN);
    TColStd_Array1OfReal ends(1, count + 1);
    if (is_u) {
        surface.UIntervals(ends, GeomAbs_CN);
    } else {
        surface.VIntervals(ends, GeomAbs_CN);
    }
    return {ends.begin(), ends.end()};
}

void add_even(double low, double high, int count, std::vector<double>& breaks) {
    for (int i = 0; i < count; ++i) {
        breaks.push_back(low + (high - low) * i / count);
    }
}

/// The parameter is an angle, or runs along a straight line.
bool is_angle(GeomAbs_SurfaceType type, bool is_u) {
    return is_u ? type >= GeomAbs_Cylinder && type <= GeomAbs_Torus
                : type == GeomAbs_Sphere || type == GeomAbs_Torus;
}
bool is_straight(GeomAbs_SurfaceType type, bool is_u) {
    return type == GeomAbs_Plane || (!is_u && (type == GeomAbs_Cylinder || type == GeomAbs_Cone ||
                                               type == GeomAbs_SurfaceOfExtrusion));
}

std::vector<double> breaks_of(const GeomAdaptor_Surface& surface, bool is_u,
                              const ParameterBox& box) {
    const std::size_t k = is_u ? 0 : 1;
    const GeomAbs_SurfaceType type = surface.GetType();
    std::vector<double> breaks;
    if (is_straight(type, is_u)) {
        return breaks;
    }
    if (is_angle(type, is_u) || (type == GeomAbs_SurfaceOfRevolution && is_u)) {
        const double turns = box.size(k) / (2.0 * std::numbers::pi);
        if (!(turns <= kMostTurns)) {
            throw std::domain_error(
                fmt::format("the face goes around its surface {:.3g} times, at most {:g} are meant",
                            turns, kMostTurns));
        }
        const int count = std::max(1, static_cast<int>(std::ceil(box.size(k) / kTurn)));
        add_even(box.low.at(k), box.high.at(k), count, breaks);
        return breaks;
    }
    const bool polynomial = type == GeomAbs_BSplineSurface || type == GeomAbs_BezierSurface;
    const int each =
        polynomial ? ((is_u ? surface.UDegree() : surface.VDegree()) + 1) / 2 : kOtherPieces;
    const auto ends = intervals(surface, is_u);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        add_even(ends[i], ends[i + 1], each, breaks);
    }
    return breaks;
}

}  // namespace

std::array<double, 2> SurfacePoint::parameters_of(const Eigen::Vector3d& tangent) const {
    const double E = du.squaredNorm();
    const double F = du.dot(dv);
    const double G = dv.squaredNorm();
    const double determinant = E * G - F * F;
    if (!(determinant > 0.0)) {
        return {0.0, 0.0};
    }
    const double a = du.dot(tangent);
    const double b = dv.dot(tangent);
    return {(G * a - F * b) / determinant, (E * b - F * a) / determinant};
}

SurfaceTree::SurfaceTree(const TopoDS_Face& face, int number) : number_(number), domain_(face) {
    TopLoc_Location location;
    surface_.Load(untrimmed(BRep_Tool::Surface(face, location)));
    moved_ = !location.IsIdentity();
    to_model_ = location.Transformation();
    bounds_ = {{surface_.FirstUParameter(), surface_.FirstVParameter()},
               {surface_.LastUParameter(), surface_.LastVParameter()}};
    bounded_ = {!surface_.IsUPeriodic() && !Precision::IsInfinite(bounds_.size(0)),
                !surface_.IsVPeriodic() && !Precision::IsInfinite(bounds_.size(1))};
    if (surface_.GetType() == GeomAbs_BSplineSurface) {
        net_ = make_derivative_net(surface_.BSpline(), to_model_);
    }
    ParameterBox box = domain_.box();
    box.low = clamped(box.low);
    box.high = clamped(box.high);
    breaks_ = {breaks_of(surface_, true, box), breaks_of(surface_, false, box)};
    cells_.push_back(make_cell(box, domain_.all_pieces()));
}

std::array<double, 2> SurfaceTree::clamped(std::array<double, 2> uv) const {
    for (const std::size_t k : {0U, 1U}) {
        if (bounded_.at(k)) {
            uv.at(k) = std::clamp(uv.at(k), bounds_.low.at(k), bounds_.high.at(k));
        }
    }
    return uv;
}

bool SurfaceTree::can_meet_itself() const {
    const GeomAbs_SurfaceType type = surface_.GetType();
    return type == GeomAbs_Torus ? surface_.Torus().MinorRadius() > surface_.Torus().MajorRadius()
                                 : type > GeomAbs_Torus;
}

bool SurfaceTree::is_injective(const ParameterBox& box) const {
    return net_ && net_->is_monotone(box);
}

bool SurfaceTree::has_break(const ParameterBox& uv, std::size_t k) const {
    const double margin = 1e-9 * uv.size(k);
    return std::ranges::any_of(breaks_.at(k), [&](double at) {
        return at > uv.low.at(k) + margin && at < uv.high.at(k) - margin;
    });
}

SurfaceTree::Cell SurfaceTree::make_cell(const ParameterBox& uv, std::vector<int> near) const {
    Cell cell;
    cell.uv = uv;
    cell.near = std::move(near);
    cell.part = domain_.classify(uv, cell.near);
    if (cell.part == FaceDomain::Part::Outside) {
        return cell;
    }
    std::array<std::array<Eigen::Vector3d, 3>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            p.at(i).at(j) = point(uv.low[0] + 0.5 * static_cast<double>(i) * uv.size(0),
                                  uv.low[1] + 0.5 * static_cast<double>(j) * uv.size(1));
            cell.box.extend(p.at(i).at(j));
        }
    }
    cell.corners = {p[0][0], p[2][0], p[2][2], p[0][2]};
    cell.flat_known = !has_break(uv, 0) && !has_break(uv, 1);
    if (!cell.flat_known && net_ && net_->covers(uv)) {
        cell.box.extend(net_->hull(uv));
        return cell;
    }
    if (!cell.flat_known) {
        Bnd_Box box;
        BndLib_AddSurface::Add(surface_, uv.low[0], uv.high[0], uv.low[1], uv.high[1], 0.0, box);
        if (moved_) {
            box = box.Transformed(to_model_);
        }
        if (!box.IsVoid()) {
            cell.box.extend(to_eigen(box.CornerMin()));
            cell.box.extend(to_eigen(box.CornerMax()));
        }
        return cell;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        for (const std::size_t i : {0U, 1U}) {
            cell.by_u.emplace_back((p.at(i + 1).at(k) - p.at(i).at(k)) / uv.size(0));
            cell.by_v.emplace_back((p.at(k).at(i + 1) - p.at(k).at(i)) / uv.size(1));
        }
    }
    // From the triangles of the corners 0 1 2 and 0 2 3.
    const auto off = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return (a - b).norm();
    };
    cell.sag =
        kSafety *
        std::max({off(p[1][0], 0.5 * (p[0][0] + p[2][0])), off(p[2][1], 0.5 * (p[2][0] + p[2][2])),
                  off(p[1][2], 0.5 * (p[0][2] + p[2][2])), off(p[0][1], 0.5 * (p[0][0] + p[0][2])),
                  off(p[1][1], 0.5 * (p[0][0] + p[2][2]))});
    cell.box.min().array() -= cell.sag;
    cell.box.max().array() += cell.sag;
    return cell;
}

/// Of its points along u or v; of its corners alone where there are no others: a closed cell has
/// equal corners.
double SurfaceTree::length_of(const Cell& cell, std::size_t k) const {
    const auto& c = cell.corners;
    const double corners = k == 0 ? (c[1] - c[0]).norm() + (c[2] - c[3]).norm()
                                  : (c[3] - c[0]).norm() + (c[2] - c[1]).norm();
    double by_points = 0.0;
    for (const Eigen::Vector3d& derivative : k == 0 ? cell.by_u : cell.by_v) {
        by_points += derivative.norm() * cell.uv.size(k);
    }
    return std::max(corners, by_points);
}

bool SurfaceTree::is_smallest(const ParameterBox& uv, std::size_t k) const {
    return uv.size(k) <= kSmallest * domain_.box().size(k);
}

int SurfaceTree::split(int i) {
    if (cell(i).children < 0) {
        const Cell parent = cell(i);
        const std::array<double, 2> along = {length_of(parent, 0), length_of(parent, 1)};
        const std::array<bool, 2> breaks = {has_break(parent.uv, 0), has_break(parent.uv, 1)};
        std::size_t k = along[0] >= along[1] ? 0 : 1;
        if (breaks[0] != breaks[1]) {
            k = breaks[0] ? 0 : 1;
        } else if (is_smallest(parent.uv, k)) {
            k = 1 - k;
        }
        double at = parent.uv.middle(k);
        if (breaks.at(k)) {
            at = *std::ranges::min_element(breaks_.at(k), {}, [&](double value) {
                return std::abs(value - parent.uv.middle(k));
            });
        }
        ParameterBox lower = parent.uv;
        ParameterBox upper = parent.uv;
        lower.high.at(k) = upper.low.at(k) = at;
        Cell one = make_cell(lower, parent.near);
        Cell two = make_cell(upper, parent.near);
        cells_[static_cast<std::size_t>(i)].children = static_cast<int>(cells_.size());
        cells_.push_back(std::move(one));
        cells_.push_back(std::move(two));
    }
    return cell(i).children;
}

Eigen::Vector3d SurfaceTree::point(double u, double v) const {
    gp_Pnt p = surface_.Value(u, v);
    if (moved_) {
        p.Transform(to_model_);
    }
    return to_eigen(p);
}

SurfacePoint SurfaceTree::at(double u, double v) const {
    gp_Pnt p;
    gp_Vec du;
    gp_Vec dv;
    surface_.D1(u, v, p, du, dv);
    if (moved_) {
        p.Transform(to_model_);
        du.Transform(to_model_);
        dv.Transform(to_model_);
    }
    return {{u, v}, to_eigen(p), to_eigen(du), to_eigen(dv)};
}

}  // namespace suture

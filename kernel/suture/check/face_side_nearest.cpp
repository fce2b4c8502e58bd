// The nearest point of a FaceSide's surface.
#include "suture/check/face_side.h"

#include <ElSLib.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>

namespace suture {

namespace {

// A Newton step this small against the edge's length ends the search: the next step, about its
// square, is below rounding.
constexpr double kNewtonStep = 1e-9;
constexpr int kNewtonSteps = 25;

// A Hessian whose determinant is below this part of its diagonal's product is not inverted.
constexpr double kSingular = 1e-8;

// A nearest point farther from the edge than this part of its length is doubted: the edge's curve
// on the surface may have led to another sheet, so the whole surface is searched too.
constexpr double kFarFromEdge = 0.01;

}  // namespace

gp_Pnt2d FaceSide::elementary_parameters(const gp_Pnt& local) const {
    double u = 0.0;
    double v = 0.0;
    switch (surface_.GetType()) {
        case GeomAbs_Plane:
            ElSLib::Parameters(surface_.Plane(), local, u, v);
            break;
        case GeomAbs_Cylinder:
            ElSLib::Parameters(surface_.Cylinder(), local, u, v);
            break;
        case GeomAbs_Cone:
            ElSLib::Parameters(surface_.Cone(), local, u, v);
            break;
        case GeomAbs_Sphere:
            ElSLib::Parameters(surface_.Sphere(), local, u, v);
            break;
        default:
            ElSLib::Parameters(surface_.Torus(), local, u, v);
            break;
    }
    return {u, v};
}

bool FaceSide::descend(const gp_Pnt& local, gp_Pnt2d& uv, gp_Pnt& on_surface) const {
    const auto& [along_u, along_v] = directions_;
    for (int step = 0; step < kNewtonSteps; ++step) {
        const Jet at = jet(uv);
        const gp_Vec r(local, at.P);
        const double gu = r * at.Su;
        const double gv = r * at.Sv;
        // A parameter at its bound with the descent pointing outwards stays there.
        const auto held = [](const Direction& along, double value, double gradient) {
            return along.bounded && ((value <= along.low && gradient > 0.0) ||
                                     (value >= along.high && gradient < 0.0));
        };
        // So does one whose whole range moves the point by rounding only, where a surface rests:
        // the quotient of two roundings would send it anywhere.
        const auto rests = [this](const Direction& along, const gp_Vec& derivative) {
            return derivative.Magnitude() * along.size <= kNewtonStep * length_;
        };
        const bool hold_u = held(along_u, uv.X(), gu) || rests(along_u, at.Su);
        const bool hold_v = held(along_v, uv.Y(), gv) || rests(along_v, at.Sv);
        double a = at.Su.SquareMagnitude() + r * at.Suu;
        double b = at.Su * at.Sv + r * at.Suv;
        double c = at.Sv.SquareMagnitude() + r * at.Svv;
        if (a <= 0.0 || c <= 0.0 || a * c - b * b <= kSingular * a * c) {
            a = at.Su.SquareMagnitude();
            b = at.Su * at.Sv;
            c = at.Sv.SquareMagnitude();
        }
        const double determinant = a * c - b * b;
        double du = 0.0;
        double dv = 0.0;
        if (!hold_u && !hold_v && determinant > kSingular * kSingular * a * c) {
            du = (b * gv - c * gu) / determinant;
            dv = (b * gu - a * gv) / determinant;
        } else {
            du = !hold_u && a > 0.0 ? -gu / a : 0.0;
            dv = !hold_v && c > 0.0 && (hold_u || a <= 0.0) ? -gv / c : 0.0;
        }
        const gp_Pnt2d next(along_u.clamped(uv.X() + du), along_v.clamped(uv.Y() + dv));
        const gp_Vec move = (next.X() - uv.X()) * at.Su + (next.Y() - uv.Y()) * at.Sv;
        uv = next;
        if (move.Magnitude() <= kNewtonStep * length_) {
            on_surface = at.P.Translated(move);
            return true;
        }
    }
    return false;
}

void FaceSide::search_grid(const gp_Pnt& local, gp_Pnt2d& uv, gp_Pnt& on_surface) {
    if (!grid_) {
        grid_.emplace(surface_);
    }
    for (const SurfaceGrid::Minimum& minimum : grid_->minima(local)) {
        if (minimum.at_least > local.Distance(on_surface)) {
            continue;
        }
        const gp_Pnt2d start = grid_->downhill(surface_, local, minimum.uv);
        const gp_Pnt at_start = surface_.Value(start.X(), start.Y());
        gp_Pnt2d end = start;
        gp_Pnt point;
        if (!descend(local, end, point) || local.Distance(point) > local.Distance(at_start)) {
            end = start;
            point = at_start;
        }
        if (local.Distance(point) < local.Distance(on_surface) - kNewtonStep * length_) {
            uv = end;
            on_surface = point;
        }
    }
}

void FaceSide::project_globally(const gp_Pnt& local, gp_Pnt2d& uv, gp_Pnt& on_surface) {
    if (directions_[0].finite && directions_[1].finite) {
        search_grid(local, uv, on_surface);
        return;
    }
    const GeomAPI_ProjectPointOnSurf projection(local, surface_.Surface());
    if (projection.NbPoints() == 0 ||
        projection.LowerDistance() >= local.Distance(on_surface) - kNewtonStep * length_) {
        return;
    }
    double u = 0.0;
    double v = 0.0;
    projection.LowerDistanceParameters(u, v);
    uv = {u, v};
    on_surface = projection.NearestPoint();
}

gp_Pnt2d FaceSide::nearest(double t, const gp_Pnt& local, gp_Pnt& on_surface) {
    if (is_elementary()) {
        const gp_Pnt2d uv = elementary_parameters(local);
        on_surface = surface_.Value(uv.X(), uv.Y());
        return uv;
    }
    const auto& [along_u, along_v] = directions_;
    gp_Pnt2d start(0.5 * (along_u.low + along_u.high), 0.5 * (along_v.low + along_v.high));
    if (load_pcurve()) {
        start = pcurve_->Value(to_pcurve(t));
        start = {along_u.clamped(start.X()), along_v.clamped(start.Y())};
    } else if (last_) {
        start = *last_;
    }
    gp_Pnt2d uv = start;
    const gp_Pnt at_start = surface_.Value(start.X(), start.Y());
    // Where the edge lies on the surface both distances are rounding noise: any converged one will
    // do.
    const bool found =
        descend(local, uv, on_surface) &&
        local.Distance(on_surface) <= local.Distance(at_start) + kNewtonStep * length_;
    if (!found) {
        uv = start;
        on_surface = at_start;
    }
    if (!found || local.Distance(on_surface) > kFarFromEdge * length_) {
        project_globally(local, uv, on_surface);
    }
    last_ = uv;
    return uv;
}

}  // namespace suture

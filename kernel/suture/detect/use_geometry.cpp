#include "suture/detect/use_geometry.h"

#include "suture/base/tolerance.h"
#include "suture/occ/convert.h"

#include <Eigen/Geometry>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>

#include <cmath>

namespace suture {

namespace {

/// Where the normal vanishes (a pole, the tip of a cone), it is taken this share of the face's
/// parameter range further inside.
constexpr double kStepInside = 1e-3;

/// Directions closer than this many radians count as a cusp, whose sign chords cannot tell.
constexpr double kCusp = 1e-4;

}  // namespace

UseGeometry::UseGeometry(const TopoDS_Edge& edge, const TopoDS_Face& face)
    : face_(face),
      surface_(face, Standard_False),
      pcurve_(BRep_Tool::CurveOnSurface(edge, face, first_, last_)),
      reversed_edge_(edge.Orientation() == TopAbs_REVERSED),
      reversed_face_(face.Orientation() == TopAbs_REVERSED) {}

Eigen::Vector2d UseGeometry::uv(double t) const {
    if (pcurve_.IsNull()) {
        return Eigen::Vector2d::Zero();
    }
    const double s = reversed_edge_ ? 1.0 - t : t;
    return occ::from_occ(pcurve_->Value(first_ + s * (last_ - first_)));
}

Eigen::AlignedBox2d UseGeometry::bounds() const {
    Eigen::AlignedBox2d box(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
    BRepTools::UVBounds(face_, box.min().x(), box.max().x(), box.min().y(), box.max().y());
    return box;
}

UsePoint UseGeometry::at(double t) const {
    const Eigen::Vector2d at_uv = uv(t);
    return {occ::from_occ(surface_.Value(at_uv.x(), at_uv.y())), normal_at(at_uv)};
}

Eigen::Vector3d UseGeometry::normal_at(const Eigen::Vector2d& uv) const {
    Eigen::Vector2d at_uv = uv;
    for (int attempt = 0; attempt < 2; ++attempt) {
        gp_Pnt p;
        gp_Vec du;
        gp_Vec dv;
        surface_.D1(at_uv.x(), at_uv.y(), p, du, dv);
        const gp_Vec n = du.Crossed(dv);
        // sin of the angle between the two parameter directions; zero lengths fail as well
        if (n.Magnitude() > 1e-9 * du.Magnitude() * dv.Magnitude()) {
            return (reversed_face_ ? -1.0 : 1.0) * occ::from_occ(n).normalized();
        }
        at_uv += kStepInside * (bounds().center() - at_uv);
    }
    return Eigen::Vector3d::Zero();
}

double UseGeometry::degenerated_angle() const {
    const Eigen::Vector2d extent = bounds().sizes();
    const Eigen::Vector3d apex = at(0.0).point;
    const double side = reversed_face_ ? -1.0 : 1.0;
    double angle = 0.0;
    Eigen::Vector3d previous;
    for (int i = 0; i <= kChords; ++i) {
        const double t = static_cast<double>(i) / kChords;
        const Eigen::Vector2d along = (uv(1.0) - uv(0.0)).cwiseQuotient(extent).normalized();
        const Eigen::Vector2d inside =
            uv(t) +
            side * kStepInside * Eigen::Vector2d(-along.y(), along.x()).cwiseProduct(extent);
        const Eigen::Vector3d direction =
            occ::from_occ(surface_.Value(inside.x(), inside.y())) - apex;
        if (i > 0) {
            angle += std::atan2(previous.cross(direction).norm(), previous.dot(direction));
        }
        previous = direction;
    }
    return angle;
}

double signed_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& n) {
    const Eigen::Vector3d a_flat = a - n * n.dot(a);
    const Eigen::Vector3d b_flat = b - n * n.dot(b);
    return std::atan2(n.dot(a_flat.cross(b_flat)), a_flat.dot(b_flat));
}

double corner_angle(const UseGeometry& arriving, const UseGeometry& leaving) {
    constexpr double kStep = 1.0 / kChords;
    const Eigen::Vector3d corner = 0.5 * (arriving.at(1.0).point + leaving.at(0.0).point);
    const Eigen::Vector3d back = arriving.at(1.0 - kStep).point - corner;
    const Eigen::Vector3d out = leaving.at(kStep).point - corner;
    const Eigen::Vector3d normal =
        (arriving.at(1.0 - 0.5 * kStep).normal + leaving.at(0.5 * kStep).normal).normalized();
    const double angle = signed_angle(out, back, normal);
    return angle < 0.0 && angle > -kCusp ? 0.0 : (angle < 0.0 ? angle + 2.0 * kPi : angle);
}

double turning_along(const UseGeometry& use) {
    double sum = 0.0;
    Eigen::Vector3d before = use.at(0.0).point;
    UsePoint here = use.at(1.0 / kChords);
    for (int i = 1; i < kChords; ++i) {
        const UsePoint after = use.at((i + 1.0) / kChords);
        sum += signed_angle(here.point - before, after.point - here.point, here.normal);
        before = here.point;
        here = after;
    }
    return sum;
}

}  // namespace suture

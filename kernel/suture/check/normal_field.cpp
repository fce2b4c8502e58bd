#include "suture/check/normal_field.h"

#include "suture/check/bernstein.h"

#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <algorithm>
#include <cmath>

namespace suture {

namespace {

// Coefficients this small against the largest are zero: rounding of the poles, and of the file that
// they came from.
constexpr double kZero = 1e-9;

using namespace bernstein;

/// Homogeneous: the points times their weights, and the weights, which are positive.
struct Piece {
    Vectors A;
    Scalars w;
    bool rational = false;

    /// w S_u - w_u S, along the derivative.
    [[nodiscard]] Vectors tangent(bool by_u) const {
        if (!rational) {
            return derivative(A, by_u, kNull);
        }
        return difference(times(w, derivative(A, by_u, kNull)), times(derivative(w, by_u, 0.0), A));
    }
};

NormalPiece to_normal_piece(const Vectors& normals, const ParameterBox& uv) {
    NormalPiece piece;
    piece.uv = uv;
    piece.degrees = {normals.m, normals.n};
    piece.coefficients = normals.c;
    return piece;
}

NormalField field_of(occ::Handle<Geom_BSplineSurface> spline, const ParameterBox& box) {
    NormalField field;
    spline = occ::cast<Geom_BSplineSurface>(spline->Copy());
    const bool periodic = spline->IsUPeriodic() || spline->IsVPeriodic();
    spline->SetUNotPeriodic();
    spline->SetVNotPeriodic();
    const int p = spline->UDegree();
    const int q = spline->VDegree();
    spline->IncreaseUMultiplicity(spline->FirstUKnotIndex(), spline->LastUKnotIndex(), p);
    spline->IncreaseVMultiplicity(spline->FirstVKnotIndex(), spline->LastVKnotIndex(), q);
    const ParameterBox whole{
        {spline->UKnot(spline->FirstUKnotIndex()), spline->VKnot(spline->FirstVKnotIndex())},
        {spline->UKnot(spline->LastUKnotIndex()), spline->VKnot(spline->LastVKnotIndex())}};
    // The loops of a face on a periodic surface may lie a period away.
    field.own_parameters = periodic ? whole.holds(box) : true;
    const bool rational = spline->IsURational() || spline->IsVRational();
    const int count_u = spline->LastUKnotIndex() - spline->FirstUKnotIndex();
    const int count_v = spline->LastVKnotIndex() - spline->FirstVKnotIndex();
    for (int k = 0; k < count_u; ++k) {
        for (int l = 0; l < count_v; ++l) {
            const int ku = spline->FirstUKnotIndex() + k;
            const int kv = spline->FirstVKnotIndex() + l;
            const ParameterBox uv{{spline->UKnot(ku), spline->VKnot(kv)},
                                  {spline->UKnot(ku + 1), spline->VKnot(kv + 1)}};
            if (field.own_parameters && !uv.meets(box)) {
                continue;
            }
            Piece piece{Vectors(p, q, kNull), Scalars(p, q, 1.0), rational};
            const gp_Pnt origin = spline->Pole(k * p + 1, l * q + 1);
            for (int i = 0; i <= p; ++i) {
                for (int j = 0; j <= q; ++j) {
                    const gp_Vec from(origin, spline->Pole(k * p + i + 1, l * q + j + 1));
                    const double w = rational ? spline->Weight(k * p + i + 1, l * q + j + 1) : 1.0;
                    piece.w.at(i, j) = w;
                    piece.A.at(i, j) = w * Eigen::Vector3d(from.X(), from.Y(), from.Z());
                }
            }
            NormalPiece& added = field.pieces.emplace_back(
                to_normal_piece(cross(piece.tangent(true), piece.tangent(false)), uv));
            added.at_end = {k == 0, k + 1 == count_u, l == 0, l + 1 == count_v};
            added.divide_out_ends();
        }
    }
    return field;
}

/// The curve's pieces as functions of u alone.
std::vector<Piece> pieces_of(const occ::Handle<Geom_Curve>& curve, double first, double last,
                             const Eigen::Vector3d& origin) {
    const auto spline =
        GeomConvert::CurveToBSplineCurve(occ::make<Geom_TrimmedCurve>(curve, first, last));
    if (spline->IsPeriodic()) {
        spline->SetNotPeriodic();
    }
    const int p = spline->Degree();
    spline->IncreaseMultiplicity(spline->FirstUKnotIndex(), spline->LastUKnotIndex(), p);
    std::vector<Piece> pieces;
    for (int k = 0; k < spline->LastUKnotIndex() - spline->FirstUKnotIndex(); ++k) {
        Piece piece{Vectors(p, 0, kNull), Scalars(p, 0, 1.0), spline->IsRational()};
        for (int i = 0; i <= p; ++i) {
            const gp_Pnt pole = spline->Pole(k * p + i + 1);
            const double w = spline->Weight(k * p + i + 1);
            piece.w.at(i, 0) = w;
            piece.A.at(i, 0) = w * (Eigen::Vector3d(pole.X(), pole.Y(), pole.Z()) - origin);
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// Along the other parameter nothing changes but the place, or the direction about the axis.
NormalField field_of_curve(const std::vector<Piece>& pieces, const ParameterBox& box,
                           const Eigen::Vector3d& direction, bool turned) {
    NormalField field;
    field.own_parameters = false;
    Vectors constant(0, 0, direction);
    for (const Piece& piece : pieces) {
        const Vectors along = piece.tangent(true);
        const Vectors normals =
            turned ? cross(cross(constant, piece.A), along) : cross(along, constant);
        field.pieces.push_back(to_normal_piece(normals, box));
    }
    if (!field.pieces.empty()) {
        // Where the curve ends on the axis.
        field.pieces.front().at_end[0] = field.pieces.back().at_end[1] = turned;
        field.pieces.front().divide_out_ends();
        field.pieces.back().divide_out_ends();
    }
    return field;
}

Eigen::Vector3d to_eigen(const gp_XYZ& p) {
    return {p.X(), p.Y(), p.Z()};
}

}  // namespace

std::array<NormalPiece, 2> NormalPiece::split(std::size_t direction, double at_parameter) const {
    NormalPiece low = *this;
    NormalPiece high = *this;
    low.uv.high.at(direction) = high.uv.low.at(direction) = at_parameter;
    const double t = (at_parameter - uv.low.at(direction)) / uv.size(direction);
    low.at_end.at(2 * direction + 1) = high.at_end.at(2 * direction) = false;
    const int n = degrees.at(direction);
    const int others = degrees.at(1 - direction);
    const auto entry = [direction](NormalPiece& piece, int k, int other) -> Eigen::Vector3d& {
        return direction == 0 ? piece.at(k, other) : piece.at(other, k);
    };
    // De Casteljau: `high` is worked down to its own coefficients.
    for (int other = 0; other <= others; ++other) {
        for (int step = 0; step <= n; ++step) {
            entry(low, step, other) = entry(high, 0, other);
            for (int k = 0; k < n - step; ++k) {
                entry(high, k, other) =
                    (1.0 - t) * entry(high, k, other) + t * entry(high, k + 1, other);
            }
        }
    }
    return {std::move(low), std::move(high)};
}

NormalPiece NormalPiece::clipped(const ParameterBox& box) const {
    NormalPiece result = *this;
    for (const std::size_t k : {0U, 1U}) {
        const double margin = 1e-9 * uv.size(k);
        if (box.low.at(k) > result.uv.low.at(k) + margin &&
            box.low.at(k) < result.uv.high.at(k) - margin) {
            result = result.split(k, box.low.at(k))[1];
        }
        if (box.high.at(k) > result.uv.low.at(k) + margin &&
            box.high.at(k) < result.uv.high.at(k) - margin) {
            result = result.split(k, box.high.at(k))[0];
        }
    }
    return result;
}

void NormalPiece::divide_out_ends() {
    double largest = 0.0;
    for (const Eigen::Vector3d& c : coefficients) {
        largest = std::max(largest, c.norm());
    }
    for (std::size_t side = 0; side < 4; ++side) {
        const bool is_u = side < 2;
        const bool high = side % 2 == 1;
        while (at_end.at(side) && degrees.at(is_u ? 0 : 1) > 0) {
            const int n = degrees.at(is_u ? 0 : 1);
            const int others = degrees.at(is_u ? 1 : 0);
            const auto entry = [&](int k, int other) {
                const int along = high ? k : n - k;  // counted towards the end
                return is_u ? at(along, other) : at(other, along);
            };
            bool vanishes = true;
            for (int other = 0; other <= others; ++other) {
                vanishes = vanishes && entry(n, other).norm() <= kZero * largest;
            }
            if (!vanishes) {
                break;
            }
            NormalPiece divided = *this;
            divided.degrees.at(is_u ? 0 : 1) = n - 1;
            divided.coefficients.resize(static_cast<std::size_t>(n * (others + 1)));
            for (int k = 0; k < n; ++k) {
                for (int other = 0; other <= others; ++other) {
                    const int along = high ? k : n - 1 - k;
                    (is_u ? divided.at(along, other) : divided.at(other, along)) =
                        static_cast<double>(n) / (n - k) * entry(k, other);
                }
            }
            *this = std::move(divided);
        }
    }
}

NormalField make_normal_field(const occ::Handle<Geom_Surface>& surface, const ParameterBox& box) {
    if (const auto spline = occ::cast<Geom_BSplineSurface>(surface)) {
        return field_of(spline, box);
    }
    if (occ::cast<Geom_BezierSurface>(surface)) {
        return field_of(GeomConvert::SurfaceToBSplineSurface(surface), box);
    }
    if (const auto extruded = occ::cast<Geom_SurfaceOfLinearExtrusion>(surface)) {
        const auto pieces =
            pieces_of(extruded->BasisCurve(), box.low[0], box.high[0], Eigen::Vector3d::Zero());
        return field_of_curve(pieces, box, to_eigen(extruded->Direction().XYZ()), false);
    }
    if (const auto turned = occ::cast<Geom_SurfaceOfRevolution>(surface)) {
        const auto pieces = pieces_of(turned->BasisCurve(), box.low[1], box.high[1],
                                      to_eigen(turned->Location().XYZ()));
        return field_of_curve(pieces, box, to_eigen(turned->Direction().XYZ()), true);
    }
    NormalField field;
    field.reason = std::string("a surface of kind ") + surface->DynamicType()->Name();
    return field;
}

}  // namespace suture

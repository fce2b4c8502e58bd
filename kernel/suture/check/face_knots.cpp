#include "suture/check/face_knots.h"

#include "suture/check/face_domain.h"
#include "suture/occ/guard.h"
#include "suture/occ/handle.h"
#include "suture/occ/topology.h"

#include <tbb/parallel_for.h>

#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace suture {

namespace {

// Points along one span of the line's own direction: a jump is a polynomial there, or nearly so.
constexpr int kSamplesPerSpan = 5;
constexpr int kSamplesMost = 257;

// A surface that turns by less than this angle over a width equal to the line's length is flat, as
// along edges.
constexpr double kFlatTurning = 1e-4;
// Below this sine of the angle between the two tangents the surface is singular.
constexpr double kSingular = 1e-8;
// A derivative below this part of the longest along the line vanishes.
constexpr double kVanishing = 1e-6;

/// Limits of the surface at a point of a knot line, from one side.
struct Jet {
    gp_Pnt P;
    gp_Vec Su, Sv, Suu, Svv, Suv;

    [[nodiscard]] bool regular() const {
        return Su.CrossMagnitude(Sv) > kSingular * Su.Magnitude() * Sv.Magnitude();
    }
    [[nodiscard]] gp_Vec normal() const { return Su.Crossed(Sv).Normalized(); }
    /// Normal curvature perpendicular to a tangent.
    [[nodiscard]] double curvature(const gp_Vec& tangent) const {
        const gp_Vec n = normal();
        const gp_Vec d = n.Crossed(tangent);
        const double E = Su.SquareMagnitude();
        const double F = Su * Sv;
        const double G = Sv.SquareMagnitude();
        const double a = (G * (d * Su) - F * (d * Sv)) / (E * G - F * F);
        const double b = (E * (d * Sv) - F * (d * Su)) / (E * G - F * F);
        const double second = a * a * (n * Suu) + 2.0 * a * b * (n * Suv) + b * b * (n * Svv);
        return second / d.SquareMagnitude();
    }
};

/// The surface seen with the direction across its knot lines first.
class Across {
  public:
    Across(const Geom_BSplineSurface& surface, bool is_u) : surface_(surface), is_u_(is_u) {}

    [[nodiscard]] int degree() const { return is_u_ ? surface_.UDegree() : surface_.VDegree(); }
    [[nodiscard]] int first() const {
        return is_u_ ? surface_.FirstUKnotIndex() : surface_.FirstVKnotIndex();
    }
    [[nodiscard]] int last() const {
        return is_u_ ? surface_.LastUKnotIndex() : surface_.LastVKnotIndex();
    }
    [[nodiscard]] double knot(int i) const { return is_u_ ? surface_.UKnot(i) : surface_.VKnot(i); }
    [[nodiscard]] int multiplicity(int i) const {
        return is_u_ ? surface_.UMultiplicity(i) : surface_.VMultiplicity(i);
    }

    /// At knot i and the other parameter, in its span [j, j + 1], as the spans [from, from + 1] of
    /// this direction see it.
    [[nodiscard]] Jet limit(int i, int from, double other, int j) const {
        Jet jet;
        if (is_u_) {
            surface_.LocalD2(knot(i), other, from, from + 1, j, j + 1, jet.P, jet.Su, jet.Sv,
                             jet.Suu, jet.Svv, jet.Suv);
        } else {
            surface_.LocalD2(other, knot(i), j, j + 1, from, from + 1, jet.P, jet.Su, jet.Sv,
                             jet.Suu, jet.Svv, jet.Suv);
        }
        return jet;
    }

    [[nodiscard]] gp_Pnt2d uv(double across, double along) const {
        return is_u_ ? gp_Pnt2d(across, along) : gp_Pnt2d(along, across);
    }
    [[nodiscard]] gp_Vec along(const Jet& jet) const { return is_u_ ? jet.Sv : jet.Su; }

  private:
    const Geom_BSplineSurface& surface_;
    bool is_u_;
};

/// Both limits at one point of a knot line.
struct Limits {
    Jet below, above;
};

void compare(const Limits& limits, const gp_Vec& tangent, double length, const gp_Trsf& to_model,
             KnotLine& line) {
    const auto& [below, above] = limits;
    const gp_Vec n1 = below.normal();
    const gp_Vec n2 = above.normal();
    const double angle = std::atan2(n1.CrossMagnitude(n2), n1 * n2);
    if (line.samples == 0 || angle > line.max_angle) {
        const gp_Pnt at = below.P.Transformed(to_model);
        line.at = {at.X(), at.Y(), at.Z()};
        line.max_angle = angle;
    }
    ++line.samples;
    const double k1 = below.curvature(tangent);
    const double k2 = above.curvature(tangent);
    const double largest = std::max(std::abs(k1), std::abs(k2));
    if (largest * length > kFlatTurning) {
        const double difference = std::abs(k1 - k2);
        line.curvature_mismatch = std::max(line.curvature_mismatch, difference / largest);
        line.curvature_mismatch_sum =
            std::max(line.curvature_mismatch_sum, difference / (std::abs(k1) + std::abs(k2)));
    }
}

/// Compares the limits wherever they have normals: a surface that ends in a point or a curve has
/// derivatives there that are nothing but rounding.
void compare_all(const std::vector<Limits>& limits, const Across& across, double length,
                 const gp_Trsf& to_model, KnotLine& line) {
    const double scale = std::abs(to_model.ScaleFactor());
    double longest_u = 0.0;
    double longest_v = 0.0;
    for (const auto& [below, above] : limits) {
        line.max_gap = std::max(line.max_gap, scale * below.P.Distance(above.P));
        longest_u = std::max({longest_u, below.Su.Magnitude(), above.Su.Magnitude()});
        longest_v = std::max({longest_v, below.Sv.Magnitude(), above.Sv.Magnitude()});
    }
    const auto has_normal = [&](const Jet& jet) {
        return jet.regular() && jet.Su.Magnitude() > kVanishing * longest_u &&
               jet.Sv.Magnitude() > kVanishing * longest_v;
    };
    for (const Limits& both : limits) {
        if (has_normal(both.below) && has_normal(both.above)) {
            compare(both, across.along(both.below), length, to_model, line);
        }
    }
}

/// What a face needs for all its lines.
struct FaceOfKnots {
    int number = 0;
    occ::Handle<Geom_BSplineSurface> surface;
    gp_Trsf to_model;
    std::array<double, 4> box = {};  ///< u and v ranges that the face covers
    std::unique_ptr<BRepTopAdaptor_FClass2d> inside;
    std::optional<FaceDomain> domain;  ///< none: its parameters repeat

    void set_domain(const TopoDS_Face& shape) {
        auto& [u0, u1, v0, v1] = box;
        BRepTools::UVBounds(shape, u0, u1, v0, v1);
        inside = std::make_unique<BRepTopAdaptor_FClass2d>(shape, Precision::PConfusion());
        if (!surface->IsUPeriodic() && !surface->IsVPeriodic()) {
            domain.emplace(shape);
            if (!domain->closed() || domain->signed_area() <= 0.0) {
                domain.reset();
            }
        }
    }
};

/// Which points of a piece of a knot line lie inside the face. OCCT's classifier, which is slow, is
/// asked only near the border.
class Inside {
  public:
    Inside(const FaceOfKnots& face, const gp_Pnt2d& from, const gp_Pnt2d& to) : face_(face) {
        if (face.domain) {
            near_ = face.domain->all_pieces();
            part_ = face.domain->classify(box(from, to), near_);
        }
    }

    [[nodiscard]] bool operator()(const gp_Pnt2d& uv) const {
        FaceDomain::Part part = part_;
        if (face_.domain && part == FaceDomain::Part::Border) {
            std::vector<int> near = near_;
            part = face_.domain->classify(box(uv, uv), near);
        }
        return part == FaceDomain::Part::Border ? face_.inside->Perform(uv) != TopAbs_OUT
                                                : part == FaceDomain::Part::Inside;
    }

  private:
    /// A little wider than its two corners: what lies on the border is no matter of rounding.
    static ParameterBox box(const gp_Pnt2d& from, const gp_Pnt2d& to) {
        const double margin = 10.0 * Precision::PConfusion();
        return {{from.X() - margin, from.Y() - margin}, {to.X() + margin, to.Y() + margin}};
    }

    const FaceOfKnots& face_;
    std::vector<int> near_;
    FaceDomain::Part part_ = FaceDomain::Part::Border;
};

KnotLine measure_line(const FaceOfKnots& face, bool is_u, int i) {
    const Across across(*face.surface, is_u);
    const Across other(*face.surface, !is_u);
    KnotLine line;
    line.face = face.number;
    line.is_u = is_u;
    line.knot = across.knot(i);
    line.parametric = across.degree() - across.multiplicity(i);
    const int spans = other.last() - other.first();
    const int per_span = std::clamp(kSamplesMost / spans, 1, kSamplesPerSpan);
    const double low = std::max(other.knot(other.first()), face.box.at(is_u ? 2 : 0));
    const double high = std::min(other.knot(other.last()), face.box.at(is_u ? 3 : 1));
    const double length = across.limit(i, i, low, other.first())
                              .P.Distance(across.limit(i, i, high, other.last() - 1).P);
    std::vector<Limits> limits;
    for (int j = other.first(); j < other.last(); ++j) {
        const double from = std::max(other.knot(j), low);
        const double to = std::min(other.knot(j + 1), high);
        if (!(to > from)) {
            continue;
        }
        const Inside inside(face, across.uv(line.knot, from), across.uv(line.knot, to));
        for (int k = 0; k <= per_span; ++k) {
            const double at = from + (to - from) * k / per_span;
            if (!inside(across.uv(line.knot, at))) {
                continue;
            }
            limits.push_back({across.limit(i, i - 1, at, j), across.limit(i, i, at, j)});
        }
    }
    compare_all(limits, across, length, face.to_model, line);
    return line;
}

std::vector<KnotLine> measure_face(const TopoDS_Face& shape, int number) {
    TopLoc_Location location;
    auto surface = BRep_Tool::Surface(shape, location);
    while (const auto trimmed = occ::cast<Geom_RectangularTrimmedSurface>(surface)) {
        surface = trimmed->BasisSurface();
    }
    FaceOfKnots face;
    face.number = number;
    face.surface = occ::cast<Geom_BSplineSurface>(surface);
    std::vector<KnotLine> lines;
    if (face.surface.IsNull()) {
        return lines;
    }
    face.to_model = location.Transformation();
    for (const bool is_u : {true, false}) {
        const Across across(*face.surface, is_u);
        for (int i = across.first() + 1; i < across.last(); ++i) {
            if (across.degree() - across.multiplicity(i) > 1) {
                continue;
            }
            if (!face.inside) {
                face.set_domain(shape);
            }
            const double low = face.box.at(is_u ? 0 : 2);
            const double high = face.box.at(is_u ? 1 : 3);
            const double margin = Precision::PConfusion() * (high - low);
            // Along the face's border it is the edge that is measured.
            if (across.knot(i) > low + margin && across.knot(i) < high - margin) {
                lines.push_back(measure_line(face, is_u, i));
            }
        }
    }
    std::erase_if(lines, [](const KnotLine& line) { return line.samples == 0; });
    return lines;
}

}  // namespace

Result<std::vector<KnotLine>> measure_face_knots(const TopoDS_Shape& shape,
                                                 const Progress& progress) {
    const occ::Numbering numbering(shape);
    const int count = numbering.faces.Extent();
    std::vector<std::vector<KnotLine>> found(static_cast<std::size_t>(count));
    tbb::parallel_for(1, count + 1, [&](int number) {
        if (progress.cancelled()) {
            return;
        }
        auto lines = occ::guarded("measuring the knots of a face", [&] {
            return measure_face(TopoDS::Face(numbering.faces(number)), number);
        });
        if (lines) {
            found[static_cast<std::size_t>(number - 1)] = std::move(*lines);
        }
    });
    if (progress.cancelled()) {
        return fail(ErrorCode::Cancelled, "check stopped while measuring knots");
    }
    std::vector<KnotLine> all;
    for (auto& lines : found) {
        all.insert(all.end(), lines.begin(), lines.end());
    }
    return all;
}

}  // namespace suture

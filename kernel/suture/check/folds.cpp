#include "suture/check/folds.h"

#include "suture/check/face_border.h"
#include "suture/check/normal_field.h"
#include "suture/check/surface_tree.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <BRep_Tool.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suture {

namespace {

// A cone of normals narrower than this to either side cannot hold two that are a fold's.
constexpr double kNarrow = std::numbers::pi / 3;
// Two normals so far apart and so near each other, against the face's width, are a fold: no more
// than half a turn is left for a fillet, and no fillet is that narrow.
constexpr double kFold = 2 * std::numbers::pi / 3;
constexpr double kNear = 0.01;
// At its border a face may end in a point, where its normals fan out.
constexpr double kFoldAtBorder = 5 * std::numbers::pi / 6;
// A cone wider than this is not told from a half-space.
constexpr double kRegular = 0.499 * std::numbers::pi;
// Coefficients this small against the piece's largest have no direction.
constexpr double kNoDirection = 1e-12;

constexpr int kMostHalvings = 48;
constexpr int kMostBoxes = 5000;
// A box this short against what is near is not made shorter before it is as short the other way.
constexpr double kShort = 0.1;
// A box this small against what is near is given up.
constexpr double kGiveUp = 1e-3;

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// How much the field changes in each direction.
std::array<double, 2> variation(const NormalPiece& piece) {
    std::array<double, 2> result = {0.0, 0.0};
    const auto& [m, n] = piece.degrees;
    for (int i = 0; i <= m; ++i) {
        for (int j = 0; j <= n; ++j) {
            result[0] += i < m ? (piece.at(i + 1, j) - piece.at(i, j)).norm() : 0.0;
            result[1] += j < n ? (piece.at(i, j + 1) - piece.at(i, j)).norm() : 0.0;
        }
    }
    return result;
}

class FoldSearch {
  public:
    FoldSearch(const TopoDS_Face& face, int number) : tree_(face, number), face_(face) {
        result_.face = number;
        near_ = kNear * width_of(face, tree_);
    }

    FaceFold run();

  private:
    void look_at_elementary(const Geom_ElementarySurface& surface);
    void look_across_pieces(const std::vector<NormalPiece>& pieces);
    void look(const NormalPiece& piece, std::vector<int> loops, int halvings);
    void give_up(const NormalPiece& piece, double size, bool at_border, std::string reason);
    void set_fold(std::array<double, 2> uv, double angle);
    [[nodiscard]] double half_angle(const NormalPiece& piece, bool corners_may_vanish) const;
    [[nodiscard]] double spread(const ParameterBox& box, std::array<double, 2>& uv) const;
    [[nodiscard]] std::array<double, 2> lengths(const ParameterBox& box) const;
    [[nodiscard]] bool inside(double u, double v) const {
        return !own_parameters_ || tree_.domain().contains(u, v);
    }

    SurfaceTree tree_;
    TopoDS_Face face_;
    FaceFold result_;
    double near_ = 0.0;
    bool own_parameters_ = true;
    int boxes_ = 0;
};

void FoldSearch::set_fold(std::array<double, 2> uv, double angle) {
    result_.verdict = FoldVerdict::Fold;
    result_.uv = uv;
    result_.at = tree_.point(uv[0], uv[1]);
    result_.angle = angle;
    result_.size = 0.0;
    result_.at_border = false;
    result_.reason.clear();
}

void FoldSearch::give_up(const NormalPiece& piece, double size, bool at_border,
                         std::string reason) {
    const bool first = result_.verdict != FoldVerdict::Undecided;
    // A box inside the face tells more than one at its border.
    if (!first && (at_border || !result_.at_border)) {
        return;
    }
    result_.verdict = FoldVerdict::Undecided;
    result_.uv = {piece.uv.middle(0), piece.uv.middle(1)};
    result_.at = tree_.point(result_.uv[0], result_.uv[1]);
    result_.size = size;
    result_.at_border = at_border;
    result_.reason = std::move(reason);
}

/// Of the cone of the coefficients about their mean direction; pi if there is none.
double FoldSearch::half_angle(const NormalPiece& piece, bool corners_may_vanish) const {
    double largest = 0.0;
    for (const Eigen::Vector3d& c : piece.coefficients) {
        largest = std::max(largest, c.norm());
    }
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    for (int i = 0; i <= piece.degrees[0]; ++i) {
        for (int j = 0; j <= piece.degrees[1]; ++j) {
            const double size = piece.at(i, j).norm();
            if (size > kNoDirection * largest) {
                axis += piece.at(i, j) / size;
                continue;
            }
            const bool corner =
                i % std::max(piece.degrees[0], 1) == 0 && j % std::max(piece.degrees[1], 1) == 0;
            if (!corner || !corners_may_vanish) {
                return std::numbers::pi;
            }
        }
    }
    if (!(axis.norm() > 0.0)) {
        return std::numbers::pi;
    }
    double widest = 0.0;
    for (const Eigen::Vector3d& c : piece.coefficients) {
        if (c.norm() > kNoDirection * largest) {
            widest = std::max(widest, angle_between(c, axis));
        }
    }
    return widest;
}

/// The largest angle between two normals of the face in the box and around it, half as far again.
double FoldSearch::spread(const ParameterBox& box, std::array<double, 2>& uv) const {
    constexpr int kPoints = 5;
    constexpr double kSingular = 1e-12;
    std::vector<SurfacePoint> points;
    for (int i = 0; i < kPoints; ++i) {
        for (int j = 0; j < kPoints; ++j) {
            const auto at =
                tree_.clamped({box.low[0] + (2.0 * i / (kPoints - 1) - 0.5) * box.size(0),
                               box.low[1] + (2.0 * j / (kPoints - 1) - 0.5) * box.size(1)});
            const SurfacePoint point = tree_.at(at[0], at[1]);
            if (tree_.domain().contains(at[0], at[1]) &&
                point.du.cross(point.dv).norm() > kSingular * point.du.norm() * point.dv.norm()) {
                points.push_back(point);
            }
        }
    }
    double widest = 0.0;
    for (const SurfacePoint& one : points) {
        for (const SurfacePoint& two : points) {
            const double angle = angle_between(one.normal(), two.normal());
            if (angle > widest) {
                widest = angle;
                uv = {0.5 * (one.uv[0] + two.uv[0]), 0.5 * (one.uv[1] + two.uv[1])};
            }
        }
    }
    return widest;
}

/// Of a box: its lengths in both directions, through nine points.
std::array<double, 2> FoldSearch::lengths(const ParameterBox& box) const {
    std::array<std::array<Eigen::Vector3d, 3>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            p.at(i).at(j) = tree_.point(box.low[0] + 0.5 * static_cast<double>(i) * box.size(0),
                                        box.low[1] + 0.5 * static_cast<double>(j) * box.size(1));
        }
    }
    std::array<double, 2> longest = {0.0, 0.0};
    for (std::size_t k = 0; k < 3; ++k) {
        longest[0] = std::max(longest[0],
                              (p[1].at(k) - p[0].at(k)).norm() + (p[2].at(k) - p[1].at(k)).norm());
        longest[1] = std::max(longest[1],
                              (p.at(k)[1] - p.at(k)[0]).norm() + (p.at(k)[2] - p.at(k)[1]).norm());
    }
    return longest;
}

void FoldSearch::look(const NormalPiece& piece, std::vector<int> loops, int halvings) {
    if (result_.verdict == FoldVerdict::Fold) {
        return;
    }
    const auto part =
        own_parameters_ ? tree_.domain().classify(piece.uv, loops) : FaceDomain::Part::Border;
    if (part == FaceDomain::Part::Outside) {
        return;
    }
    const bool at_border = part == FaceDomain::Part::Border;
    const double cone = half_angle(piece, at_border);
    if (cone <= kNarrow) {
        return;
    }
    const std::array<double, 2> along = lengths(piece.uv);
    const double size = std::hypot(along[0], along[1]);
    if (own_parameters_ && size <= near_) {
        std::array<double, 2> uv = {};
        const double angle = spread(piece.uv, uv);
        if (angle >= (at_border ? kFoldAtBorder : kFold)) {
            set_fold(uv, angle);
            return;
        }
        if (cone < kRegular) {
            return;
        }
    }
    if (size <= kGiveUp * near_ || halvings == kMostHalvings || ++boxes_ > kMostBoxes) {
        give_up(piece, size, at_border, "the surface may be singular");
        return;
    }
    // Where the normal changes, until that is short enough: then the other way.
    const std::array<double, 2> change = variation(piece);
    std::size_t direction = change[0] >= change[1] ? 0 : 1;
    if (along.at(direction) <= kShort * near_ && along.at(1 - direction) > 0.5 * near_) {
        direction = 1 - direction;
    }
    if (piece.degrees.at(direction) == 0) {
        direction = 1 - direction;
    }
    for (const NormalPiece& half : piece.halves(direction)) {
        look(half, loops, halvings + 1);
    }
}

/// Where the surface is only C0 the normal may jump from one piece to the next.
void FoldSearch::look_across_pieces(const std::vector<NormalPiece>& pieces) {
    using Corner = std::pair<std::array<double, 2>, Eigen::Vector3d>;
    std::vector<Corner> corners;
    for (const NormalPiece& piece : pieces) {
        for (const bool u : {false, true}) {
            for (const bool v : {false, true}) {
                corners.push_back({{u ? piece.uv.high[0] : piece.uv.low[0],
                                    v ? piece.uv.high[1] : piece.uv.low[1]},
                                   piece.corner(u, v)});
            }
        }
    }
    std::ranges::sort(corners, {}, &Corner::first);
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const auto& [uv, normal] = corners[i - 1];
        const auto& [same, next] = corners[i];
        if (uv == same && angle_between(normal, next) >= kFold && inside(uv[0], uv[1])) {
            set_fold(uv, angle_between(normal, next));
            return;
        }
    }
}

/// A cone beyond its apex, a torus that crosses its axis: there its radius changes sign.
void FoldSearch::look_at_elementary(const Geom_ElementarySurface& surface) {
    const ParameterBox& box = tree_.cell(0).uv;
    const auto check = [&](double v, double one, double two, double size) {
        constexpr double kAtBorder = 1e-7;
        if (std::min(one, two) < -kAtBorder * size && std::max(one, two) > kAtBorder * size) {
            set_fold({box.middle(0), v}, std::numbers::pi);
        }
    };
    if (const auto* cone = dynamic_cast<const Geom_ConicalSurface*>(&surface)) {
        const double slope = std::sin(cone->SemiAngle());
        const auto radius = [&](double v) { return cone->RefRadius() + v * slope; };
        const double size = std::abs(radius(box.low[1])) + std::abs(radius(box.high[1]));
        check(-cone->RefRadius() / slope, radius(box.low[1]), radius(box.high[1]), size);
    } else if (const auto* torus = dynamic_cast<const Geom_ToroidalSurface*>(&surface)) {
        const double ratio = torus->MajorRadius() / torus->MinorRadius();
        if (ratio >= 1.0) {
            return;
        }
        // The radius is negative about v = pi, from acos(-ratio) on.
        const double zero = std::acos(-ratio);
        const double turn = 2.0 * std::numbers::pi;
        for (const double v : {zero, turn - zero}) {
            const double at = v + turn * std::ceil((box.low[1] - v) / turn);
            const double radius_low = ratio + std::cos(box.low[1]);
            constexpr double kAtBorder = 1e-7;
            if (at > box.low[1] + kAtBorder && at < box.high[1] - kAtBorder) {
                check(at, radius_low >= 0.0 ? 1.0 : -1.0, radius_low >= 0.0 ? -1.0 : 1.0, 1.0);
            }
        }
    }
}

FaceFold FoldSearch::run() {
    result_.backwards = (tree_.domain().closed() && tree_.domain().signed_area() < 0.0) ||
                        !runs_along_edges(face_, tree_);
    TopLoc_Location location;
    auto surface = BRep_Tool::Surface(face_, location);
    while (const auto trimmed = occ::cast<Geom_RectangularTrimmedSurface>(surface)) {
        surface = trimmed->BasisSurface();
    }
    if (const auto elementary = occ::cast<Geom_ElementarySurface>(surface)) {
        look_at_elementary(*elementary);
        return result_;
    }
    const NormalField field = make_normal_field(surface, tree_.cell(0).uv);
    if (!field.reason.empty()) {
        result_.verdict = FoldVerdict::Undecided;
        result_.reason = field.reason;
        return result_;
    }
    own_parameters_ = field.own_parameters;
    if (own_parameters_) {
        look_across_pieces(field.pieces);
    }
    for (const NormalPiece& piece : field.pieces) {
        look(own_parameters_ ? piece.clipped(tree_.cell(0).uv) : piece, tree_.domain().all_pieces(),
             0);
    }
    return result_;
}

}  // namespace

Result<std::vector<FaceFold>> find_folds(const TopoDS_Shape& shape, const std::vector<int>& faces,
                                         const Progress& progress) {
    if (shape.IsNull()) {
        return fail(ErrorCode::Usage, "there is no shape to check");
    }
    const occ::Numbering numbering(shape);
    std::vector<FaceFold> result;
    for (const int number : faces) {
        if (number < 1 || number > numbering.faces.Extent()) {
            return fail(ErrorCode::Usage, "there is no Face{}: the shape has {} faces", number,
                        numbering.faces.Extent());
        }
        if (progress.cancelled()) {
            return fail(ErrorCode::Cancelled, "check stopped while looking for folds");
        }
        auto found = occ::guarded("looking for folds", [&] {
            return FoldSearch(TopoDS::Face(numbering.faces(number)), number).run();
        });
        if (!found) {
            FaceFold undecided;
            undecided.face = number;
            undecided.verdict = FoldVerdict::Undecided;
            undecided.reason = found.error().message;
            result.push_back(undecided);
            continue;
        }
        result.push_back(*found);
    }
    return result;
}

}  // namespace suture

#include "suture/check/clashes.h"

#include "suture/check/clash_pair.h"
#include "suture/check/face_border.h"
#include "suture/check/surface_tree.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

namespace suture {

namespace {

// The triangles may be this part of a new face's size away from it.
constexpr double kResolution = 3e-4;
// Points in each direction at which a face is asked whether it lies on another, and how many of
// them have to lie in the face before more are taken.
constexpr int kGrid = 12;
constexpr int kFinestGrid = 96;
constexpr int kFewestPoints = 40;
// A face lies on another with more than this part of it: along sharp edges any has a little.
constexpr double kLeastShare = 0.1;
// How near to a neighbour, against its own width, a face lies on it.
constexpr double kOnNeighbour = 0.05;

/// The inner points of a face on a grid, with the area that each stands for.
std::vector<std::pair<SurfacePoint, double>> points_of(const SurfaceTree& tree) {
    std::vector<std::pair<SurfacePoint, double>> points;
    const ParameterBox& box = tree.cell(0).uv;
    for (int n = kGrid; n <= kFinestGrid && std::ssize(points) < kFewestPoints; n *= 2) {
        points.clear();
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                const double u = box.low[0] + (i + 0.5) / n * box.size(0);
                const double v = box.low[1] + (j + 0.5) / n * box.size(1);
                if (tree.domain().contains(u, v)) {
                    const SurfacePoint point = tree.at(u, v);
                    points.emplace_back(point, point.du.cross(point.dv).norm());
                }
            }
        }
    }
    return points;
}

std::optional<Overlay> overlay_of(const std::vector<std::pair<SurfacePoint, double>>& points,
                                  SurfaceTree& other, bool same_sense, double on_surface) {
    Overlay result;
    double all = 0.0;
    double on = 0.0;
    double opposed = 0.0;
    for (const auto& [point, area] : points) {
        all += area;
        const auto near = other.nearest(point.point, on_surface);
        if (!near) {
            continue;
        }
        if (on == 0.0) {
            result.at = point.point;
        }
        on += area;
        result.distance += area * (near->point - point.point).norm();
        const bool apart = (near->normal().dot(point.normal()) < 0.0) == same_sense;
        opposed += apart ? area : 0.0;
    }
    if (on <= kLeastShare * all) {
        return std::nullopt;
    }
    result.share = on / all;
    result.distance /= on;
    result.opposed = opposed > 0.5 * on;
    return result;
}

class Search {
  public:
    Search(const occ::Numbering& numbering, double tolerance, double on_surface)
        : numbering_(numbering), tolerance_(tolerance), on_surface_(on_surface) {
        for (int number = 1; number <= numbering.faces.Extent(); ++number) {
            Bnd_Box box;
            const auto made = occ::guarded("bounding a face", [&] {
                BRepBndLib::Add(numbering.faces(number), box, /*useTriangulation=*/Standard_False);
            });
            boxes_.push_back(made ? box : Bnd_Box());
        }
    }

    /// All that one face may meet, but other new faces of lower number, which have met it already.
    void look(int face, const std::set<int>& asked, const Progress& progress, ClashReport& report) {
        Bnd_Box reach = box_of(face);
        reach.Enlarge(on_surface_ + tolerance_);
        auto made = occ::guarded(
            "bounding a face", [&] { return std::make_unique<SurfaceTree>(face_of(face), face); });
        if (!made || box_of(face).IsVoid()) {
            return;
        }
        SurfaceTree& tree = **made;
        const double resolution =
            std::max(tolerance_, kResolution * std::sqrt(box_of(face).SquareExtent()));
        report.resolution = std::max(report.resolution, resolution);
        const auto points = points_of(tree);
        for (int other = 1; other <= numbering_.faces.Extent() && !progress.cancelled(); ++other) {
            if (box_of(other).IsVoid() || reach.IsOut(box_of(other))) {
                continue;
            }
            const bool met = asked.contains(other) && other < face;
            // A pair that OCCT cannot evaluate is passed over.
            (void)occ::guarded("looking for clashes", [&] {
                if (other == face) {
                    look_at_self(tree, resolution, report);
                } else {
                    look_at(tree, points, other, !met, resolution, report);
                }
            });
        }
    }

  private:
    [[nodiscard]] const Bnd_Box& box_of(int face) const {
        return boxes_[static_cast<std::size_t>(face - 1)];
    }
    [[nodiscard]] TopoDS_Face face_of(int face) const {
        return TopoDS::Face(numbering_.faces(face));
    }

    SurfaceTree& tree_of(int face) {
        auto& tree = trees_[face];
        if (!tree) {
            tree = std::make_unique<SurfaceTree>(face_of(face), face);
        }
        return *tree;
    }

    static void add(int face, int other, const std::optional<Crossing>& crossing,
                    ClashReport& report) {
        if (crossing) {
            report.clashes.push_back(
                {face, other, crossing->point, crossing->depth, crossing->angle});
        }
    }

    void look_at_self(SurfaceTree& tree, double resolution, ClashReport& report) {
        if (tree.can_meet_itself()) {
            const SharedBorder seams(face_of(tree.number()), face_of(tree.number()));
            add(tree.number(), tree.number(),
                ClashPair(tree, tree, seams, tolerance_, resolution).deepest(), report);
        }
    }

    void look_at(SurfaceTree& tree, const std::vector<std::pair<SurfacePoint, double>>& points,
                 int other, bool clashes_too, double resolution, ClashReport& report) {
        SurfaceTree& second = tree_of(other);
        const SharedBorder shared(face_of(tree.number()), face_of(other));
        if (clashes_too) {
            add(tree.number(), other,
                ClashPair(tree, second, shared, tolerance_, resolution).deepest(), report);
        }
        const bool same_sense =
            face_of(tree.number()).Orientation() == face_of(other).Orientation();
        const double near =
            shared.has_edges()
                ? std::max(on_surface_, kOnNeighbour * width_of(face_of(tree.number()), tree))
                : on_surface_;
        if (auto overlay = overlay_of(points, second, same_sense, near)) {
            overlay->neighbours = shared.has_edges();
            overlay->face = tree.number();
            overlay->other = other;
            report.overlays.push_back(*overlay);
        }
    }

    const occ::Numbering& numbering_;
    double tolerance_, on_surface_;
    std::vector<Bnd_Box> boxes_;
    std::map<int, std::unique_ptr<SurfaceTree>> trees_;
};

}  // namespace

Result<ClashReport> find_clashes(const TopoDS_Shape& shape, const std::vector<int>& faces,
                                 double tolerance, double on_surface, const Progress& progress) {
    if (shape.IsNull()) {
        return fail(ErrorCode::Usage, "there is no shape to check");
    }
    if (!(tolerance > 0.0) || !(on_surface > 0.0)) {
        return fail(ErrorCode::Usage,
                    "the tolerance of clashes ({}) and overlays ({}) must be positive", tolerance,
                    on_surface);
    }
    const occ::Numbering numbering(shape);
    const std::set<int> asked(faces.begin(), faces.end());
    for (const int face : asked) {
        if (face < 1 || face > numbering.faces.Extent()) {
            return fail(ErrorCode::Usage, "there is no Face{}: the shape has {} faces", face,
                        numbering.faces.Extent());
        }
    }
    ClashReport report;
    Search search(numbering, tolerance, on_surface);
    for (const int face : asked) {
        search.look(face, asked, progress, report);
        if (progress.cancelled()) {
            return fail(ErrorCode::Cancelled, "check stopped while looking for clashes");
        }
    }
    return report;
}

}  // namespace suture

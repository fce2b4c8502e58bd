#include "cli/remeasure.h"

#include "suture/base/contract.h"
#include "suture/check/continuity.h"
#include "suture/check/point_distance.h"
#include "suture/occ/convert.h"

#include <fmt/format.h>

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>

namespace suture::cli {
namespace {

/// A shape is found again if its place and size agree this well, relative to its own size. Files
/// have 15 digits; the rest is what the reader mends.
constexpr double kSame = 1e-3;

/// Place and size of a face or an edge.
struct Signature {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    double extent = 0.0;  ///< length, or the square root of the area
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high = -low;  ///< box of the vertices
};

void add_vertices(const TopoDS_Shape& shape, Signature& signature) {
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
    for (int i = 1; i <= vertices.Extent(); ++i) {
        const auto point = occ::from_occ(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))));
        signature.low = signature.low.cwiseMin(point);
        signature.high = signature.high.cwiseMax(point);
    }
}

void add_properties(const TopoDS_Shape& shape, Signature& signature) {
    GProp_GProps properties;
    if (shape.ShapeType() == TopAbs_FACE) {
        BRepGProp::SurfaceProperties(shape, properties);
        signature.extent = std::sqrt(std::abs(properties.Mass()));
    } else {
        BRepGProp::LinearProperties(shape, properties);
        signature.extent = properties.Mass();
    }
    signature.centroid = occ::from_occ(properties.CentreOfMass());
}

Signature signature_of(const TopoDS_Shape& shape) {
    Signature signature;
    add_vertices(shape, signature);
    add_properties(shape, signature);
    return signature;
}

double difference(const Signature& a, const Signature& b) {
    return (a.centroid - b.centroid).norm() + std::abs(a.extent - b.extent);
}

bool same_vertices(const Signature& a, const Signature& b) {
    return (a.low - b.low).norm() + (a.high - b.high).norm() <= kSame * a.extent;
}

/// The faces or the edges of a shape, by what is cheap to know of each; area, length and centroid
/// only when asked for.
class ShapeFinder {
  public:
    explicit ShapeFinder(const TopTools_IndexedMapOfShape& shapes) : shapes_(shapes) {
        for (int i = 1; i <= shapes.Extent(); ++i) {
            add_vertices(shapes(i), signatures_.emplace_back());
        }
    }

    /// The number of the shape, or 0.
    int find(const Signature& wanted) {
        std::vector<int> all(signatures_.size());
        std::iota(all.begin(), all.end(), 1);
        return find(wanted, all);
    }

    /// The same among the shapes of these numbers.
    int find(const Signature& wanted, std::span<const int> among) {
        const int near = nearest(wanted, among, /*same_vertices_only=*/true);
        // Of a closed face or edge the reader may have moved the vertices.
        return near > 0 ? near : nearest(wanted, among, /*same_vertices_only=*/false);
    }

  private:
    int nearest(const Signature& wanted, std::span<const int> among, bool same_vertices_only) {
        int best = 0;
        double smallest = kSame * wanted.extent;
        for (const int i : among) {
            Signature& signature = signatures_[static_cast<std::size_t>(i - 1)];
            if (same_vertices_only && !same_vertices(wanted, signature)) {
                continue;
            }
            if (signature.extent == 0.0) {
                add_properties(shapes_(i), signature);
            }
            const double distance = difference(wanted, signature);
            if (distance <= smallest) {
                smallest = distance;
                best = i;
            }
        }
        return best;
    }

    const TopTools_IndexedMapOfShape& shapes_;
    std::vector<Signature> signatures_;
};

/// A hole to be measured, in the numbers of the measured shape.
struct Found {
    HoleReport* hole = nullptr;
    std::map<int, SideReport*> sides;  ///< by their edges
    std::vector<int> edges;            ///< the sides, and all edges of the new faces
    std::vector<TopoDS_Face> faces;    ///< the new faces
};

/// Finds the new faces of one hole and its sides.
class HoleFinder {
  public:
    explicit HoleFinder(const occ::Numbering& measured)
        : measured_(measured), faces_(measured.faces), edges_(measured.edges) {}

    Found find(const FilledPart& part, HoleReport& hole, std::span<const TopoDS_Face> new_faces) {
        Found found{&hole, {}, {}, {}};
        for (std::size_t i = 0; i < new_faces.size(); ++i) {
            const int face = faces_.find(signature_in_model(new_faces[i], part));
            hole.patches[i].face = face;
            if (face == 0) {
                hole.notes.emplace_back("a new face was not found again in the output");
                continue;
            }
            found.faces.push_back(TopoDS::Face(measured_.faces(face)));
            for (const TopoDS_Edge& edge : occ::edges_of(measured_.faces(face))) {
                found.edges.push_back(measured_.of(edge));
            }
        }
        const std::vector<int> borders = found.edges;
        for (SideReport& side : hole.sides) {
            const Signature edge =
                signature_in_model(part.before->numbering.edges(side.edge), part);
            // Another part of the model may have an edge in the same place.
            int number = edges_.find(edge, borders);
            if (number == 0) {
                number = edges_.find(edge);
            }
            if (number > 0) {
                found.sides[number] = &side;
                found.edges.push_back(number);
            }
        }
        std::sort(found.edges.begin(), found.edges.end());
        found.edges.erase(std::unique(found.edges.begin(), found.edges.end()), found.edges.end());
        return found;
    }

  private:
    static Signature signature_in_model(const TopoDS_Shape& shape, const FilledPart& part) {
        return signature_of(shape.Moved(part.before->placement));
    }

    const occ::Numbering& measured_;
    ShapeFinder faces_;
    ShapeFinder edges_;
};

bool meets(const EdgeContinuity& edge, Continuity wanted, const Tolerance& tolerance) {
    return edge.samples > 0 && edge.max_gap <= tolerance.linear &&
           (wanted < Continuity::G1 || edge.max_angle <= tolerance.angular) &&
           (wanted < Continuity::G2 || edge.curvature_mismatch <= tolerance.curvature);
}

Continuity reached_by(const EdgeContinuity& edge, const Tolerance& tolerance) {
    return meets(edge, Continuity::G2, tolerance)   ? Continuity::G2
           : meets(edge, Continuity::G1, tolerance) ? Continuity::G1
                                                    : Continuity::G0;
}

/// A side that was not found again has no figures, and the hole no good ones.
void forget_lost_sides(const Found& found) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    HoleReport& hole = *found.hole;
    int lost = 0;
    for (SideReport& side : hole.sides) {
        if (std::none_of(found.sides.begin(), found.sides.end(),
                         [&](const auto& entry) { return entry.second == &side; })) {
            side.gap = side.angle = side.curvature_mismatch = kUnknown;
            ++lost;
        }
    }
    if (lost > 0) {
        hole.within_tolerance = false;
        hole.continuity_reached = Continuity::G0;
        hole.notes.push_back(fmt::format("{} of {} sides were not found again in the output", lost,
                                         hole.sides.size()));
    }
}

void judge(const Found& found, const ContinuityReport& report, const Tolerance& tolerance) {
    HoleReport& hole = *found.hole;
    hole.max_gap = hole.max_angle = hole.max_curvature_mismatch =
        found.edges.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    hole.continuity_reached = Continuity::G2;
    hole.within_tolerance = true;
    for (const auto& [edges, fault] : {std::pair(&report.free_edges, "is open"),
                                       std::pair(&report.non_manifold, "has too many faces")}) {
        for (const int number : *edges) {
            if (std::find(found.edges.begin(), found.edges.end(), number) != found.edges.end()) {
                hole.within_tolerance = false;
                hole.continuity_reached = Continuity::G0;
                hole.notes.push_back(fmt::format("edge {} of the output {}", number, fault));
            }
        }
    }
    forget_lost_sides(found);
    for (const EdgeContinuity& edge : report.edges) {
        if (std::find(found.edges.begin(), found.edges.end(), edge.edge) == found.edges.end()) {
            continue;
        }
        Continuity wanted = hole.continuity_requested;
        if (const auto entry = found.sides.find(edge.edge); entry != found.sides.end()) {
            SideReport& side = *entry->second;
            wanted = side.requested;
            side.gap = edge.max_gap;
            side.angle = edge.max_angle;
            side.curvature_mismatch = edge.curvature_mismatch;
        }
        hole.max_gap = std::max(hole.max_gap, edge.max_gap);
        // Where only position was asked for, the angle is the design's, not an error.
        if (wanted >= Continuity::G1) {
            hole.max_angle = std::max(hole.max_angle, edge.max_angle);
            hole.max_curvature_mismatch =
                std::max(hole.max_curvature_mismatch, edge.curvature_mismatch);
        }
        hole.continuity_reached = std::min(hole.continuity_reached, reached_by(edge, tolerance));
        hole.within_tolerance = hole.within_tolerance && meets(edge, wanted, tolerance);
    }
}

/// From this angle on a face lies back on its neighbour.
constexpr double kFoldedBack = radians(179.99);

/// A fill that lies on its neighbours closes a shell without filling anything: the cap of a flat
/// sheet's own outline.
void note_folded_sides(HoleReport& hole) {
    const auto folded = std::count_if(hole.sides.begin(), hole.sides.end(), [](const auto& side) {
        return side.requested == Continuity::G0 && side.angle > kFoldedBack;
    });
    if (folded > 0) {
        hole.notes.push_back(
            fmt::format("at {} of {} sides the new face lies back on its neighbour (180 deg)",
                        folded, hole.sides.size()));
    }
}

/// The points that the new faces were to pass, which are given in the part's own coordinates.
void judge_through(const std::vector<TopoDS_Face>& faces, const TopLoc_Location& placement,
                   const Tolerance& tolerance, HoleReport& hole) {
    hole.max_distance_through = 0.0;
    for (const Eigen::Vector3d& point : hole.through) {
        const gp_Pnt in_model = occ::to_point(point).Transformed(placement.Transformation());
        hole.max_distance_through =
            std::max(hole.max_distance_through, measure_distance(occ::from_occ(in_model), faces));
    }
    hole.within_tolerance = hole.within_tolerance && hole.max_distance_through <= tolerance.linear;
}

/// Calls action(part, hole, its new faces).
template <class Action>
void for_each_filled(std::vector<FilledPart>& parts, Action&& action) {
    for (FilledPart& part : parts) {
        std::span<const TopoDS_Face> new_faces(part.outcome.new_faces);
        for (HoleReport& hole : part.outcome.holes) {
            if (hole.status == FillStatus::Filled) {
                SUTURE_EXPECTS(hole.patches.size() <= new_faces.size());  // one face per patch
                action(part, hole, new_faces.first(hole.patches.size()));
                new_faces = new_faces.subspan(hole.patches.size());
            }
        }
    }
}

}  // namespace

Result<void> remeasure(const TopoDS_Shape& shape, std::vector<FilledPart>& parts,
                       const Tolerance& tolerance, const Progress& progress) {
    const occ::Numbering measured(shape);
    HoleFinder finder(measured);
    std::vector<Found> holes;
    std::vector<int> edges;
    for_each_filled(parts, [&](const FilledPart& part, HoleReport& hole, const auto& new_faces) {
        holes.push_back(finder.find(part, hole, new_faces));
        edges.insert(edges.end(), holes.back().edges.begin(), holes.back().edges.end());
    });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    Profile profile;
    profile.tolerance = tolerance;
    // No edges would mean all of them.
    const Result<ContinuityReport> report =
        edges.empty() ? ContinuityReport() : measure_continuity(shape, profile, edges, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    for (const Found& found : holes) {
        judge(found, *report, tolerance);
        note_folded_sides(*found.hole);
    }
    std::size_t next = 0;
    for_each_filled(parts, [&](const FilledPart& part, HoleReport& hole, const auto& /*faces*/) {
        judge_through(holes[next++].faces, part.before->placement, tolerance, hole);
    });
    return {};
}

void number_new_faces(const TopoDS_Shape& model, std::vector<FilledPart>& parts) {
    const occ::Numbering numbering(model);
    for_each_filled(parts, [&](const FilledPart& part, HoleReport& hole, const auto& new_faces) {
        for (std::size_t i = 0; i < new_faces.size(); ++i) {
            const TopoDS_Shape face = new_faces[i].Moved(part.before->placement);
            hole.patches[i].face = numbering.faces.FindIndex(face);
        }
    });
}

}  // namespace suture::cli

#include "cli/remeasure.h"

#include "suture/base/contract.h"
#include "suture/check/continuity.h"
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

/// The faces of a shape, by what is cheap to know of each; area and centroid only when asked for.
class FaceFinder {
  public:
    explicit FaceFinder(const occ::Numbering& numbering) : numbering_(numbering) {
        for (int i = 1; i <= numbering.faces.Extent(); ++i) {
            add_vertices(numbering.faces(i), faces_.emplace_back());
        }
    }

    /// FaceN, or 0
    int find(const Signature& wanted) {
        const int near = nearest(wanted, /*same_vertices_only=*/true);
        // Of a closed face the reader may have moved the vertices.
        return near > 0 ? near : nearest(wanted, /*same_vertices_only=*/false);
    }

  private:
    int nearest(const Signature& wanted, bool same_vertices_only) {
        int best = 0;
        double smallest = kSame * wanted.extent;
        for (int face = 1; face <= numbering_.faces.Extent(); ++face) {
            Signature& signature = faces_[static_cast<std::size_t>(face - 1)];
            if (same_vertices_only && !same_vertices(wanted, signature)) {
                continue;
            }
            if (signature.extent == 0.0) {
                add_properties(numbering_.faces(face), signature);
            }
            const double distance = difference(wanted, signature);
            if (distance <= smallest) {
                smallest = distance;
                best = face;
            }
        }
        return best;
    }

    const occ::Numbering& numbering_;
    std::vector<Signature> faces_;
};

/// A hole to be measured.
struct Found {
    HoleReport* hole = nullptr;
    const FilledPart* part = nullptr;
    std::vector<int> edges;  ///< of the new faces, in the measured shape
};

/// Finds the new faces of a hole and their edges; false if a face is not there.
bool find_faces(std::span<const TopoDS_Face> new_faces, const occ::Numbering& measured,
                FaceFinder& finder, Found& found) {
    for (std::size_t i = 0; i < new_faces.size(); ++i) {
        const int face =
            finder.find(signature_of(new_faces[i].Moved(found.part->before->placement)));
        if (face == 0) {
            return false;
        }
        found.hole->patches[i].face = face;
        for (const TopoDS_Edge& edge : occ::edges_of(measured.faces(face))) {
            found.edges.push_back(measured.of(edge));
        }
    }
    return true;
}

void forget_figures(HoleReport& hole) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    hole.max_gap = hole.max_angle = hole.max_curvature_mismatch = kUnknown;
    hole.within_tolerance = false;
    hole.continuity_reached = Continuity::G0;
    hole.notes.emplace_back("the new face was not found again in the output: nothing is measured");
}

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

/// Which of the hole's sides an edge of the measured shape is.
class SideFinder {
  public:
    explicit SideFinder(const Found& found) : sides_(found.hole->sides) {
        for (const SideReport& side : sides_) {
            const TopoDS_Shape edge = found.part->before->numbering.edges(side.edge);
            signatures_.push_back(signature_of(edge.Moved(found.part->before->placement)));
        }
    }

    SideReport* find(const TopoDS_Shape& edge) {
        const Signature signature = signature_of(edge);
        SideReport* best = nullptr;
        double smallest = kSame * signature.extent;
        for (std::size_t i = 0; i < sides_.size(); ++i) {
            const double distance = difference(signature, signatures_[i]);
            if (distance <= smallest) {
                smallest = distance;
                best = &sides_[i];
            }
        }
        return best;
    }

  private:
    std::vector<SideReport>& sides_;
    std::vector<Signature> signatures_;
};

void judge(const Found& found, const occ::Numbering& measured, const ContinuityReport& report,
           const Tolerance& tolerance) {
    HoleReport& hole = *found.hole;
    hole.max_gap = hole.max_angle = hole.max_curvature_mismatch = 0.0;
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
    SideFinder sides(found);
    std::size_t found_sides = 0;
    for (const EdgeContinuity& edge : report.edges) {
        if (std::find(found.edges.begin(), found.edges.end(), edge.edge) == found.edges.end()) {
            continue;
        }
        SideReport* side = sides.find(measured.edges(edge.edge));
        const Continuity wanted = side != nullptr ? side->requested : hole.continuity_requested;
        if (side != nullptr) {
            ++found_sides;
            side->gap = edge.max_gap;
            side->angle = edge.max_angle;
            side->curvature_mismatch = edge.curvature_mismatch;
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
    if (found_sides < hole.sides.size()) {
        hole.notes.push_back(fmt::format("{} of {} sides were not found again in the output",
                                         hole.sides.size() - found_sides, hole.sides.size()));
    }
}

}  // namespace

Result<void> remeasure(const TopoDS_Shape& shape, std::vector<FilledPart>& parts,
                       const Tolerance& tolerance, const Progress& progress) {
    const occ::Numbering measured(shape);
    FaceFinder finder(measured);
    std::vector<Found> holes;
    std::vector<int> edges;
    for (FilledPart& part : parts) {
        std::span<const TopoDS_Face> new_faces(part.outcome.new_faces);
        for (HoleReport& hole : part.outcome.holes) {
            if (hole.status != FillStatus::Filled) {
                continue;
            }
            SUTURE_EXPECTS(hole.patches.size() <= new_faces.size());  // one face per patch
            const auto own = new_faces.first(hole.patches.size());
            new_faces = new_faces.subspan(own.size());
            Found found{&hole, &part, {}};
            if (!find_faces(own, measured, finder, found)) {
                forget_figures(hole);
                continue;
            }
            edges.insert(edges.end(), found.edges.begin(), found.edges.end());
            holes.push_back(std::move(found));
        }
    }
    if (edges.empty()) {
        return {};
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    Profile profile;
    profile.tolerance = tolerance;
    const Result<ContinuityReport> report = measure_continuity(shape, profile, edges, progress);
    if (!report) {
        return tl::unexpected(report.error());
    }
    for (const Found& found : holes) {
        judge(found, measured, *report, tolerance);
    }
    return {};
}

}  // namespace suture::cli

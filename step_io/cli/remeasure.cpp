#include "cli/remeasure.h"

#include "cli/find_again.h"
#include "cli/placed_point.h"
#include "suture/base/contract.h"
#include "suture/check/fill_measures.h"
#include "suture/occ/convert.h"

#include <TopoDS.hxx>

#include <map>
#include <span>

namespace suture::cli {
namespace {

/// Finds the new faces of one hole and its sides.
class HoleFinder {
  public:
    explicit HoleFinder(const occ::Numbering& measured)
        : measured_(measured), faces_(measured.faces), edges_(measured.edges) {}

    FillPlace find(const FilledPart& part, HoleReport& hole,
                   std::span<const TopoDS_Face> new_faces) {
        FillPlace place;
        std::vector<int> borders;
        for (std::size_t i = 0; i < new_faces.size(); ++i) {
            const int face = faces_.find(signature_in_model(new_faces[i], part));
            hole.patches[i].face = face;
            place.faces.push_back(face);
            for (const TopoDS_Edge& edge :
                 face > 0 ? occ::edges_of(measured_.faces(face)) : std::vector<TopoDS_Edge>()) {
                borders.push_back(measured_.of(edge));
            }
        }
        for (const SideReport& side : hole.sides) {
            const Signature edge = signature_in_model(side.on_edge, part);
            // Another part of the model may have an edge in the same place.
            const int number = edges_.find(edge, borders);
            place.sides.push_back(number > 0 ? number : edges_.find(edge));
            place.supports.push_back(
                side.support.IsNull() ? side.support
                                      : TopoDS::Face(side.support.Moved(part.before->placement)));
        }
        // The points are given in the part's own coordinates.
        for (const ThroughPoint& point : hole.through) {
            place.through.push_back(placed(point, part.before->placement.Transformation()));
        }
        return place;
    }

  private:
    static Signature signature_in_model(const TopoDS_Shape& shape, const FilledPart& part) {
        return signature_of(shape.Moved(part.before->placement));
    }

    const occ::Numbering& measured_;
    ShapeFinder faces_;
    ShapeFinder edges_;
};

/// What is read again may be the new faces and their neighbours alone: the clashes are those that
/// were found in memory, with all of the part around.
void add_clashes(const TopLoc_Location& placement, const HoleReport& hole, FillMeasures& measures) {
    const auto moved = [&](const Eigen::Vector3d& point) {
        return occ::from_occ(occ::to_point(point).Transformed(placement.Transformation()));
    };
    measures.clashes = hole.clashes;
    measures.overlays = hole.overlays;
    for (Clash& clash : measures.clashes) {
        clash.at = moved(clash.at);
    }
    for (Overlay& overlay : measures.overlays) {
        overlay.at = moved(overlay.at);
    }
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
    std::vector<FillPlace> places;
    for_each_filled(parts, [&](const FilledPart& part, HoleReport& hole, const auto& new_faces) {
        places.push_back(finder.find(part, hole, new_faces));
    });
    Profile profile;
    profile.tolerance = tolerance;
    auto measures = measure_fills(shape, measured, places, profile, progress);
    if (!measures) {
        return tl::unexpected(measures.error());
    }
    std::size_t next = 0;
    for_each_filled(parts, [&](const FilledPart& part, HoleReport& hole, const auto& /*faces*/) {
        FillMeasures& figures = (*measures)[next++];
        add_clashes(part.before->placement, hole, figures);
        set_figures(figures, hole);
    });
    return {};
}

void number_new_faces(const TopoDS_Shape& model, std::vector<FilledPart>& parts) {
    const occ::Numbering numbering(model);
    for_each_filled(parts, [&](const FilledPart& part, HoleReport& hole, const auto& new_faces) {
        std::map<int, int> numbers;  ///< as measured -> in the model
        for (std::size_t i = 0; i < new_faces.size(); ++i) {
            const TopoDS_Shape face = new_faces[i].Moved(part.before->placement);
            numbers[hole.patches[i].face] = numbering.faces.FindIndex(face);
            hole.patches[i].face = numbers[hole.patches[i].face];
        }
        for (Finding& finding : hole.verdict.findings) {
            finding.face = numbers[finding.face];
            finding.other_face = 0;  // its number there is no number in the model
        }
    });
}

}  // namespace suture::cli

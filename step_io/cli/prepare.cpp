#include "cli/prepare.h"

#include "cli/choose_holes.h"
#include "cli/what_broke.h"
#include "suture/edges/cut.h"
#include "suture/edges/grow.h"
#include "suture/occ/guard.h"
#include "suture/sew/tolerance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <TopoDS.hxx>

#include <algorithm>
#include <map>

namespace suture::cli {
namespace {

/// Every boundary's edges into one part.
Result<void> unite_parts(LoadedModel& model, const std::vector<std::vector<int>>& boundaries,
                         const std::map<int, int>& supports) {
    const occ::Numbering whole(model.whole);
    TopTools_IndexedMapOfShape chosen;
    for (const std::vector<int>& boundary : boundaries) {
        for (const int edge : boundary) {
            if (edge > whole.edges.Extent()) {
                return fail(ErrorCode::Usage, "there is no edge {}: the model has {} edges", edge,
                            whole.edges.Extent());
            }
            chosen.Add(whole.edges(edge));
        }
    }
    for (const auto& [edge, face] : supports) {
        if (face > whole.faces.Extent()) {
            return fail(ErrorCode::Usage, "there is no face {}: the model has {} faces", face,
                        whole.faces.Extent());
        }
        for (const TopoDS_Edge& side : occ::edges_of(whole.faces(face))) {
            chosen.Add(side);  // a support has to be in the same part
        }
    }
    return occ::guarded("uniting parts", [&] { model.file.unite(chosen); });
}

/// "face 12", "faces 12, 13"
std::string named(const std::vector<int>& faces) {
    return fmt::format("{} {}", faces.size() == 1 ? "face" : "faces", fmt::join(faces, ", "));
}

/// Faces of one part that are to go.
struct ChosenFaces {
    io::Part part;
    occ::Numbering numbering;  ///< the model's, of the part's own shapes
    std::vector<int> numbers;

    [[nodiscard]] std::vector<TopoDS_Face> faces() const {
        std::vector<TopoDS_Face> result;
        for (const int number : numbers) {
            result.push_back(TopoDS::Face(numbering.faces(number)));
        }
        return result;
    }
};

/// The chosen faces by the part that holds them.
Result<std::vector<ChosenFaces>> by_part(const LoadedModel& model, const std::vector<int>& faces) {
    const occ::Numbering whole(model.whole);
    for (const int face : faces) {
        if (face > whole.faces.Extent()) {
            return fail(ErrorCode::Usage, "there is no face {}: the model has {} faces", face,
                        whole.faces.Extent());
        }
        if (std::ranges::count(faces, face) > 1) {
            return fail(ErrorCode::Usage, "face {} is named twice", face);
        }
    }
    std::vector<ChosenFaces> result;
    std::size_t found = 0;
    for (io::Part& part : model.file.parts()) {
        const auto placement = occ::placement_of(part.shape, model.whole);
        if (!placement) {
            return fail(ErrorCode::Internal, "part '{}' stands nowhere in its own model",
                        part.name);
        }
        ChosenFaces chosen{std::move(part), {}, {}};
        chosen.numbering = occ::numbering_of_part(whole, chosen.part.shape, *placement);
        const occ::Numbering own(chosen.part.shape);
        for (const int face : faces) {
            if (own.faces.Contains(chosen.numbering.faces(face))) {
                chosen.numbers.push_back(face);
            }
        }
        found += chosen.numbers.size();
        if (!chosen.numbers.empty()) {
            result.push_back(std::move(chosen));
        }
    }
    if (found < faces.size()) {
        return fail(ErrorCode::Usage,
                    "one of the {} lies in another instance of its part: choose that of the first",
                    named(faces));
    }
    return result;
}

/// Takes the faces out; each wound is a boundary to be filled.
Result<void> cut_out(LoadedModel& model, const ChosenFaces& chosen, FillRequest& request) {
    auto cut = cut_faces(chosen.part.shape, chosen.faces());
    if (!cut) {
        return fail(cut.error().code, "{}: {}", named(chosen.numbers), cut.error().message);
    }
    model.file.replace(chosen.part, cut->shape, {});
    for (const std::vector<TopoDS_Edge>& wound : cut->wounds) {
        std::vector<int>& boundary = request.boundaries.emplace_back();
        for (const TopoDS_Edge& edge : wound) {
            boundary.push_back(chosen.numbering.of(edge));
        }
    }
    return {};
}

constexpr std::chrono::milliseconds kGrowLimit{120'000};

/// Lets the neighbours grow together, or else leaves a hole to be filled.
Result<void> grow(LoadedModel& model, const ChosenFaces& chosen, const Progress& progress,
                  FillRequest& request) {
    const auto grown = grow_over(chosen.part.shape, chosen.faces(), kGrowLimit, progress);
    if (!grown && grown.error().code == ErrorCode::Cancelled) {
        return tl::unexpected(grown.error());
    }
    const std::string broken =
        grown ? what_broke(chosen.part.shape, grown->shape) : grown.error().message;
    if (broken.empty()) {
        model.file.replace(chosen.part, grown->shape, grown->replaced);
        model.changes.push_back(named(chosen.numbers) + " removed, the neighbours grown together");
        return {};
    }
    model.changes.push_back(named(chosen.numbers) + " filled instead of grown over: " + broken);
    return cut_out(model, chosen, request);
}

/// A part whose chosen holes are closed by its own faces: they are filled first, for OCCT removes
/// faces, not holes.
Result<GrownShape> grow_into_holes(const PartLoops& part, FillRequest request,
                                   const Progress& progress) {
    request.progress = progress;
    request.keep_bad = true;  // the fill is removed again
    auto filled = fill_holes(part.part.shape, part.numbering, request);
    if (!filled) {
        return tl::unexpected(filled.error());
    }
    for (const HoleReport& hole : filled->holes) {
        if (hole.status == FillStatus::Refused) {
            return fail(ErrorCode::Refused, "hole {} cannot be closed for it: {}",
                        hole.ids.front() + part.ids_before, hole.reason);
        }
    }
    auto grown = grow_over(filled->shape, filled->new_faces, kGrowLimit, progress);
    if (grown) {
        if (const std::string broken = what_broke(filled->shape, grown->shape); !broken.empty()) {
            return fail(ErrorCode::Refused, "{}", broken);
        }
    }
    return grown;
}

/// Lets the neighbours of all chosen holes grow together, or leaves all of them to be filled.
Result<void> grow_over_holes(LoadedModel& model, const FillRequest& request,
                             const Progress& progress) {
    const auto parts = find_model_loops(model);
    if (!parts) {
        return tl::unexpected(parts.error());
    }
    const auto requests =
        divide_request(request, *parts, occ::Numbering(model.whole).edges.Extent());
    if (!requests) {
        return tl::unexpected(requests.error());
    }
    std::vector<GrownShape> grown;
    for (const PartRequest& wanted : *requests) {
        auto one = grow_into_holes((*parts)[wanted.part], wanted.request, progress);
        if (!one) {
            if (one.error().code == ErrorCode::Cancelled || one.error().code == ErrorCode::Usage) {
                return tl::unexpected(one.error());
            }
            model.changes.push_back("filled instead of grown over: " + one.error().message);
            return {};
        }
        grown.push_back(std::move(*one));
    }
    for (std::size_t i = 0; i < grown.size(); ++i) {
        model.file.replace((*parts)[(*requests)[i].part].part, grown[i].shape, grown[i].replaced);
    }
    model.changes.emplace_back("the neighbours of the holes have grown together");
    model.grown = true;
    return {};
}

}  // namespace

Result<void> prepare_model(Run& run, LoadedModel& model, const FillSettings& settings,
                           FillRequest& request) {
    request.boundaries = settings.request.boundaries;
    if (!request.boundaries.empty()) {
        if (auto united = unite_parts(model, request.boundaries, request.supports); !united) {
            return united;
        }
    }
    for (const auto* faces : {&settings.replace_faces, &settings.remove_faces}) {
        if (faces->empty()) {
            continue;
        }
        const auto parts = by_part(model, *faces);
        if (!parts) {
            return tl::unexpected(parts.error());
        }
        const Progress progress = run.stage(Stage::Finding, "removing faces", 0.25, 0.25);
        for (const ChosenFaces& chosen : *parts) {
            const auto done = faces == &settings.remove_faces
                                  ? grow(model, chosen, progress, request)
                                  : cut_out(model, chosen, request);
            if (!done) {
                return done;
            }
        }
    }
    model.grown = !settings.remove_faces.empty() && request.boundaries.empty();
    if (settings.grow) {
        return grow_over_holes(model, request,
                               run.stage(Stage::Finding, "growing neighbours", 0.25, 0.25));
    }
    return {};
}

double corner_reach(const LoadedModel& model, const LoadOptions& options,
                    const Tolerance& tolerance) {
    const double own = std::max(
        {model.sewing.tolerance, tolerance.linear, kLeastTolerance * occ::diagonal(model.whole)});
    return options.sew_tolerance.value_or(own);
}

}  // namespace suture::cli

#include "suture/detect/classify.h"

#include <fmt/format.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>

#include <algorithm>
#include <limits>

namespace suture {

namespace {

/// Areas decide only between factors: a hundredth is enough.
constexpr double kAreaPrecision = 1e-2;

/// A gap of more than this share of an edge beside it is what that edge bounds.
constexpr double kBridged = 0.25;

double shell_area(const ShellGraph& graph, int component) {
    double area = 0.0;
    for (std::size_t i = 0; i < graph.faces.size(); ++i) {
        if (graph.component[i] == component) {
            GProp_GProps properties;
            BRepGProp::SurfaceProperties(graph.faces[i], properties, kAreaPrecision);
            area += properties.Mass();
        }
    }
    return area;
}

/// What the edges that lie on others say; Ambiguous with a reason where a crack in its own shell
/// runs into the loop, Ambiguous without one where they say nothing.
///
/// The two long edges of a narrow hole lie as near to each other as those of a gap. The hole has
/// short edges between them, which lie on no other edge.
Verdict by_seams(const ShellGraph& graph, int component, const std::vector<EdgePartner>& partners) {
    Verdict verdict;
    double shortest = std::numeric_limits<double>::max();
    for (const EdgePartner& partner : partners) {
        if (!is_seam(partner) && !is_fold(partner)) {
            shortest = std::min(shortest, partner.length);
        }
    }
    std::size_t seams = 0;
    std::size_t cracks = 0;
    std::size_t folds = 0;
    for (const EdgePartner& partner : partners) {
        folds += is_fold(partner) ? 1 : 0;
        if (is_seam(partner) && partner.gap <= kBridged * shortest) {
            ++seams;
            cracks += graph.component[graph.uses[partner.partner].face] == component ? 1 : 0;
            verdict.gap = std::max(verdict.gap, partner.gap);
        }
    }
    if (folds == partners.size()) {
        return {LoopKind::Slit, 0.0, "its edges lie on each other and belong to one face"};
    }
    if (seams + folds >= partners.size()) {
        verdict.kind = LoopKind::Seam;
        verdict.reason =
            fmt::format("all its edges lie on edges of other faces within {:.3g}", verdict.gap);
    } else if (cracks > 0) {
        verdict.reason = fmt::format(
            "{} of its {} edges lie on edges of the same shell within {:.3g}: sew these first",
            cracks, partners.size(), verdict.gap);
    }
    return verdict;
}

Verdict by_turning(const ShellGraph& graph, const RawLoop& loop, const LoopShape& shape) {
    const double degrees_left = degrees(shape.turning);
    if (shape.turning < kHoleTurning) {
        return {LoopKind::Hole, 0.0,
                fmt::format("the shell turns {:.0f} degrees along it, a flat sheet 360: the shell "
                            "lies around it or closes up behind it",
                            degrees_left)};
    }
    const int component = graph.component[graph.uses[loop.steps.front().use].face];
    const double ratio = shell_area(graph, component) / shape.spanned_area;
    const bool sheet = ratio < kSheetArea;
    const std::string facts = fmt::format(
        "the shell turns {:.0f} degrees along it, a flat sheet 360, and has {:.3g} "
        "times the area that it spans",
        degrees_left, ratio);
    if (shape.turning > kRimTurning && sheet) {
        return {LoopKind::Rim, 0.0, facts + ": it bounds an open sheet"};
    }
    if (shape.turning <= kRimTurning && !sheet) {
        return {LoopKind::Hole, 0.0, facts + ": a body with an opening"};
    }
    return {LoopKind::Ambiguous, 0.0, facts};
}

}  // namespace

std::string_view to_string(LoopKind kind) {
    switch (kind) {
        case LoopKind::Hole:
            return "hole";
        case LoopKind::Rim:
            return "rim";
        case LoopKind::Seam:
            return "seam";
        case LoopKind::Slit:
            return "slit";
        case LoopKind::Ambiguous:
            return "ambiguous";
    }
    return "ambiguous";
}

Verdict classify_loop(const ShellGraph& graph, const RawLoop& loop, const LoopShape& shape,
                      const std::vector<EdgePartner>& partners) {
    const int component = graph.component[graph.uses[loop.steps.front().use].face];
    const bool only_free =
        std::all_of(loop.steps.begin(), loop.steps.end(),
                    [&graph](const LoopStep& step) { return graph.uses[step.use].free; });
    if (!loop.closed) {
        return {LoopKind::Ambiguous, 0.0, "its edges share no vertex where it should go on"};
    }
    if (!only_free) {
        return {LoopKind::Ambiguous, 0.0,
                "it runs along an edge that an odd number of faces share, or along half a seam"};
    }
    Verdict verdict = by_seams(graph, component, partners);
    if (verdict.kind != LoopKind::Ambiguous || !verdict.reason.empty()) {
        return verdict;
    }
    if (!graph.orientable[component]) {
        return {LoopKind::Ambiguous, 0.0, "its shell has only one side, like a Moebius band"};
    }
    verdict = by_turning(graph, loop, shape);
    if (verdict.kind != LoopKind::Hole &&
        graph.solid[graph.uses[loop.steps.front().use].face] >= 0) {
        verdict.kind = LoopKind::Hole;
        verdict.reason += "; but the file says that its shell bounds a solid";
    }
    const auto touching = std::count_if(partners.begin(), partners.end(), is_seam);
    if (touching > 0) {
        verdict.reason += fmt::format("; {} of its edges lie on another shell", touching);
    }
    const auto turned = std::count_if(loop.steps.begin(), loop.steps.end(),
                                      [](const LoopStep& step) { return step.along_use; });
    if (turned > 0) {
        verdict.reason += fmt::format(
            "; the file turns the faces of {} of its edges against the rest of the shell", turned);
    }
    return verdict;
}

}  // namespace suture

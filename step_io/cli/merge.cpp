#include "cli/merge.h"

#include "cli/table.h"
#include "cli/what_broke.h"
#include "suture/edges/grow.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <fmt/format.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <span>

namespace suture::cli {
namespace {

constexpr std::chrono::milliseconds kMergeLimit{120'000};

/// Faces that become one have the area of both, but for what integrating it costs.
constexpr double kSameArea = 1e-6;

double area_of(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    return properties.Mass();
}

/// Why the merged shape cannot take the place of the other; empty if it can.
Result<std::string> why_not(const TopoDS_Shape& before, const TopoDS_Shape& after) {
    return occ::guarded("measuring the merged faces", [&]() -> std::string {
        const double was = area_of(before);
        const double is = area_of(after);
        if (std::abs(is - was) > kSameArea * was) {
            return fmt::format("the area would change from {:.9g} to {:.9g}", was, is);
        }
        return what_broke(before, after);
    });
}

/// Which of the new faces are one with others now: the notes of their holes say so.
void note_merged(const GrownShape& merged, const TopoDS_Shape& before, FillOutcome& outcome) {
    const occ::Numbering old(before);
    std::span<TopoDS_Face> faces(outcome.new_faces);
    for (HoleReport& hole : outcome.holes) {
        if (hole.status != FillStatus::Filled) {
            continue;
        }
        for (TopoDS_Face& face : faces.first(hole.patches.size())) {
            const TopoDS_Shape image = merged.replaced.IsBound(face) ? merged.replaced(face) : face;
            int others = 0;
            for (int i = 1; i <= old.faces.Extent(); ++i) {
                const TopoDS_Shape& other = old.faces(i);
                others += !other.IsSame(face) && merged.replaced.IsBound(other) &&
                                  merged.replaced(other).IsSame(image)
                              ? 1
                              : 0;
            }
            if (others > 0) {
                hole.notes.push_back(
                    fmt::format("the new face has become one with {}", counted(others, "other")));
            }
            face = TopoDS::Face(image);
        }
        faces = faces.subspan(hole.patches.size());
    }
}

}  // namespace

Result<MergeOutcome> merge_new_faces(LoadedModel& model, std::vector<FilledPart>& parts,
                                     const Progress& progress) {
    MergeOutcome result;
    for (FilledPart& part : parts) {
        FillOutcome& outcome = part.outcome;
        if (outcome.new_faces.empty()) {
            continue;
        }
        auto merged =
            merge_with_neighbours(outcome.shape, outcome.new_faces, kMergeLimit, progress);
        if (!merged && merged.error().code == ErrorCode::Cancelled) {
            return tl::unexpected(merged.error());
        }
        const auto count = [](const TopoDS_Shape& shape) {
            return static_cast<int>(occ::faces_of(shape).size());
        };
        if (!merged) {
            result.said.push_back("not merged: " + merged.error().message);
            continue;
        }
        const int fewer = count(outcome.shape) - count(merged->shape);
        if (fewer <= 0) {
            result.said.emplace_back(
                "not merged: no new face lies on one surface with a neighbour");
            continue;
        }
        const auto reason = why_not(outcome.shape, merged->shape);
        if (!reason || !reason->empty()) {
            result.said.push_back("not merged: " + (reason ? *reason : reason.error().message));
            continue;
        }
        const TopoDS_Shape before = outcome.shape;
        model.file.replace(part.before->part, merged->shape, merged->replaced);
        note_merged(*merged, before, outcome);
        outcome.shape = merged->shape;
        result.merged = true;
        result.said.push_back(
            fmt::format("new faces and their neighbours on the same surface have "
                        "become one: {} fewer",
                        counted(fewer, "face")));
    }
    return result;
}

}  // namespace suture::cli

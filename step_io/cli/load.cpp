#include "cli/load.h"

#include "cli/console.h"
#include "cli/table.h"
#include "suture/detect/find_loops.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

namespace suture::cli {
namespace {

/// How the time of loading divides into reading and sewing, roughly.
constexpr double kReadingShare = 0.8;

Result<void> sew(LoadedModel& model, double tolerance) {
    model.file.merge_loose();
    for (const io::Part& part : model.file.parts()) {
        const Result<SewnShape> sewn = sew_shape(part.shape, tolerance);
        if (!sewn) {
            return tl::unexpected(sewn.error());
        }
        SewingFacts& facts = model.sewing;
        facts.left.insert(facts.left.end(), sewn->left.begin(), sewn->left.end());
        if (!sewn->changed) {
            continue;
        }
        facts.changed = true;
        facts.loose_faces += sewn->loose_faces;
        facts.sewn_edges += sewn->sewn_edges;
        facts.walls += sewn->walls;
        facts.free_edges_before += sewn->free_edges_before;
        facts.free_edges_after += sewn->free_edges_after;
        facts.tolerance = std::max(facts.tolerance, sewn->tolerance);
        facts.largest_gap = std::max(facts.largest_gap, sewn->largest_gap);
        model.file.replace(part, sewn->shape, sewn->replaced);
        spdlog::info("sewed {} edges of '{}' at {:g} mm", sewn->sewn_edges, part.name,
                     sewn->tolerance);
    }
    return {};
}

}  // namespace

std::string text_of(const SewingFacts& sewing) {
    std::string text;
    if (sewing.sewn_edges > 0) {
        text = fmt::format("{} sewn at {} mm",
                           sewing.loose_faces > 0 ? counted(sewing.loose_faces, "loose face")
                                                  : counted(sewing.sewn_edges, "edge"),
                           short_number(sewing.tolerance));
    }
    if (sewing.walls > 0) {
        text += fmt::format("{}{} given to both bodies", text.empty() ? "" : ", ",
                            counted(sewing.walls, "inner wall"));
    }
    return text.empty() ? "edges shorter than the model is good for made points" : text;
}

std::vector<std::string> notes_of(const SewingFacts& sewing) {
    constexpr std::size_t kMost = 3;
    std::vector<LeftOpen> left = sewing.left;
    std::sort(left.begin(), left.end(),
              [](const LeftOpen& a, const LeftOpen& b) { return a.gap > b.gap; });
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < std::min(kMost, left.size()); ++i) {
        notes.push_back(fmt::format("not sewn: an edge of {} mm, {} mm from others: {}",
                                    short_number(left[i].length), short_number(left[i].gap),
                                    left[i].reason));
    }
    if (left.size() > kMost) {
        notes.push_back(fmt::format("not sewn: {} more",
                                    counted(static_cast<int>(left.size() - kMost), "edge")));
    }
    return notes;
}

Result<LoadedModel> load_model(Run& run, const std::filesystem::path& file,
                               const LoadOptions& options, double to) {
    const Stopwatch reading;
    const Progress progress =
        run.stage(Stage::Reading, "reading " + file.filename().string(), 0.0, to * kReadingShare);
    Result<io::ModelFile> read = io::read_model(file, progress, options.content);
    if (!read) {
        return tl::unexpected(read.error());
    }
    LoadedModel model;
    model.file = std::move(*read);
    run.lack(model.file.missing_files);
    model.seconds_read = reading.seconds();
    for (const std::string& note : model.file.notes) {
        print_warning(note);
    }
    spdlog::info("read {} in {:.2f} s", file.string(), model.seconds_read);
    if (options.sew) {
        const Stopwatch sewing;
        const Progress sewing_progress =
            run.stage(Stage::Finding, "sewing", to * kReadingShare, to);
        const Result<void> sewn = sew(model, options.sew_tolerance.value_or(0.0));
        if (!sewn) {
            return tl::unexpected(sewn.error());
        }
        model.seconds_sew = sewing.seconds();
    }
    model.whole = model.file.shape();
    return model;
}

Result<std::vector<PartLoops>> find_model_loops(const LoadedModel& model) {
    const occ::Numbering whole(model.whole);
    const TopoDS_Shape now = model.file.shape();
    std::vector<PartLoops> result;
    int ids = 0;
    for (io::Part& part : model.file.parts()) {
        const auto placement = occ::placement_of(part.shape, now);
        if (!placement) {
            return fail(ErrorCode::Internal, "part '{}' stands nowhere in its own model",
                        part.name);
        }
        PartLoops found{std::move(part), *placement, {}, {}, ids};
        found.numbering = occ::numbering_of_part(whole, found.part.shape, *placement);
        Result<std::vector<BoundaryLoop>> loops = find_loops(found.part.shape, found.numbering);
        if (!loops) {
            return tl::unexpected(loops.error());
        }
        found.loops = std::move(*loops);
        for (BoundaryLoop& loop : found.loops) {
            loop.id += found.ids_before;
            for (int& other : loop.islands_with) {
                other += found.ids_before;
            }
        }
        ids += static_cast<int>(found.loops.size());
        result.push_back(std::move(found));
    }
    return result;
}

}  // namespace suture::cli

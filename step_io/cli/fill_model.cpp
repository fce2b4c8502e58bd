#include "cli/fill_model.h"

#include "cli/choose_holes.h"
#include "cli/merge.h"
#include "cli/placed_point.h"
#include "cli/points_on_edges.h"
#include "cli/prepare.h"
#include "cli/remeasure.h"
#include "cli/reread.h"
#include "cli/spoilt_fills.h"
#include "cli/what_broke.h"
#include "files/stated_accuracy.h"
#include "suture/flow/compute.h"
#include "suture/flow/plan.h"
#include "suture/judge/judge_fill.h"
#include "suture/occ/convert.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>

namespace suture::cli {
namespace {

/// How a run divides into stages, for the progress shown.
constexpr double kLoaded = 0.25;
constexpr double kFound = 0.3;
constexpr double kFilled = 0.7;
constexpr double kWritten = 0.8;
constexpr double kReread = 0.95;

/// Loops of parts in which nothing is filled.
void report_skipped(const PartLoops& part, const FillRequest& request,
                    std::vector<HoleReport>& holes) {
    for (const BoundaryLoop& loop : part.loops) {
        HoleReport report;
        report.ids = {loop.id};
        report.method_requested = request.method;
        report.reason = loop.kind == LoopKind::Hole ? "not asked for" : loop.reason;
        holes.push_back(std::move(report));
    }
}

/// Ids and places are those of the part until now.
void place_in_model(HoleReport& hole, const PartLoops& part) {
    for (int& id : hole.ids) {
        id += part.ids_before;
    }
    hole.asked.hole += part.ids_before;
    for (Finding& finding : hole.verdict.findings) {
        finding.hole += part.ids_before;
        if (!finding.at.isZero()) {
            finding.at = occ::from_occ(
                occ::to_point(finding.at).Transformed(part.placement.Transformation()));
        }
    }
}

class FillJob {
  public:
    FillJob(Run& run, const FillSettings& settings, LoadedModel model)
        : run_(run), settings_(settings), model_(std::move(model)) {
        summary_.seconds.read = model_.seconds_read;
        summary_.seconds.sew = model_.seconds_sew;
    }

    Result<FillSummary> run() && {
        for (const auto step :
             {&FillJob::find, &FillJob::fill, &FillJob::deliver, &FillJob::merge}) {
            const Result<void> done = (this->*step)();
            if (!done) {
                validity_.wait();
                return tl::unexpected(done.error());
            }
        }
        finish();
        return std::move(summary_);
    }

  private:
    Result<void> find() {
        const Stopwatch watch;
        const Progress progress = run_.stage(Stage::Finding, "finding holes", kLoaded, kFound);
        Result<std::vector<PartLoops>> parts = find_model_loops(model_);
        if (!parts) {
            return tl::unexpected(parts.error());
        }
        parts_ = std::move(*parts);
        summary_.changes = model_.changes;
        if (model_.grown) {
            return {};  // the neighbours have grown together: nothing is to be filled
        }
        const int edges = occ::Numbering(model_.whole).edges.Extent();
        FillRequest request = settings_.request;
        if (!settings_.filter.empty()) {
            auto holes = holes_like(settings_.filter, request, parts_);
            if (!holes) {
                return tl::unexpected(holes.error());
            }
            request.holes = std::move(*holes);
        }
        Result<std::vector<PartRequest>> requests = divide_request(request, parts_, edges);
        summary_.seconds.detect = watch.seconds();
        if (requests) {
            requests_ = std::move(*requests);
            place_options();
            if (auto placed = place_splits(); !placed) {
                return placed;
            }
            return pass_through();
        }
        // A model that only needed sewing is done; it is written below.
        const bool done = model_.sewing.changed && requests.error().code == ErrorCode::NothingToDo;
        if (!done) {
            return tl::unexpected(requests.error());
        }
        summary_.other_loops = what_else(parts_);
        return {};
    }

    /// Positions and directions among the method's options are given in the model too.
    void place_options() {
        for (PartRequest& wanted : requests_) {
            const gp_Trsf to_part = parts_[wanted.part].placement.Inverted().Transformation();
            for (auto& [key, value] : wanted.request.options) {
                gp_XYZ moved;
                if (value.kind == OptionKind::Position) {
                    moved = gp_Pnt(value.numbers[0], value.numbers[1], value.numbers[2])
                                .Transformed(to_part)
                                .XYZ();
                } else if (value.kind == OptionKind::Direction) {
                    moved = gp_Vec(value.numbers[0], value.numbers[1], value.numbers[2])
                                .Transformed(to_part)
                                .XYZ();
                } else {
                    continue;
                }
                value.numbers = {moved.X(), moved.Y(), moved.Z()};
            }
        }
    }

    /// Vertices are numbered in the model; a pair is asked of the part that has both.
    Result<void> place_splits() {
        TopTools_IndexedMapOfShape vertices;
        TopExp::MapShapes(model_.whole, TopAbs_VERTEX, vertices);
        for (const auto& [one, other] : settings_.splits) {
            if (std::max(one, other) > vertices.Extent()) {
                return fail(ErrorCode::Usage, "there is no vertex {}: the model has {} vertices",
                            std::max(one, other), vertices.Extent());
            }
            for (PartRequest& wanted : requests_) {
                const TopLoc_Location& placement = parts_[wanted.part].placement;
                const auto in_part = [&](int number) {
                    return occ::from_occ(BRep_Tool::Pnt(TopoDS::Vertex(vertices(number)))
                                             .Transformed(placement.Inverted().Transformation()));
                };
                wanted.request.splits.emplace_back(in_part(one), in_part(other));
            }
        }
        if (!settings_.splits.empty() && requests_.size() > 1) {
            return fail(ErrorCode::Usage,
                        "--split with vertices is for holes of one part, and {} parts have holes: "
                        "choose them with --hole",
                        requests_.size());
        }
        return {};
    }

    /// Points are given in the model; the one part with the hole has coordinates of its own.
    Result<void> pass_through() {
        Result<std::vector<ThroughPoint>> points = points_on_edges(
            model_.whole, settings_.through_edges, settings_.request.tolerance.linear);
        if (!points) {
            return tl::unexpected(points.error());
        }
        points->insert(points->end(), settings_.request.through.begin(),
                       settings_.request.through.end());
        if (!points->empty() && requests_.size() != 1) {
            return fail(ErrorCode::Usage,
                        "points to pass through belong to one hole, but {} parts have holes: "
                        "choose it with --hole",
                        requests_.size());
        }
        for (PartRequest& wanted : requests_) {
            const gp_Trsf to_part = parts_[wanted.part].placement.Inverted().Transformation();
            wanted.request.through.clear();
            for (const ThroughPoint& point : *points) {
                wanted.request.through.push_back(placed(point, to_part));
            }
        }
        return {};
    }

    /// What is to be put into one part.
    struct ComputedPart {
        FillPlan plan;
        std::vector<ComputedFill> fills;
    };

    static Result<ComputedPart> compute(const PartLoops& part, const FillRequest& request) {
        auto plan = plan_fills(part.part.shape, part.numbering, request);
        if (!plan) {
            return tl::unexpected(plan.error());
        }
        auto fills = compute_fills(part.part.shape, *plan, request);
        if (!fills) {
            return tl::unexpected(fills.error());
        }
        return ComputedPart{std::move(*plan), std::move(*fills)};
    }

    /// Plans and computes for all parts at once; none is changed.
    std::vector<Result<ComputedPart>> compute_parts() {
        const Progress all = run_.stage(Stage::Filling, "filling holes", kFound, kFilled);
        std::mutex reporting;
        std::vector<double> fractions(requests_.size(), 0.0);
        std::vector<Result<ComputedPart>> computed(requests_.size());
        tbb::parallel_for(std::size_t{0}, requests_.size(), [&](std::size_t i) {
            PartRequest& wanted = requests_[i];
            const PartLoops& part = parts_[wanted.part];
            for (int& id : wanted.request.leave_open) {
                id -= part.ids_before;
            }
            std::map<int, std::vector<std::string>> spoilt;
            for (auto& [id, methods] : wanted.request.spoilt) {
                spoilt[id - part.ids_before] = std::move(methods);
            }
            wanted.request.spoilt = std::move(spoilt);
            wanted.request.progress.cancel = all.cancel;
            wanted.request.progress.report = [&, i](double fraction, std::string_view what) {
                const std::lock_guard lock(reporting);
                fractions[i] = fraction;
                all(std::accumulate(fractions.begin(), fractions.end(), 0.0) /
                        static_cast<double>(fractions.size()),
                    what);
            };
            computed[i] = compute(part, wanted.request);
        });
        return computed;
    }

    Result<void> fill() {
        const Stopwatch watch;
        std::vector<Result<ComputedPart>> computed = compute_parts();
        for (std::size_t i = 0; i < requests_.size(); ++i) {
            const PartLoops& part = parts_[requests_[i].part];
            if (!computed[i]) {
                return tl::unexpected(computed[i].error());
            }
            Result<FillOutcome> outcome =
                apply_fills(part.part.shape, std::move(computed[i]->fills));
            if (!outcome) {
                return tl::unexpected(outcome.error());
            }
            const std::vector<HoleReport>& skipped = computed[i]->plan.skipped;
            outcome->holes.insert(outcome->holes.end(), skipped.begin(), skipped.end());
            for (HoleReport& hole : outcome->holes) {
                place_in_model(hole, part);
            }
            for (HoleForm& form : outcome->forms) {
                form.hole += part.ids_before;
                summary_.forms.push_back(std::move(form));
            }
            summary_.seconds.fill += outcome->seconds_fill;
            summary_.seconds.choose += outcome->seconds_choose;
            summary_.seconds.sew += outcome->seconds_sew;
            model_.file.replace(part.part, outcome->shape, {});
            adopt_looks(part.part, *outcome);
            filled_.push_back({&part, std::move(*outcome)});
        }
        summary_.seconds.fill_step = watch.seconds();
        return {};
    }

    /// Every hole for itself: neighbours of different holes need not look alike.
    void adopt_looks(const io::Part& part, const FillOutcome& outcome) {
        std::span<const TopoDS_Face> faces(outcome.new_faces);
        for (const HoleReport& hole : outcome.holes) {
            if (hole.status == FillStatus::Filled) {
                model_.file.adopt_looks(part, faces.first(hole.patches.size()));
                faces = faces.subspan(hole.patches.size());
            }
        }
    }

    /// Writes and reads back; what the file spoils is not done, even within tolerance.
    Result<void> deliver() {
        std::vector<HoleReport> memory;
        std::vector<TopoDS_Face> new_faces;
        for (const FilledPart& part : filled_) {
            memory.insert(memory.end(), part.outcome.holes.begin(), part.outcome.holes.end());
            new_faces.insert(new_faces.end(), part.outcome.new_faces.begin(),
                             part.outcome.new_faces.end());
        }
        reread_.emplace(filled_);
        const auto write_and_compare = [&](double accuracy) {
            auto report = memory.begin();
            for_each_hole([&](HoleReport& hole) { hole = *report++; });
            model_.file.precision = accuracy;
            return write().map([&] {
                std::vector<HoleReport> file;
                for_each_hole([&](const HoleReport& hole) { file.push_back(hole); });
                return lost_by_writing(memory, file);
            });
        };
        return write_with_least_loss(accuracies(new_faces), write_and_compare)
            .map([&](std::vector<WritingLoss>&& losses) {
                for (const WritingLoss& loss : losses) {
                    for_each_hole([&](HoleReport& hole) {
                        if (hole.ids == loss.hole) {
                            add_finding(finding_of(loss), hole.verdict);
                        }
                    });
                }
                summary_.lost_by_writing = std::move(losses);
            });
    }

    /// Only STEP and IGES state one.
    [[nodiscard]] std::vector<double> accuracies(const std::vector<TopoDS_Face>& new_faces) const {
        const bool stated =
            settings_.format == io::Format::Step || settings_.format == io::Format::Iges;
        return stated && !new_faces.empty()
                   ? io::accuracies_to_state(model_.file.precision, new_faces)
                   : std::vector{model_.file.precision};
    }

    template <class Action>
    void for_each_hole(Action&& action) {
        for (FilledPart& part : filled_) {
            for (HoleReport& hole : part.outcome.holes) {
                action(hole);
            }
        }
    }

    /// Measures what is written before it takes the place of an old output.
    Result<void> write() {
        const Stopwatch watch;
        const double checked_before = summary_.seconds.check;
        const Progress progress = run_.stage(
            Stage::Writing, "writing " + settings_.output.filename().string(), kFilled, kWritten);
        // OCCT writes and reads on one core: the others look at the shape meanwhile, once.
        if (!std::exchange(looking_, true) &&
            (settings_.format == io::Format::Step || io::is_mesh(settings_.format))) {
            validity_.run(
                [&] { in_memory_ = measure_validity(model_.file.shape(), ValidityDepth::Valid); });
        }
        const auto written = io::write_model(
            model_.file, settings_.output, settings_.format, settings_.mesh, reread_->faces(),
            [&](const std::filesystem::path& file, const std::vector<io::StepId>& entities) {
                return measure(file, entities);
            });
        summary_.seconds.write += watch.seconds() - (summary_.seconds.check - checked_before);
        return written ? Result<void>() : tl::unexpected(written.error());
    }

    /// The figures of the holes are those of the faces as they were made, which no longer have
    /// their own edges then; the file that holds the merged ones is read again as a whole.
    Result<void> merge() {
        if (!settings_.merge) {
            return {};
        }
        const Progress progress = run_.stage(Stage::Writing, "merging faces", kReread, 1.0);
        const TopoDS_Shape before = model_.file.shape();
        auto merged = merge_new_faces(model_, filled_, progress);
        if (!merged) {
            return tl::unexpected(merged.error());
        }
        summary_.changes.insert(summary_.changes.end(), merged->said.begin(), merged->said.end());
        if (!merged->merged) {
            return {};
        }
        const auto verify = [&](const std::filesystem::path& file,
                                const std::vector<io::StepId>&) -> Result<void> {
            if (io::is_mesh(settings_.format)) {
                return {};
            }
            const auto again = io::read_again(file, settings_.output, progress);
            if (!again) {
                return tl::unexpected(again.error());
            }
            if (const std::string broken = what_broke(before, again->shape()); !broken.empty()) {
                return fail(ErrorCode::Internal,
                            "the merged faces do not survive the file, which has them as they "
                            "were: {}",
                            broken);
            }
            summary_.validity = measure_validity(again->shape(), ValidityDepth::Valid);
            return {};
        };
        const auto written = io::write_model(model_.file, settings_.output, settings_.format,
                                             settings_.mesh, {}, verify);
        if (!written) {
            return tl::unexpected(written.error());
        }
        number_new_faces(model_.file.shape(), filled_);
        return {};
    }

    /// Input  file, entities: as io::Verify has them.
    Result<void> measure(const std::filesystem::path& file,
                         const std::vector<io::StepId>& entities) {
        const Stopwatch watch;
        const Result<TopoDS_Shape> shape = shape_to_measure(file, entities);
        if (!shape) {
            return tl::unexpected(shape.error());
        }
        summary_.seconds.reread += watch.seconds();
        const Progress progress = run_.stage(Stage::Checking, "measuring the result", kReread, 1.0);
        Result<void> measured =
            remeasure(*shape, filled_, settings_.request.tolerance, progress).map([&] {
                if (summary_.measured_on == MeasuredOn::NewFaces) {
                    number_new_faces(model_.file.shape(), filled_);
                }
            });
        validity_.wait();
        summary_.validity = in_memory_;
        if (summary_.measured_on == MeasuredOn::File) {
            summary_.validity = measure_validity(*shape, ValidityDepth::Valid);
        } else if (summary_.measured_on == MeasuredOn::NewFaces) {
            add_problems(measure_validity(*shape, ValidityDepth::Valid));
        }
        summary_.seconds.check += watch.seconds();
        return measured;
    }

    /// The output as the next program will read it: of STEP the new faces and what they meet, since
    /// reading a large file costs more than all the rest; the whole file where these cannot be told
    /// from it.
    Result<TopoDS_Shape> shape_to_measure(const std::filesystem::path& file,
                                          const std::vector<io::StepId>& entities) {
        if (io::is_mesh(settings_.format)) {
            return model_.file.shape();
        }
        const Progress reading = run_.stage(
            Stage::Checking, "reading " + settings_.output.filename().string() + " again", kWritten,
            kReread);
        if (settings_.format == io::Format::Step && !reread_->faces().empty()) {
            Result<TopoDS_Shape> faces = reread_->read(file, entities, model_.file);
            if (faces) {
                summary_.measured_on = MeasuredOn::NewFaces;
                return faces;
            }
            spdlog::info("reading the whole output again: {}", faces.error().message);
        }
        const Result<io::ModelFile> again = io::read_again(file, settings_.output, reading);
        if (!again) {
            return tl::unexpected(again.error());
        }
        summary_.measured_on = MeasuredOn::File;
        return again->shape();
    }

    /// What became of the new faces by writing and reading counts as well.
    void add_problems(const Validity& read_again) {
        summary_.validity.valid = summary_.validity.valid && read_again.valid;
        for (const std::string& problem : read_again.problems) {
            summary_.validity.problems.push_back(
                "the new faces and their neighbours, read again: " + problem);
        }
    }

    void finish() {
        for (const PartLoops& part : parts_) {
            const auto filled =
                std::find_if(filled_.begin(), filled_.end(),
                             [&](const FilledPart& other) { return other.before == &part; });
            if (filled == filled_.end()) {
                report_skipped(part, settings_.request, summary_.holes);
                continue;
            }
            for (HoleReport& hole : filled->outcome.holes) {
                summary_.holes.push_back(std::move(hole));
            }
            summary_.new_faces.insert(summary_.new_faces.end(), filled->outcome.new_faces.begin(),
                                      filled->outcome.new_faces.end());
        }
        summary_.before = model_.whole;
        for (const HoleReport& hole : summary_.holes) {
            summary_.sides.push_back(sides_of(hole));
        }
        judge_validity();
        summary_.sewing = model_.sewing;
        summary_.file = std::move(model_.file);
    }

    /// A shape is not valid because of tolerances that grew, and what the input had wrong is not
    /// the fill's fault.
    void judge_validity() {
        Validity& validity = summary_.validity;
        for (const HoleReport& hole : summary_.holes) {
            for (const Finding& finding : hole.verdict.findings) {
                if (hole.status == FillStatus::Filled && !finding.before &&
                    finding.kind == FindingKind::ToleranceGrown) {
                    validity.valid = false;
                    validity.problems.push_back(to_text(finding));
                }
            }
        }
        if (!validity.valid) {
            const Validity before = measure_validity(summary_.before, ValidityDepth::Valid);
            summary_.findings.push_back(judge_problems(validity.problems, before.problems));
        }
    }

    [[nodiscard]] int sides_of(const HoleReport& hole) const {
        if (!hole.sides.empty()) {
            return static_cast<int>(hole.sides.size());
        }
        std::size_t sides = 0;
        for (const PartLoops& part : parts_) {
            for (const BoundaryLoop& loop : part.loops) {
                const bool own =
                    std::find(hole.ids.begin(), hole.ids.end(), loop.id) != hole.ids.end();
                sides += own ? loop.edges.size() : 0;
            }
        }
        return static_cast<int>(sides);
    }

    Run& run_;
    const FillSettings& settings_;
    LoadedModel model_;
    std::vector<PartLoops> parts_;
    std::vector<PartRequest> requests_;
    std::vector<FilledPart> filled_;
    std::optional<RereadFaces> reread_;
    FillSummary summary_;
    bool looking_ = false;  ///< whether validity_ runs, or has run
    Validity in_memory_;
    tbb::task_group validity_;  ///< sets in_memory_
};

}  // namespace

Result<FillSummary> fill_model(Run& run, const FillSettings& settings) {
    FillSettings again = settings;
    SpoiltFills spoilt(settings.request);
    for (;;) {
        Result<LoadedModel> model = load_model(run, settings.input, settings.load, kLoaded);
        if (!model) {
            return tl::unexpected(model.error());
        }
        if (auto prepared = prepare_model(run, *model, settings, again.request); !prepared) {
            return tl::unexpected(prepared.error());
        }
        again.request.reach = corner_reach(*model, settings.load, settings.request.tolerance);
        Result<FillSummary> summary = FillJob(run, again, std::move(*model)).run();
        if (!summary || settings.request.keep_bad) {
            return summary;
        }
        if (!spoilt.take(*summary, again.request)) {
            spoilt.put_back(summary->holes);
            return summary;
        }
    }
}

}  // namespace suture::cli

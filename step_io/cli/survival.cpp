#include "cli/survival.h"

#include "cli/table.h"
#include "suture/base/contract.h"
#include "suture/base/tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suture::cli {
namespace {

/// What may become of a figure by writing and reading.
constexpr double kGrowth = 1.5;
constexpr double kRounding = 1e-6;

/// Not <=: a figure that is not a number is worse.
bool survives(double memory, double file) {
    return file <= std::max(kGrowth * memory, memory + kRounding);
}

/// By how many times the worst figure grew; infinite where a face or a side was not found again.
double worst_growth(const std::vector<WritingLoss>& losses) {
    double worst = 0.0;
    for (const WritingLoss& loss : losses) {
        const bool figure =
            loss.kind == WritingLoss::Kind::Gap || loss.kind == WritingLoss::Kind::Angle;
        worst = std::max(worst, figure && std::isfinite(loss.file)
                                    ? loss.file / std::max(loss.memory, kRounding)
                                    : std::numeric_limits<double>::infinity());
    }
    return worst;
}

}  // namespace

std::vector<WritingLoss> lost_by_writing(std::span<const HoleReport> memory,
                                         std::span<const HoleReport> file) {
    SUTURE_EXPECTS(memory.size() == file.size());
    std::vector<WritingLoss> losses;
    for (std::size_t i = 0; i < memory.size(); ++i) {
        const HoleReport& was = memory[i];
        const HoleReport& is = file[i];
        if (was.status != FillStatus::Filled) {
            continue;
        }
        const auto lose = [&](WritingLoss::Kind kind, double in_memory, double in_file) {
            losses.push_back({was.ids, kind, in_memory, in_file});
        };
        const auto faces =
            std::ranges::count_if(is.patches, [](const PatchFacts& p) { return p.face == 0; });
        if (faces > 0) {
            lose(WritingLoss::Kind::Face, static_cast<double>(is.patches.size()),
                 static_cast<double>(faces));
        }
        const auto sides =
            std::ranges::count_if(is.sides, [](const SideReport& s) { return std::isnan(s.gap); });
        if (sides > 0) {
            lose(WritingLoss::Kind::Side, static_cast<double>(is.sides.size()),
                 static_cast<double>(sides));
        }
        if (!survives(was.max_gap, is.max_gap)) {
            lose(WritingLoss::Kind::Gap, was.max_gap, is.max_gap);
        }
        if (!survives(was.max_angle, is.max_angle)) {
            lose(WritingLoss::Kind::Angle, was.max_angle, is.max_angle);
        }
    }
    return losses;
}

Result<std::vector<WritingLoss>> write_with_least_loss(
    const std::vector<double>& accuracies,
    const std::function<Result<std::vector<WritingLoss>>(double)>& write) {
    SUTURE_EXPECTS(!accuracies.empty());
    std::vector<double> growths;
    Result<std::vector<WritingLoss>> losses;
    for (const double accuracy : accuracies) {
        losses = write(accuracy);
        if (!losses || losses->empty()) {
            return losses;
        }
        growths.push_back(worst_growth(*losses));
    }
    const auto best = std::ranges::min_element(growths) - growths.begin();
    const bool is_last = static_cast<std::size_t>(best) + 1 == growths.size();
    return is_last ? losses : write(accuracies[static_cast<std::size_t>(best)]);
}

std::string to_string(const WritingLoss& loss) {
    switch (loss.kind) {
        case WritingLoss::Kind::Face:
            return fmt::format("{:g} of {:g} new faces were not found again in the file", loss.file,
                               loss.memory);
        case WritingLoss::Kind::Side:
            return fmt::format("{:g} of {:g} sides were not found again in the file", loss.file,
                               loss.memory);
        case WritingLoss::Kind::Gap:
            return fmt::format("the largest gap is {} mm in the file, {} mm in memory",
                               short_number(loss.file), short_number(loss.memory));
        case WritingLoss::Kind::Angle:
            break;
    }
    return fmt::format("the largest angle is {} deg in the file, {} deg in memory",
                       short_number(degrees(loss.file)), short_number(degrees(loss.memory)));
}

Finding finding_of(const WritingLoss& loss) {
    Finding finding;
    finding.kind = FindingKind::ChangedByWriting;
    finding.severity = Severity::Poor;
    finding.hole = loss.hole.front();
    finding.value = loss.file / std::max(loss.memory, kRounding);
    finding.limit = kGrowth;
    finding.detail = to_string(loss);
    return finding;
}

}  // namespace suture::cli

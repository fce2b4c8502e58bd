#include "cli/spoilt_fills.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace suture::cli {
namespace {

/// Fills of one hole that are written, at most.
constexpr std::size_t kMostTried = 3;

bool is_lost(const FillSummary& summary, const HoleReport& hole) {
    return std::any_of(summary.lost_by_writing.begin(), summary.lost_by_writing.end(),
                       [&](const WritingLoss& loss) { return loss.hole == hole.ids; });
}

bool is_bad(const HoleReport& hole) {
    return hole.verdict.severity == Severity::Bad;
}

/// The better first.
std::pair<bool, double> rank_of(const HoleReport& hole) {
    return {is_bad(hole), hole.verdict.score};
}

std::vector<HoleReport>::const_iterator best_of(const std::vector<HoleReport>& tried) {
    return std::min_element(
        tried.begin(), tried.end(),
        [](const HoleReport& a, const HoleReport& b) { return rank_of(a) < rank_of(b); });
}

}  // namespace

SpoiltFills::SpoiltFills(const FillRequest& request) : automatic_(request.method == "auto") {}

/// True where that needs another run.
bool SpoiltFills::settle(Spoilt& hole, bool filled) const {
    hole.settled = true;
    const auto best = best_of(hole.tried);
    hole.open = is_bad(*best);
    return hole.open || !filled || best + 1 != hole.tried.end();
}

bool SpoiltFills::take(const FillSummary& summary, FillRequest& request) {
    bool again = false;
    for (const HoleReport& report : summary.holes) {
        const int id = report.ids.front();
        const bool filled = report.status == FillStatus::Filled;
        const bool spoilt = filled && (is_bad(report) || is_lost(summary, report));
        if (!spoilt && !holes_.contains(id)) {
            continue;
        }
        Spoilt& hole = holes_[id];
        if (hole.settled) {
            continue;
        }
        if (!spoilt && filled) {
            hole.settled = hole.well = true;
            continue;
        }
        if (spoilt) {
            hole.tried.push_back(report);
        }
        const bool go_on = spoilt && automatic_ && hole.tried.size() < kMostTried;
        again = (go_on || settle(hole, filled)) || again;
    }
    request.spoilt.clear();
    request.leave_open.clear();
    for (const auto& [id, hole] : holes_) {
        if (hole.open) {
            request.leave_open.push_back(id);
            continue;
        }
        const auto last = hole.settled && !hole.well ? best_of(hole.tried) : hole.tried.cend();
        for (auto tried = hole.tried.cbegin(); tried != last; ++tried) {
            request.spoilt[id].push_back(tried->method_used);
        }
    }
    return again;
}

void SpoiltFills::put_back(std::vector<HoleReport>& holes) {
    for (HoleReport& hole : holes) {
        const auto left = holes_.find(hole.ids.front());
        if (left == holes_.end() || !left->second.open) {
            continue;
        }
        hole = *best_of(left->second.tried);
        hole.status = FillStatus::Refused;
        hole.notes.push_back(std::move(hole.reason));
        hole.reason = fmt::format(
            "the best fill is bad in the written file and stays out of the model (--keep-bad puts "
            "it in): {}",
            to_text(hole.verdict.findings.front()));
    }
}

}  // namespace suture::cli

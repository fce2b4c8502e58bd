#include "cli/command.h"

#include "suture/base/text.h"

#include <fmt/format.h>

namespace suture::cli {
namespace {

/// More rows than a screen has are no help; the reports have them all.
constexpr std::size_t kTerminalRows = 60;

}  // namespace

std::string text_of(const Outcome& outcome) {
    std::string text;
    for (const Section& section : outcome.sections) {
        text += section.heading.empty() ? "" : section.heading + '\n';
        const std::vector<std::vector<std::string>>& rows = section.table.rows();
        Table shown(section.table);
        if (rows.size() > kTerminalRows) {
            shown.keep_first(kTerminalRows);
        }
        text += rows.empty() ? "" : shown.text();
        if (rows.size() > kTerminalRows) {
            text += fmt::format("... and {} more: --json and --report R.html have them all\n",
                                rows.size() - kTerminalRows);
        }
        for (const std::string& note : section.notes) {
            text += "  " + visible(note) + '\n';
        }
        text += '\n';
    }
    return text + visible(outcome.verdict) + '\n';
}

Progress Run::stage(Stage stage, std::string what, double from, double to) {
    const double width = window_[1] - window_[0];
    from = window_[0] + width * from;
    to = window_[0] + width * to;
    line_.enter(stage, what);
    display_.show(from, what);
    Progress progress;
    progress.cancel = cancel_;
    // Fills report from several threads; the last text is kept so that the supervisor hears of
    // changes only.
    auto last = std::make_shared<std::string>(what);
    auto mutex = std::make_shared<std::mutex>();
    progress.report = [this, stage, what = std::move(what), from, to, last, mutex](
                          double fraction, std::string_view text) {
        // Only filling has steps that a user knows by name: its holes.
        const bool own = stage == Stage::Filling && !text.empty();
        const std::string_view shown = own ? text : std::string_view(what);
        {
            const std::lock_guard lock(*mutex);
            if (*last != shown) {
                *last = shown;
                line_.enter(stage, shown);
            }
        }
        display_.show(from + (to - from) * fraction, shown);
    };
    return progress;
}

}  // namespace suture::cli

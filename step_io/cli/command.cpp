#include "cli/command.h"

#include "suture/base/text.h"

#include <fmt/format.h>

namespace suture::cli {
namespace {

/// More rows than a screen has are no help.
constexpr std::size_t kScreenRows = 20;

std::string text_of(const Section& section, bool verbose) {
    if (section.detail && !verbose) {
        return {};
    }
    std::string text;
    Table shown = verbose || !section.brief ? section.table : *section.brief;
    const std::size_t rows = shown.rows().size();
    if (!verbose) {
        shown.keep_first(kScreenRows);
    }
    text += rows == 0 ? "" : shown.text();
    if (rows > shown.rows().size()) {
        text += fmt::format("... and {} more: -v, --json and --report R.html have them all\n",
                            rows - shown.rows().size());
    }
    if (verbose || !section.notes_are_detail) {
        for (const std::string& note : section.notes) {
            text += "  " + visible(note) + '\n';
        }
    }
    if (text.empty()) {
        return text;
    }
    return (section.heading.empty() ? "" : section.heading + '\n') + text + '\n';
}

}  // namespace

std::string text_of(const Outcome& outcome, bool verbose) {
    std::string text;
    for (const Section& section : outcome.sections) {
        text += text_of(section, verbose);
    }
    text += outcome.next.empty() ? "" : visible(outcome.next) + '\n';
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

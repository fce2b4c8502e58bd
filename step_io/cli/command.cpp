#include "cli/command.h"

namespace suture::cli {

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

#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace suture {

/// How a long computation tells how far it is and learns that it should stop.
struct Progress {
    /// fraction in [0,1] of the stage named by the text
    std::function<void(double fraction, std::string_view stage)> report;
    std::stop_token cancel;

    void operator()(double fraction, std::string_view stage) const {
        if (report) {
            report(fraction, stage);
        }
    }
    [[nodiscard]] bool cancelled() const { return cancel.stop_requested(); }
};

}  // namespace suture

#pragma once

#include "support/ribbon_zoo.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace suture::bench {

/// The distance from the corner at which fillets end that are set back.
inline constexpr double kSetBack = 2.7;

/// A corner of the benchmark's: how many fillets meet, and how unequal.
struct Corner {
    int edges = 3;
    double rise = 0.0, vary = 0.0;
    bool tight = true;  ///< the hole's corners are where fillets meet; else it is set back

    [[nodiscard]] zoo::FilletCorner fillets() const {
        constexpr double kSlope = 0.6;
        return zoo::fillet_corner(edges, kSlope, rise, vary);
    }
    [[nodiscard]] std::string name() const {
        return fmt::format("{} edges, rise {}, vary {}, {}", edges, rise, vary,
                           tight ? "tight" : "set back");
    }
};

inline std::vector<Corner> corners() {
    struct Kind {
        double rise, vary;
    };
    std::vector<Corner> result;
    for (const Kind& kind : {Kind{0.0, 0.5}, Kind{0.0, 1.0}, Kind{0.35, 0.5}}) {
        for (int edges = 3; edges <= 8; ++edges) {
            for (const bool tight : {true, false}) {
                result.push_back({edges, kind.rise, kind.vary, tight});
            }
        }
    }
    return result;
}

}  // namespace suture::bench

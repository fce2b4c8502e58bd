#pragma once

#include "suture/fill/recognise/border.h"

#include <optional>
#include <string>
#include <vector>

namespace suture::recognise {

/// A form whose parameters are plain numbers wherever that fits as well, and what was found so.
struct PlainForm {
    Surface form;                    ///< in the border's coordinates
    std::vector<std::string> facts;  ///< "axis parallel to that of face 4", "r as of face 4"
    double chance = 1.0;             ///< how probable it is that another form is as plain
};

/// Axis: that of a neighbour, parallel to one, along a coordinate axis. Sizes: a neighbour's, round
/// in millimetres or inches, round in degrees. The rest is fitted again each time; a number is kept
/// if the median distance grows by less than 15 % or stays within rounding.
[[nodiscard]] PlainForm plain(const Surface& form, const Border& border);

/// The length that is round in millimetres or inches, as coarsely as there is one within `slack`
/// that does not lie there by chance; model units are millimetres.
[[nodiscard]] std::optional<double> find_round_length(double length, double slack);

/// How probable it is that some length is by chance as near to a round one as this.
[[nodiscard]] double chance_of_round(double length, double round);

}  // namespace suture::recognise

#include "files/units.h"

#include <array>
#include <cmath>
#include <utility>

namespace suture::io {

namespace {

constexpr double kInch = 25.4;
constexpr std::array<std::pair<const char*, double>, 10> kUnits{{{"MM", 1.0},
                                                                 {"CM", 10.0},
                                                                 {"M", 1e3},
                                                                 {"KM", 1e6},
                                                                 {"UM", 1e-3},
                                                                 {"INCH", kInch},
                                                                 {"FT", 12 * kInch},
                                                                 {"MI", 63360 * kInch},
                                                                 {"MIL", 1e-3 * kInch},
                                                                 {"UIN", 1e-6 * kInch}}};
/// Files write conversion factors with seven digits or so; the US survey foot, which OCCT has no
/// name for, differs from the foot by 2e-6.
constexpr double kRelativeDifference = 1e-6;

}  // namespace

std::string unit_of_millimetres(double millimetres) {
    for (const auto& [name, size] : kUnits) {
        if (std::abs(millimetres - size) <= kRelativeDifference * size) {
            return name;
        }
    }
    return "MM";
}

double millimetres_of_unit(std::string_view unit) {
    for (const auto& [name, size] : kUnits) {
        if (unit == name) {
            return size;
        }
    }
    return 1.0;
}

}  // namespace suture::io

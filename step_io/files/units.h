#pragma once

#include <string>
#include <string_view>

namespace suture::io {

/// OCCT's name of the length unit that has so many millimetres: MM, CM, M, KM, UM, INCH, FT, MI,
/// MIL, UIN; MM for a length that has no name.
[[nodiscard]] std::string unit_of_millimetres(double millimetres);

/// The length of one of these units in millimetres; 1 for any other name.
[[nodiscard]] double millimetres_of_unit(std::string_view unit);

}  // namespace suture::io

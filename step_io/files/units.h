#pragma once

#include <string>

namespace suture::io {

/// OCCT's name of the length unit that has so many millimetres: MM, CM, M, KM, UM, INCH, FT, MI,
/// MIL, UIN; MM for a length that has no name.
[[nodiscard]] std::string unit_of_millimetres(double millimetres);

}  // namespace suture::io

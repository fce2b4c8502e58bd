#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace suture::report {

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

/// The bytes of an array as this machine has them: little-endian, as every browser's typed arrays.
template <class T>
[[nodiscard]] std::string base64_of(const std::vector<T>& values) {
    return base64(
        {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)});
}

}  // namespace suture::report

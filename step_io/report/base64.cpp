#include "report/base64.h"

#include <bit>
#include <string_view>

namespace suture::report {

static_assert(std::endian::native == std::endian::little);

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const std::uint32_t block = (bytes[i] << 16U) | (left > 1 ? bytes[i + 1] << 8U : 0U) |
                                    (left > 2 ? bytes[i + 2] : 0U);
        text += digits[block >> 18U & 63U];
        text += digits[block >> 12U & 63U];
        text += left > 1 ? digits[block >> 6U & 63U] : '=';
        text += left > 2 ? digits[block & 63U] : '=';
    }
    return text;
}

}  // namespace suture::report

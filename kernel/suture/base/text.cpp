#include "suture/base/text.h"

#include <fmt/format.h>

#include <cstdint>

namespace suture {
namespace {

/// What stands for bytes that are no letter.
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// A letter of UTF-8: its code and its bytes; a single byte without a code where there is none.
struct Letter {
    static constexpr char32_t kNone = 0xFFFFFFFF;
    char32_t code = kNone;
    std::string_view bytes;
};

/// The first letter of a text that is not empty. Overlong forms, surrogates and what lies beyond
/// Unicode are none (RFC 3629).
Letter first_letter(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80U) {
        return {lead, text.substr(0, 1)};
    }
    const std::size_t size = lead < 0xC2U   ? 0
                             : lead < 0xE0U ? 2
                             : lead < 0xF0U ? 3
                             : lead < 0xF5U ? 4
                                            : 0;
    const Letter none{Letter::kNone, text.substr(0, 1)};
    if (size == 0 || text.size() < size) {
        return none;
    }
    char32_t code = lead & (0x7FU >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return none;
        }
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    const bool overlong = (size == 3 && code < 0x800U) || (size == 4 && code < 0x10000U);
    const bool surrogate = code >= 0xD800U && code <= 0xDFFFU;
    return overlong || surrogate || code > 0x10FFFFU ? none : Letter{code, text.substr(0, size)};
}

template <class Action>
void for_each_letter(std::string_view text, Action&& action) {
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        action(letter);
        text.remove_prefix(letter.bytes.size());
    }
}

/// C0 and C1 control characters and DEL; what changes the direction of writing.
bool steers(char32_t code) {
    return code < 0x20U || (code >= 0x7FU && code < 0xA0U) || code == 0x200EU || code == 0x200FU ||
           code == 0x061CU || (code >= 0x2028U && code <= 0x202EU) ||
           (code >= 0x2066U && code <= 0x2069U);
}

}  // namespace

std::string valid_utf8(std::string_view text) {
    std::string result;
    for_each_letter(text, [&](const Letter& letter) {
        result += letter.code == Letter::kNone ? kReplacement : letter.bytes;
    });
    return result;
}

std::string visible(std::string_view text) {
    std::string result;
    for_each_letter(text, [&](const Letter& letter) {
        if (letter.code == Letter::kNone) {
            result += kReplacement;
        } else if (!steers(letter.code)) {
            result += letter.bytes;
        } else if (letter.code < 0x100U) {
            result += fmt::format("\\x{:02X}", static_cast<std::uint32_t>(letter.code));
        } else {
            result += fmt::format("\\u{:04X}", static_cast<std::uint32_t>(letter.code));
        }
    });
    return result;
}

std::string shortened(const std::string& text, std::size_t letters) {
    constexpr std::string_view kGap = "...";
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) {
            starts.push_back(i);
        }
    }
    if (starts.size() <= letters || letters <= kGap.size()) {
        return text;
    }
    // The end has the reason, the beginning the file: two thirds and one third.
    const std::size_t kept = letters - kGap.size();
    const std::size_t tail = kept / 3;
    return text.substr(0, starts[kept - tail]) + std::string(kGap) +
           (tail == 0 ? "" : text.substr(starts[starts.size() - tail]));
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

std::string escape_markup(std::string_view text) {
    std::string result;
    for (const char c : valid_utf8(text)) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result +=
                    static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\t' || c == '\r'
                        ? c
                        : '?';
        }
    }
    return result;
}

}  // namespace suture

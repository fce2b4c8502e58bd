#include "files/step_text.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace suture::io {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_keyword(char c) {
    return (c >= 'A' && c <= 'Z') || is_digit(c) || c == '-' || c == '_';
}
bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

struct Reference {
    std::uint64_t from, to;
};

/// Walks over the file once: strings and comments are skipped, statements end at semicolons.
class StepScanner {
  public:
    explicit StepScanner(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

    void scan() {
        while (at_ < end_ && !ended_) {
            const char c = *at_;
            if (c == '\'' || c == '"') {
                skip_to(c);
            } else if (c == '/' && at_ + 1 < end_ && at_[1] == '*') {
                skip_comment();
            } else if (c == '#') {
                number();
            } else if (c == ';') {
                statement_begins_ = true;
                ++at_;
            } else if (statement_begins_ && c >= 'A' && c <= 'Z') {
                keyword();
            } else {
                ++at_;
            }
        }
    }
    [[nodiscard]] bool has_data() const { return data_ && !open_; }
    [[nodiscard]] bool ended() const { return ended_; }
    [[nodiscard]] std::uint64_t last_entity() const { return current_; }

    /// A reference to nothing, if there is one.
    [[nodiscard]] const Reference* unresolved() {
        if (!std::ranges::is_sorted(defined_)) {
            std::ranges::sort(defined_);
        }
        const auto missing = std::ranges::find_if_not(references_, [&](const Reference& reference) {
            return std::ranges::binary_search(defined_, reference.to);
        });
        return missing == references_.end() ? nullptr : &*missing;
    }

  private:
    void skip_to(char quote) { at_ = std::min(end_, std::find(at_ + 1, end_, quote) + 1); }
    void skip_comment() {
        const std::string_view rest(at_ + 2, static_cast<std::size_t>(end_ - at_ - 2));
        const std::size_t close = rest.find("*/");
        at_ = close == rest.npos ? end_ : at_ + 2 + close + 2;
    }
    void number() {
        std::uint64_t id = 0;
        for (++at_; at_ < end_ && is_digit(*at_); ++at_) {
            id = 10 * id + static_cast<std::uint64_t>(*at_ - '0');
        }
        const char* next = at_;
        while (next < end_ && is_blank(*next)) {
            ++next;
        }
        if (next < end_ && *next == '=') {
            defined_.push_back(id);
            current_ = id;
        } else {
            references_.push_back({current_, id});
        }
        statement_begins_ = false;
    }
    void keyword() {
        const char* from = at_;
        at_ = std::find_if_not(at_, end_, is_keyword);
        const std::string_view word(from, static_cast<std::size_t>(at_ - from));
        if (word == "DATA") {
            data_ = true;
        }
        open_ = word == "DATA" || (open_ && word != "ENDSEC");
        ended_ = word == "END-ISO-10303-21";
        statement_begins_ = false;
    }

    const char* at_;
    const char* end_;
    bool statement_begins_ = true;
    bool data_ = false;  ///< a DATA section was seen
    bool open_ = false;  ///< and is not closed
    bool ended_ = false;
    std::uint64_t current_ = 0;
    std::vector<std::uint64_t> defined_;
    std::vector<Reference> references_;
};

/// Reads one letter of UTF-8 from `at` on, over line breaks that OCCT puts between its bytes.
char32_t next_letter(const std::string& text, std::size_t& at) {
    const auto byte = static_cast<unsigned char>(text[at++]);
    const int more = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : 1;
    char32_t letter = byte & (0x3FU >> static_cast<unsigned>(more));
    for (int i = 0; i < more && at < text.size();) {
        const auto next = static_cast<unsigned char>(text[at]);
        if (next != '\n' && (next & 0xC0U) != 0x80U) {
            break;  // no UTF-8: what is there of it
        }
        if (next != '\n') {
            letter = (letter << 6U) | (next & 0x3FU);
            ++i;
        }
        ++at;
    }
    return letter;
}

}  // namespace

std::string encode_step_text(const std::string& text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        if (static_cast<unsigned char>(text[at]) < 0x80U) {
            result += text[at++];
        } else if (const char32_t letter = next_letter(text, at); letter > 0xFFFF) {
            result += fmt::format("\\X4\\{:08X}\\X0\\", static_cast<std::uint32_t>(letter));
        } else {
            result += fmt::format("\\X2\\{:04X}\\X0\\", static_cast<std::uint32_t>(letter));
        }
    }
    return result;
}

Result<void> check_step_text(std::string_view text, const std::filesystem::path& file) {
    StepScanner scanner(text);
    scanner.scan();
    if (!scanner.ended() && scanner.last_entity() != 0) {
        return fail(ErrorCode::Unreadable,
                    "{} is cut off: it ends at entity #{}, without its last line END-ISO-10303-21",
                    file.string(), scanner.last_entity());
    }
    if (!scanner.ended()) {
        return fail(ErrorCode::Unreadable,
                    "{} is cut off: it ends before its data, without its last line "
                    "END-ISO-10303-21",
                    file.string());
    }
    if (!scanner.has_data()) {
        return fail(ErrorCode::Unreadable,
                    "{} is damaged: it has no DATA section that ends in ENDSEC", file.string());
    }
    if (const Reference* reference = scanner.unresolved()) {
        return fail(ErrorCode::Unreadable,
                    "{} is damaged: entity #{} refers to #{}, which the file does not hold",
                    file.string(), reference->from, reference->to);
    }
    return {};
}

}  // namespace suture::io

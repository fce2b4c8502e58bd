#include "files/step_text.h"

#include "files/step_scan.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace suture::io {

namespace {

struct Reference {
    StepId from, to;
};

/// What a whole file must have.
class Completeness {
  public:
    void defines(StepId id, std::size_t /*at*/) {
        defined_.push_back(id);
        current_ = id;
    }
    void refers(StepId id) { references_.push_back({current_, id}); }
    void ends(std::size_t /*at*/) {}
    bool keyword(std::string_view word) {
        data_ = data_ || word == "DATA";
        open_ = word == "DATA" || (open_ && word != "ENDSEC");
        ended_ = word == "END-ISO-10303-21";
        return !ended_;
    }

    [[nodiscard]] bool has_data() const { return data_ && !open_; }
    [[nodiscard]] bool ended() const { return ended_; }
    [[nodiscard]] StepId last_entity() const { return current_; }

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
    bool data_ = false;  ///< a DATA section was seen
    bool open_ = false;  ///< and is not closed
    bool ended_ = false;
    StepId current_ = 0;
    std::vector<StepId> defined_;
    std::vector<Reference> references_;
};

/// Strings and binaries longer than OCCT takes.
class LongTexts {
  public:
    struct Place {
        std::size_t from, to;
        StepId entity;
    };

    void defines(StepId id, std::size_t /*at*/) { entity_ = id; }
    void refers(StepId /*id*/) {}
    void ends(std::size_t /*at*/) {}
    static bool keyword(std::string_view /*word*/) { return true; }
    void text(std::size_t from, std::size_t to) {
        if (last_.to != from || from == 0) {
            last_ = {from, to, entity_};
        } else {
            last_.to = to;  // a doubled quote: OCCT's scanner takes both pieces as one
        }
        if (last_.to - last_.from > kLongestStepText) {
            if (!places_.empty() && places_.back().from == last_.from) {
                places_.pop_back();
            }
            places_.push_back(last_);
        }
    }

    [[nodiscard]] const std::vector<Place>& places() const { return places_; }

  private:
    StepId entity_ = 0;
    Place last_{0, 0, 0};
    std::vector<Place> places_;
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

std::optional<ShorterStep> with_short_texts(std::string_view text) {
    LongTexts found;
    StepScanner(text, found).scan();
    if (found.places().empty()) {
        return std::nullopt;
    }
    constexpr std::size_t kKept = 100;
    ShorterStep result;
    result.first = found.places().front().entity;
    std::size_t done = 0;
    for (const LongTexts::Place& place : found.places()) {
        const std::string_view whole = text.substr(place.from, place.to - place.from);
        const std::string_view start = whole.substr(1, kKept);
        result.text += text.substr(done, place.from - done);
        result.text += whole.front();
        result.text += start.substr(0, start.find_first_of("'\"\\\n\r"));
        result.text += whole.front();
        done = place.to;
        ++result.cut;
    }
    result.text += text.substr(done);
    return result;
}

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
    Completeness found;
    StepScanner(text, found).scan();
    if (!found.ended() && found.last_entity() != 0) {
        return fail(ErrorCode::Unreadable,
                    "{} is cut off: it ends at entity #{}, without its last line END-ISO-10303-21",
                    file.string(), found.last_entity());
    }
    if (!found.ended()) {
        return fail(ErrorCode::Unreadable,
                    "{} is cut off: it ends before its data, without its last line "
                    "END-ISO-10303-21",
                    file.string());
    }
    if (!found.has_data()) {
        return fail(ErrorCode::Unreadable,
                    "{} is damaged: it has no DATA section that ends in ENDSEC", file.string());
    }
    if (const Reference* reference = found.unresolved()) {
        return fail(ErrorCode::Unreadable,
                    "{} is damaged: entity #{} refers to #{}, which the file does not hold",
                    file.string(), reference->from, reference->to);
    }
    return {};
}

}  // namespace suture::io

#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace suture::io {

/// Number of an entity in a STEP file, as in #12.
using StepId = std::uint64_t;

/// Walks over the text of a STEP file once; strings and comments are skipped. Tells the visitor, in
/// the order of the text:
///     defines(id, at)   #id= begins at offset `at`
///     refers(id)        a reference, within the entity begun last
///     ends(at)          a semicolon just before `at`
///     keyword(word)     a statement that begins with a word, as DATA; false stops the walk
/// and, if it has this,
///     text(from, to)    the offsets of a string or a binary with its quotes; one with a doubled
///                       quote within comes in two pieces that touch
template <class Visitor>
class StepScanner {
  public:
    StepScanner(std::string_view text, Visitor& visitor)
        : begin_(text.data()), at_(begin_), end_(at_ + text.size()), visitor_(visitor) {}

    void scan() {
        while (at_ < end_ && !stopped_) {
            const char c = *at_;
            if (c == '\'' || c == '"') {
                const char* from = at_;
                at_ = std::min(end_, std::find(at_ + 1, end_, c) + 1);
                if constexpr (requires { visitor_.text(std::size_t{}, std::size_t{}); }) {
                    visitor_.text(offset(from), offset(at_));
                }
            } else if (c == '/' && at_ + 1 < end_ && at_[1] == '*') {
                skip_comment();
            } else if (c == '#') {
                number();
            } else if (c == ';') {
                statement_begins_ = true;
                ++at_;
                visitor_.ends(offset(at_));
            } else if (statement_begins_ && c >= 'A' && c <= 'Z') {
                keyword();
            } else {
                ++at_;
            }
        }
    }

  private:
    static bool is_digit(char c) { return c >= '0' && c <= '9'; }
    static bool is_keyword(char c) {
        return (c >= 'A' && c <= 'Z') || is_digit(c) || c == '-' || c == '_';
    }
    static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
    [[nodiscard]] std::size_t offset(const char* at) const {
        return static_cast<std::size_t>(at - begin_);
    }
    void skip_comment() {
        const std::string_view rest(at_ + 2, static_cast<std::size_t>(end_ - at_ - 2));
        const std::size_t close = rest.find("*/");
        at_ = close == rest.npos ? end_ : at_ + 2 + close + 2;
    }
    void number() {
        const char* from = at_;
        StepId id = 0;
        for (++at_; at_ < end_ && is_digit(*at_); ++at_) {
            id = 10 * id + static_cast<StepId>(*at_ - '0');
        }
        const char* next = std::find_if_not(at_, end_, is_blank);
        if (next < end_ && *next == '=') {
            visitor_.defines(id, offset(from));
        } else {
            visitor_.refers(id);
        }
        statement_begins_ = false;
    }
    void keyword() {
        const char* from = at_;
        at_ = std::find_if_not(at_, end_, is_keyword);
        stopped_ = !visitor_.keyword({from, static_cast<std::size_t>(at_ - from)});
        statement_begins_ = false;
    }

    const char* begin_;
    const char* at_;
    const char* end_;
    bool statement_begins_ = true;
    bool stopped_ = false;
    Visitor& visitor_;
};

}  // namespace suture::io

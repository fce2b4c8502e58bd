#include "suture/fill/algebraic/parse.h"

#include "suture/base/text.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace suture::algebraic {
namespace {

using Exact = Polynomial<Rational>;

/// A higher degree in the text is a slip of the pen, and would take all memory.
constexpr int kHighestDegree = 20;

/// The parser calls itself for each.
constexpr int kDeepest = 100;

/// Exact arithmetic takes the square of a number's length.
constexpr std::size_t kLongestText = 20'000;

/// Recursive descent: sum -> product -> power -> number, variable or (sum).
class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    Result<Exact> whole() {
        auto result = sum();
        if (result && peek() != '\0') {
            return wrong("an operator");
        }
        return result;
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;  ///< of parentheses

    char peek() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    [[nodiscard]] tl::unexpected<Error> wrong(std::string_view expected) const {
        constexpr std::size_t kShown = 60;
        return fail(ErrorCode::Usage, "'{}{}': expected {} at character {}",
                    visible(text_.substr(0, kShown)), text_.size() > kShown ? "..." : "", expected,
                    at_ + 1);
    }

    Result<Exact> sum() {
        Exact total;
        bool first = true;
        for (;;) {
            Rational sign(1);
            if (const char c = peek(); c == '+' || c == '-') {
                sign = c == '-' ? -1 : 1;
                ++at_;
            } else if (!first) {
                return total;
            }
            first = false;
            auto term = product();
            if (!term) {
                return term;
            }
            total += sign * *term;
        }
    }

    Result<Exact> product() {
        auto total = factor();
        while (total) {
            const char c = peek();
            const bool divide = c == '/';
            if (divide || c == '*') {
                ++at_;
            } else if (!(c == '(' || (c >= 'x' && c <= 'z'))) {
                return total;
            }
            auto next = factor();
            if (!next) {
                return next;
            }
            if (divide && (next->degree > 0 || next->coefficients[0] == 0)) {
                return wrong("a number other than 0 before this");
            }
            total = divide ? (1 / next->coefficients[0]) * *total : *total * *next;
            if (total->degree > kHighestDegree) {
                return wrong("a degree of at most 20");
            }
        }
        return total;
    }

    Result<Exact> factor() {
        auto base = primary();
        if (!base || peek() != '^') {
            return base;
        }
        ++at_;
        const auto exponent = digits();
        if (!exponent || exponent->size() > 2) {
            return wrong("a whole number");
        }
        const int n = std::stoi(*exponent);
        if (n * base->degree > kHighestDegree || n > kHighestDegree) {
            return wrong("a degree of at most 20");
        }
        return power(*base, n);
    }

    Result<Exact> primary() {
        const char c = peek();
        if (c >= 'x' && c <= 'z') {
            ++at_;
            return Exact::variable(c - 'x');
        }
        if (c == '(') {
            if (++depth_ > kDeepest) {
                return wrong("at most 100 parentheses within each other");
            }
            ++at_;
            auto inner = sum();
            if (inner && peek() != ')') {
                return wrong("')'");
            }
            ++at_;
            --depth_;
            return inner;
        }
        return number();
    }

    std::optional<std::string> digits() {
        peek();
        const std::size_t from = at_;
        while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
        if (at_ == from) {
            return std::nullopt;
        }
        return std::string(text_.substr(from, at_ - from));
    }

    Result<Exact> number() {
        std::string whole = digits().value_or("");
        std::string fraction;
        if (at_ < text_.size() && text_[at_] == '.') {
            ++at_;
            fraction = digits().value_or("");
        }
        if (whole.empty() && fraction.empty()) {
            return wrong("a number, x, y, z or '('");
        }
        Rational value = read(whole + fraction) / ten_to(static_cast<int>(fraction.size()));
        if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
            ++at_;
            const bool small = at_ < text_.size() && text_[at_] == '-';
            if (small || (at_ < text_.size() && text_[at_] == '+')) {
                ++at_;
            }
            const auto exponent = digits();
            if (!exponent || exponent->size() > 3) {
                return wrong("an exponent");
            }
            const Rational scale = ten_to(std::stoi(*exponent));
            value = small ? Rational(value / scale) : Rational(value * scale);
        }
        return Exact(value);
    }

    /// Leading zeros would be read as octal.
    static Rational read(const std::string& text) {
        const std::size_t first = std::min(text.find_first_not_of('0'), text.size() - 1);
        return Rational(boost::multiprecision::cpp_int(text.substr(first)));
    }
    static Rational ten_to(int n) {
        return Rational(pow(boost::multiprecision::cpp_int(10), static_cast<unsigned>(n)));
    }
};

std::string name_of(const Monomial& m) {
    std::string name;
    const std::array<int, 3> exponents = {m.i, m.j, m.k};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (exponents[axis] > 0) {
            name += name.empty() ? "" : "*";
            name += static_cast<char>('x' + axis);
            name += exponents[axis] > 1 ? fmt::format("^{}", exponents[axis]) : "";
        }
    }
    return name;
}

template <class T, class Write>
std::string write(const Polynomial<T>& p, const Write& number) {
    const std::vector<Monomial> all = monomials(p.degree);
    std::string text;
    for (std::size_t n = all.size(); n-- > 0;) {
        const T& c = p.coefficients[n];
        if (c == T(0)) {
            continue;
        }
        text += c < T(0) ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
        const std::string name = name_of(all[n]);
        const T size = c < T(0) ? T(-c) : c;
        if (size != T(1) || name.empty()) {
            text += number(size) + (name.empty() ? "" : "*");
        }
        text += name;
    }
    return text.empty() ? "0" : text;
}

}  // namespace

Result<Exact> parse_polynomial(std::string_view text) {
    if (text.size() > kLongestText) {
        return fail(ErrorCode::Usage, "a polynomial of {} characters is longer than the {} allowed",
                    text.size(), kLongestText);
    }
    return Parser(text).whole();
}

std::string to_text(const Exact& polynomial) {
    return write(polynomial, [](const Rational& c) { return c.str(); });
}

std::string to_text(const Polynomial<double>& polynomial) {
    return write(polynomial, [](double c) { return fmt::format("{:.17g}", c); });
}

Polynomial<double> rounded(const Exact& polynomial) {
    auto result = Polynomial<double>::zero(polynomial.degree);
    std::transform(polynomial.coefficients.begin(), polynomial.coefficients.end(),
                   result.coefficients.begin(),
                   [](const Rational& c) { return c.convert_to<double>(); });
    return result;
}

}  // namespace suture::algebraic

#include "suture/fill/option.h"

#include "suture/base/contract.h"
#include "suture/base/text.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace suture {
namespace {

std::optional<std::vector<double>> read_numbers(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string_view part : split(text, ',')) {
        double number = 0.0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
        if (error != std::errc() || end != part.data() + part.size()) {
            return std::nullopt;
        }
        numbers.push_back(number);
    }
    return numbers;
}

std::string_view noun(OptionKind kind) {
    constexpr std::string_view kNouns[] = {"a number",
                                           "a whole number",
                                           "numbers separated by commas",
                                           "a point x,y,z",
                                           "a direction x,y,z that is not zero",
                                           "one of these words"};
    return kNouns[static_cast<int>(kind)];
}

bool is_whole(double number) {
    return number == std::floor(number) &&
           std::abs(number) <= static_cast<double>(std::numeric_limits<int>::max());
}

bool has_kind(const OptionValue& value, const MethodOption& option) {
    const std::vector<double>& numbers = value.numbers;
    const bool taken = std::all_of(numbers.begin(), numbers.end(), [&](double number) {
        return std::isfinite(number) && number >= option.least;
    });
    if (value.kind != option.kind || !taken) {
        return false;
    }
    switch (option.kind) {
        case OptionKind::Number:
            return numbers.size() == 1;
        case OptionKind::Count:
            return numbers.size() == 1 && is_whole(numbers.front());
        case OptionKind::Numbers:
            return !numbers.empty();
        case OptionKind::Position:
            return numbers.size() == 3;
        case OptionKind::Direction:
            return numbers.size() == 3 && std::any_of(numbers.begin(), numbers.end(),
                                                      [](double number) { return number != 0.0; });
        case OptionKind::Word:
            break;
    }
    const auto words = split(option.values, '|');
    return std::find(words.begin(), words.end(), value.word) != words.end();
}

Result<const MethodOption*> find_option(std::string_view method,
                                        std::span<const MethodOption> known, std::string_view key) {
    std::vector<std::string_view> keys;
    for (const MethodOption& option : known) {
        if (option.key == key) {
            return &option;
        }
        keys.push_back(option.key);
    }
    if (keys.empty()) {
        return fail(ErrorCode::Usage, "method '{}' has no option '{}', nor any other", method, key);
    }
    return fail(ErrorCode::Usage, "method '{}' has no option '{}'; its options are {}", method, key,
                fmt::join(keys, ", "));
}

Result<void> expect_kind(const MethodOption& option, const OptionValue& value,
                         std::string_view text) {
    if (has_kind(value, option)) {
        return {};
    }
    const std::string limit =
        std::isfinite(option.least) ? fmt::format(" of at least {:g}", option.least) : "";
    return fail(ErrorCode::Usage, "option '{}' takes {}{} ({}), not '{}'", option.key,
                noun(option.kind), limit, option.values, text);
}

const OptionValue* find_value(const OptionValues& values, std::string_view key) {
    const auto found = values.find(key);
    return found == values.end() ? nullptr : &found->second;
}

}  // namespace

Result<std::pair<std::string, OptionValue>> parse_option(std::string_view method,
                                                         std::span<const MethodOption> known,
                                                         std::string_view text) {
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos) {
        return fail(ErrorCode::Usage, "write an option as KEY=VALUE, not '{}'", text);
    }
    const std::string_view key = text.substr(0, sign);
    const std::string_view rest = text.substr(sign + 1);
    const auto option = find_option(method, known, key);
    if (!option) {
        return tl::unexpected(option.error());
    }
    OptionValue value;
    value.kind = (*option)->kind;
    if (value.kind == OptionKind::Word) {
        value.word = rest;
    } else {
        value.numbers = read_numbers(rest).value_or(std::vector<double>{NAN});
    }
    if (const auto taken = expect_kind(**option, value, rest); !taken) {
        return tl::unexpected(taken.error());
    }
    return std::pair(std::string(key), std::move(value));
}

Result<void> validate_options(std::string_view method, std::span<const MethodOption> known,
                              const OptionValues& values) {
    for (const auto& [key, value] : values) {
        const auto option = find_option(method, known, key);
        if (!option) {
            return tl::unexpected(option.error());
        }
        const std::string text = value.kind == OptionKind::Word
                                     ? value.word
                                     : fmt::format("{}", fmt::join(value.numbers, ","));
        if (auto taken = expect_kind(**option, value, text); !taken) {
            return taken;
        }
    }
    return {};
}

std::optional<double> find_number(const OptionValues& values, std::string_view key) {
    const OptionValue* value = find_value(values, key);
    SUTURE_EXPECTS(!value || value->numbers.size() == 1);
    return value ? std::optional(value->numbers.front()) : std::nullopt;
}

std::optional<int> find_count(const OptionValues& values, std::string_view key) {
    const OptionValue* value = find_value(values, key);
    SUTURE_EXPECTS(!value || (value->numbers.size() == 1 && is_whole(value->numbers.front())));
    return value ? std::optional(static_cast<int>(value->numbers.front())) : std::nullopt;
}

std::vector<double> find_numbers(const OptionValues& values, std::string_view key) {
    const OptionValue* value = find_value(values, key);
    return value ? value->numbers : std::vector<double>{};
}

std::optional<Eigen::Vector3d> find_vector(const OptionValues& values, std::string_view key) {
    const OptionValue* value = find_value(values, key);
    SUTURE_EXPECTS(!value || value->numbers.size() == 3);
    return value ? std::optional(Eigen::Vector3d(value->numbers.data())) : std::nullopt;
}

std::optional<std::string_view> find_word(const OptionValues& values, std::string_view key) {
    const OptionValue* value = find_value(values, key);
    return value ? std::optional<std::string_view>(value->word) : std::nullopt;
}

}  // namespace suture

#pragma once

#include "suture/base/result.h"

#include <Eigen/Core>

#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace suture {

/// What the value of an option is.
enum class OptionKind {
    Number,
    Count,      ///< a whole number
    Numbers,    ///< one or more, separated by commas
    Position,   ///< x,y,z in model units
    Direction,  ///< x,y,z, not all zero; any length
    Word,       ///< one of those in `values`
};

/// An option that one fill method has and others have not, for `--option KEY=VALUE`.
struct MethodOption {
    std::string_view key;
    OptionKind kind = OptionKind::Number;
    std::string_view values;   ///< as the help shows it: "X,Y,Z"; the words of a Word: "F1|F2|F3"
    std::string_view text;     ///< what it does, and its default
    double least = -INFINITY;  ///< numbers below are refused
};

/// A value as it was given: `word` of a Word, else the numbers.
struct OptionValue {
    OptionKind kind = OptionKind::Number;
    std::vector<double> numbers;
    std::string word;
};

/// Values by their keys.
using OptionValues = std::map<std::string, OptionValue, std::less<>>;

/// Reads "KEY=VALUE" for a method that takes these options.
///
/// Refuses  (Usage) a key that the method does not have, with those that it has; a value of another
///          kind.
[[nodiscard]] Result<std::pair<std::string, OptionValue>> parse_option(
    std::string_view method, std::span<const MethodOption> known, std::string_view text);

/// Refuses (Usage) values that the method does not take.
[[nodiscard]] Result<void> validate_options(std::string_view method,
                                            std::span<const MethodOption> known,
                                            const OptionValues& values);

/// The value of a key, if it was given. A value of another kind is a ContractViolation.
[[nodiscard]] std::optional<double> find_number(const OptionValues& values, std::string_view key);
[[nodiscard]] std::optional<int> find_count(const OptionValues& values, std::string_view key);
[[nodiscard]] std::vector<double> find_numbers(const OptionValues& values, std::string_view key);
[[nodiscard]] std::optional<Eigen::Vector3d> find_vector(const OptionValues& values,
                                                         std::string_view key);
[[nodiscard]] std::optional<std::string_view> find_word(const OptionValues& values,
                                                        std::string_view key);

}  // namespace suture

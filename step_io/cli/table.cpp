#include "cli/table.h"

#include "suture/base/contract.h"
#include "suture/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace suture::cli {
namespace {

/// How many columns of a terminal a UTF-8 text takes, for the letters of European languages.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

std::string line_of(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                    const std::vector<bool>& right) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string padding(widths[i] - width_of(cells[i]), ' ');
        line += (i > 0 ? "  " : "") + (right[i] ? padding + cells[i] : cells[i] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line + '\n';
}

}  // namespace

Table::Table(std::vector<std::string> headings) : headings_(std::move(headings)) {
    for (std::string& heading : headings_) {
        right_.push_back(heading.starts_with('>'));
        if (right_.back()) {
            heading.erase(0, 1);
        }
    }
}

void Table::add(std::vector<std::string> row) {
    SUTURE_EXPECTS(row.size() == headings_.size());
    rows_.push_back(std::move(row));
}

std::string Table::text() const {
    std::vector<std::vector<std::string>> rows = rows_;
    for (std::vector<std::string>& row : rows) {
        std::ranges::transform(row, row.begin(), visible);
    }
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < headings_.size(); ++i) {
        widths.push_back(width_of(headings_[i]));
        for (const auto& row : rows) {
            widths[i] = std::max(widths[i], width_of(row[i]));
        }
    }
    std::string text = line_of(headings_, widths, right_);
    for (const auto& row : rows) {
        text += line_of(row, widths, right_);
    }
    return text;
}

std::string short_number(double value) {
    if (!std::isfinite(value)) {
        return "-";
    }
    // Between these, plain decimals are easier to read than powers of ten.
    const double size = std::abs(value);
    const bool plain = value == 0.0 || (size >= 1e-3 && size < 1e6);
    return plain ? fmt::format("{:.4g}", value) : fmt::format("{:.1e}", value);
}

std::string ranges(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
            ++last;
        }
        // A range of two is no shorter than the two.
        if (last == i + 1) {
            last = i;
        }
        text += text.empty() ? "" : ", ";
        text += last > i ? fmt::format("{}-{}", numbers[i], numbers[last])
                         : fmt::format("{}", numbers[i]);
        i = last + 1;
    }
    return text;
}

std::string counted(int count, const char* noun) {
    const char* plural = std::string_view(noun).ends_with('s') ? "es" : "s";
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : plural);
}

}  // namespace suture::cli

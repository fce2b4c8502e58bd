#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace suture::cli {

/// A text table whose columns are as wide as they need be.
class Table {
  public:
    /// A heading that begins with '>' makes the column right-aligned.
    explicit Table(std::vector<std::string> headings);

    /// Refuses (ContractViolation) a row of another length than the headings.
    void add(std::vector<std::string> row);
    void keep_first(std::size_t rows) { rows_.resize(std::min(rows, rows_.size())); }
    /// For a terminal: what a cell has from a file cannot steer it.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    [[nodiscard]] const std::vector<std::string>& headings() const { return headings_; }
    [[nodiscard]] const std::vector<bool>& right_aligned() const { return right_; }
    [[nodiscard]] const std::vector<std::vector<std::string>>& rows() const { return rows_; }

  private:
    std::vector<std::string> headings_;
    std::vector<bool> right_;
    std::vector<std::vector<std::string>> rows_;
};

/// Numbers as a reader wants them: "12.5", "3.2e-07", "0"; "-" for what was not measured.
[[nodiscard]] std::string short_number(double value);

/// "1, 2, 5-9"
[[nodiscard]] std::string ranges(std::vector<int> numbers);

/// "1 hole", "2 holes"
[[nodiscard]] std::string counted(int count, const char* noun);

}  // namespace suture::cli

#pragma once

#include "suture/base/result.h"
#include "suture/fill/fill.h"

#include <span>
#include <string_view>
#include <vector>

namespace suture::cli {

/// What --method takes: the method table, and auto and occt, which are no rows of it.
struct MethodRow {
    std::string_view id, title, sides;
    Continuity highest;
    std::string_view source;
    std::span<const MethodOption> options = {};
};

[[nodiscard]] std::vector<MethodRow> method_rows();

/// Refuses (Usage) an unknown method, with the list and the nearest name.
[[nodiscard]] Result<void> expect_method(std::string_view id);

}  // namespace suture::cli

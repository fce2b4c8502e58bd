#pragma once

#include "suture/base/result.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace suture::cli {

/// A small JSON document from an ordinary file: at most 1 MiB, nested at most 32 deep.
///
/// Refuses  (Unreadable) anything else, naming the file.
[[nodiscard]] Result<nlohmann::ordered_json> read_json(const std::filesystem::path& file);

}  // namespace suture::cli

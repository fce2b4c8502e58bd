#pragma once

#include "cli/batch.h"
#include "cli/command.h"

#include <string>
#include <string_view>
#include <vector>

namespace suture::cli {

/// What became of one file of a batch.
struct BatchResult {
    const Batch::Item* item = nullptr;
    int code = 0;
    bool ran = false;   ///< false: the batch was stopped before its turn
    bool kept = false;  ///< it was done before
    double seconds = 0.0;
    std::string verdict;
};

/// Of two exit codes the one that is worse: 5 (and crashes), 1, 2, 4, 3, 0.
[[nodiscard]] int worse_code(int a, int b);

/// All of them as one outcome, with reports of every kind that --summary can ask for.
[[nodiscard]] Outcome summarize(const Batch& batch, const std::vector<BatchResult>& results,
                                double seconds);

/// The summary as the file's ending asks for.
[[nodiscard]] std::string summary_text(const Batch& batch, const Outcome& outcome,
                                       const std::vector<BatchResult>& results,
                                       const std::filesystem::path& file);

}  // namespace suture::cli

#pragma once

#include "suture/base/result.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace suture::cli {

/// One command for many files: each is done by a process of its own.
struct Batch {
    /// What becomes of one input.
    struct Item {
        std::filesystem::path input;
        std::filesystem::path output;     ///< empty if the command writes no model
        std::filesystem::path document;   ///< the JSON document of its run; empty without a folder
        std::filesystem::path picture;    ///< empty if none was asked for
        std::vector<std::string> words;   ///< of its own command line, but --json
        std::vector<std::string> wishes;  ///< those of them on which its result depends
    };
    std::string command;
    std::vector<Item> items;
    std::filesystem::path folder;  ///< of outputs and documents; empty if none was given
    std::vector<std::filesystem::path> summaries;
    int jobs = 1;
    bool json = false;
    bool again = false;  ///< also what is done and unchanged
    std::string progress = "auto";
};

/// Declares the options that only many files need, so that the help has them; after all others.
void add_batch_options(CLI::App& command, bool writes_model);

/// The batch that a command line asks for; none if it is about one file.
///
/// Input    command: the declared command, whose options tell words from files.
///          words: of the command line, the command's name at first.
/// Refuses  (Usage) files of which two would get the same output, options that are for one file, a
///          folder that cannot be made.
[[nodiscard]] Result<std::optional<Batch>> parse_batch(const CLI::App& command,
                                                       const std::vector<std::string>& words);

/// Does it, and says what came of it.
///
/// Promises a file that fails stops nothing. What was done before with the same content, words and
///          program is not done again. A signal to stop ends the running files and leaves what is
///          done.
/// Result   the exit code of the worst file, or of the signal.
[[nodiscard]] int run_batch(const Batch& batch);

}  // namespace suture::cli

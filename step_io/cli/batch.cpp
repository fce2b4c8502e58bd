#include "cli/batch.h"

#include "cli/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <system_error>
#include <thread>

namespace suture::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kCommands[] = {"inspect", "fill", "check", "convert"};

/// Options that name a file for one model.
constexpr std::string_view kForOneFile[] = {"-o", "--output", "--report", "--picture"};

/// Of a command's words, what is for the batch itself and what for every file.
struct Words {
    std::vector<std::string> files;
    std::vector<std::string> passed_on;
    std::map<std::string, std::vector<std::string>> own;
    std::string for_one_file;
    bool help = false;
    bool unknown = false;  ///< an option that there is not
};

bool takes_value(const CLI::Option* option) {
    return option != nullptr && option->get_items_expected_max() > 0;
}

/// The option's own name, "--jobs" of "-j".
std::string name_of(const CLI::Option& option) {
    return option.get_lnames().empty() ? "-" + option.get_snames().front()
                                       : "--" + option.get_lnames().front();
}

Words sorted(const CLI::App& command, const std::vector<std::string>& words) {
    static const std::vector<std::string> kOwn = {"--out-dir",  "--summary",   "--jobs",
                                                  "--to",       "--again",     "--json",
                                                  "--progress", "--thumbnails"};
    Words result;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word.size() < 2 || word[0] != '-') {
            result.files.push_back(word);
            continue;
        }
        const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
        const std::string flag = word.substr(0, equals);
        const CLI::Option* option = command.get_option_no_throw(flag);
        std::vector<std::string> whole{word};
        std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
        if (equals == std::string::npos && takes_value(option) && i + 1 < words.size()) {
            value = words[++i];
            whole.push_back(value);
        }
        const std::string name = option != nullptr ? name_of(*option) : flag;
        const bool own = std::ranges::find(kOwn, name) != kOwn.end();
        result.help = result.help || name == "--help";
        result.unknown = result.unknown || (option == nullptr && !own);
        if (own) {
            result.own[name].push_back(value);
        } else {
            result.passed_on.insert(result.passed_on.end(), whole.begin(), whole.end());
        }
        if (std::ranges::find(kForOneFile, flag) != std::end(kForOneFile)) {
            result.for_one_file = flag;
        }
    }
    return result;
}

/// The folder that holds all of them, however deep.
fs::path common_folder(const std::vector<std::string>& files) {
    fs::path common = fs::absolute(files.front()).lexically_normal().parent_path();
    for (const std::string& file : files) {
        const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
        fs::path shared;
        auto a = common.begin();
        for (auto b = folder.begin(); a != common.end() && b != folder.end() && *a == *b;
             ++a, ++b) {
            shared /= *a;
        }
        common = shared;
    }
    return common;
}

Result<int> parse_jobs(const Words& words) {
    const auto given = words.own.find("--jobs");
    if (given == words.own.end()) {
        return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    }
    const std::string& text = given->second.back();
    if (text.empty() || text.size() > 4 || text.find_first_not_of("0123456789") != text.npos ||
        std::stoi(text) < 1) {
        return fail(ErrorCode::Usage, "--jobs must be a number of at least 1, not '{}'", text);
    }
    return std::stoi(text);
}

std::string last_of(const Words& words, const std::string& name) {
    const auto given = words.own.find(name);
    return given == words.own.end() || given->second.empty() ? "" : given->second.back();
}

bool writes_model(const std::string& command) {
    return command == "fill" || command == "convert";
}

/// The command line of one file.
Batch::Item item_of(const Batch& batch, const Words& words, const std::string& file,
                    const fs::path& common) {
    Batch::Item item;
    item.input = file;
    item.words = {batch.command, file};
    if (!batch.folder.empty()) {
        const fs::path place =
            batch.folder / fs::absolute(file).lexically_normal().lexically_relative(common);
        item.document = place.string() + ".json";
        if (writes_model(batch.command)) {
            item.output = place;
            const std::string ending = last_of(words, "--to");
            if (!ending.empty()) {
                item.output.replace_extension(ending);
            }
        }
    }
    if (batch.command == "fill") {
        item.words.insert(item.words.end(), {"-o", item.output.string()});
        // The cores that are left over when there are fewer files at once than cores.
        const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
        item.words.insert(item.words.end(),
                          {"--jobs", std::to_string(std::max(1, cores / batch.jobs))});
    } else if (batch.command == "convert") {
        item.words.push_back(item.output.string());
    }
    item.wishes = words.passed_on;
    if (words.own.contains("--thumbnails") && !batch.folder.empty()) {
        item.picture = item.document;
        item.picture.replace_extension(".png");
        item.words.insert(item.words.end(),
                          {"--picture", item.picture.string(), "--picture-size", "320x240"});
        item.wishes.emplace_back("--thumbnails");
    }
    item.words.insert(item.words.end(), words.passed_on.begin(), words.passed_on.end());
    return item;
}

Result<void> expect_own_outputs(const std::vector<Batch::Item>& items) {
    std::map<fs::path, fs::path> from;
    for (const Batch::Item& item : items) {
        for (const fs::path& file : {item.output, item.document}) {
            if (file.empty()) {
                continue;
            }
            const auto [other, first] = from.emplace(file.lexically_normal(), item.input);
            if (!first) {
                return fail(ErrorCode::Usage, "{} and {} would both be written as {}",
                            other->second.string(), item.input.string(), file.string());
            }
        }
        std::error_code error;
        if (!item.output.empty() && fs::equivalent(item.output, item.input, error)) {
            return fail(ErrorCode::Usage,
                        "--out-dir: {} would be written over: name another folder",
                        item.input.string());
        }
    }
    return {};
}

Result<void> expect_for_many(const Batch& batch, const Words& words) {
    if (!words.for_one_file.empty()) {
        return fail(
            ErrorCode::Usage,
            "{} is for one file; of many, --out-dir DIR takes the outputs and --summary FILE "
            "a report of all",
            words.for_one_file);
    }
    if (words.own.contains("--thumbnails") && batch.folder.empty()) {
        return fail(ErrorCode::Usage, "--thumbnails need --out-dir DIR");
    }
    if (writes_model(batch.command) && batch.folder.empty()) {
        return fail(ErrorCode::Usage,
                    "{} files: say where to put what comes of them: --out-dir DIR",
                    words.files.size());
    }
    for (const fs::path& summary : batch.summaries) {
        constexpr std::string_view kEndings[] = {".html", ".json", ".xml", ".csv"};
        if (std::ranges::find(kEndings, summary.extension().string()) == std::end(kEndings)) {
            return fail(ErrorCode::Usage,
                        "--summary {}: give it one of the endings .html, .json, .xml, .csv",
                        summary.string());
        }
    }
    return {};
}

}  // namespace

void add_batch_options(CLI::App& command, bool writes_model) {
    // They are read before the command line is: here they only stand in the help.
    command
        .add_option_function<std::string>(
            "--out-dir", [](const std::string&) {},
            writes_model ? "Many files: where to put the outputs, and a JSON document of each; "
                           "what is there and unchanged is not done again"
                         : "Many files: where to put a JSON document of each; what is there and "
                           "unchanged is not done again")
        ->option_text("DIR");
    command
        .add_option_function<std::string>(
            "--summary", [](const std::string&) {},
            "Many files: a report of all of them: .html, .json, .xml (JUnit) or .csv; can be "
            "given more than once")
        ->option_text("FILE")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    if (command.get_option_no_throw("--jobs") == nullptr) {
        command
            .add_option_function<std::string>(
                "--jobs,-j", [](const std::string&) {},
                "Many files: how many at once (default: as many as there are cores)")
            ->option_text("N");
    }
    if (writes_model) {
        command
            .add_option_function<std::string>(
                "--to", [](const std::string&) {},
                "Many files: the outputs' ending, .step for example (default: the input's)")
            ->option_text("ENDING");
    }
    if (command.get_option_no_throw("--picture") != nullptr) {
        command.add_flag_callback(
            "--thumbnails", [] {}, "Many files: a small picture of each, for the summary's page");
    }
    command.add_flag_callback(
        "--again", [] {}, "Many files: do again what is done and unchanged");
}

Result<std::optional<Batch>> parse_batch(const CLI::App& command,
                                         const std::vector<std::string>& words) {
    Batch batch;
    batch.command = command.get_name();
    if (std::ranges::find(kCommands, batch.command) == std::end(kCommands)) {
        return std::nullopt;
    }
    const Words found = sorted(command, words);
    const std::size_t most = batch.command == "convert" ? 2 : 1;
    const auto given_own = [&](const char* name) { return found.own.contains(name); };
    const bool asked = given_own("--out-dir") || given_own("--summary") || given_own("--to") ||
                       given_own("--again") || given_own("--thumbnails") ||
                       (given_own("--jobs") && batch.command != "fill");
    std::error_code error;
    const bool names_output = batch.command == "fill" && !asked && found.files.size() == 2 &&
                              !fs::exists(found.files.back(), error);
    if (found.help || found.unknown || names_output || found.files.empty() ||
        (!asked && found.files.size() <= most)) {
        return std::nullopt;  // one file, or what the parser of one has to say
    }
    batch.folder = last_of(found, "--out-dir");
    batch.json = given_own("--json");
    batch.again = given_own("--again");
    if (given_own("--progress")) {
        batch.progress = last_of(found, "--progress");
    }
    if (const auto given = found.own.find("--summary"); given != found.own.end()) {
        batch.summaries.assign(given->second.begin(), given->second.end());
    }
    if (given_own("--out-dir") && batch.folder.empty()) {
        return fail(ErrorCode::Usage, "--out-dir needs a folder");
    }
    const Result<int> jobs = parse_jobs(found);
    if (!jobs) {
        return tl::unexpected(jobs.error());
    }
    batch.jobs = *jobs;
    if (const Result<void> valid = expect_for_many(batch, found); !valid) {
        return tl::unexpected(valid.error());
    }
    const fs::path common = common_folder(found.files);
    for (const std::string& file : found.files) {
        batch.items.push_back(item_of(batch, found, file, common));
    }
    if (const Result<void> own = expect_own_outputs(batch.items); !own) {
        return tl::unexpected(own.error());
    }
    return batch;
}

}  // namespace suture::cli

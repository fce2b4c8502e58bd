#include "cli/batch.h"
#include "cli/batch_process.h"
#include "cli/batch_summary.h"
#include "cli/console.h"
#include "cli/report_json.h"
#include "cli/text_file.h"
#include "suture/platform/process.h"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>
#include <system_error>

namespace suture::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kSignalBase = 128;  // as shells have it

/// FNV-1a of 64 bits: it tells a changed file, and needs to stand no attack.
class Fingerprint {
  public:
    void add(std::string_view text) {
        constexpr std::uint64_t kPrime = 0x100000001b3;
        for (const char c : text) {
            value_ = (value_ ^ static_cast<unsigned char>(c)) * kPrime;
        }
        value_ = (value_ ^ text.size()) * kPrime;
    }
    void add_content(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        std::string block(1 << 16, '\0');
        while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) ||
               stream.gcount() > 0) {
            add(std::string_view(block).substr(0, static_cast<std::size_t>(stream.gcount())));
        }
    }
    [[nodiscard]] std::string text() const { return fmt::format("{:016x}", value_); }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

/// What a file's result depends on: its content, the words, files that they name, the program.
std::string key_of(const Batch& batch, const Batch::Item& item) {
    Fingerprint print;
    print.add(batch.command);
    std::error_code error;
    for (const std::string& word : item.wishes) {
        print.add(word);
        if (fs::is_regular_file(word, error)) {
            print.add_content(word);
        }
    }
    print.add(item.output.extension().string());
    print.add_content(item.input);
    print.add(SUTURE_VERSION);
    print.add(fmt::format("{} {}", fs::file_size(kOwnProgram, error),
                          fs::last_write_time(kOwnProgram, error).time_since_epoch().count()));
    return print.text();
}

Json read_document(const fs::path& file) {
    std::ifstream stream(file);
    return stream ? Json::parse(stream, nullptr, /*allow_exceptions=*/false) : Json();
}

/// Something that came of the file, though not the best, is there: these codes do not change when
/// it is done again.
bool is_final(int code) {
    return code == kDone || code == kNothingToDo || code == kOutOfTolerance;
}

/// Whether a file was done before, and nothing has changed.
bool is_done(const Batch::Item& item, const Json& document, const std::string& key) {
    if (!document.is_object() || !document.contains("batch") ||
        document["batch"].value("key", "") != key || !is_final(document.value("exit_code", -1))) {
        return false;
    }
    const auto& sizes = document["batch"]["sizes"];
    for (const fs::path& file : {item.output, item.picture}) {
        std::error_code error;
        if (!file.empty() && sizes.contains(file.string()) &&
            (fs::file_size(file, error) != sizes[file.string()] || error)) {
            return false;
        }
    }
    return true;
}

class BatchRun {
  public:
    explicit BatchRun(const Batch& batch)
        : batch_(batch), display_(style_of(batch)), results_(batch.items.size()) {}

    int run() {
        for (std::size_t next = 0; next < batch_.items.size() && !processes_.stop_signal();
             ++next) {
            begin(next);
            while (processes_.running() >= static_cast<std::size_t>(batch_.jobs)) {
                end(processes_.wait());
            }
        }
        while (processes_.running() > 0) {
            end(processes_.wait());
        }
        display_.clear();
        return tell();
    }

  private:
    static ProgressStyle style_of(const Batch& batch) {
        static const std::map<std::string, ProgressStyle> kStyles{{"none", ProgressStyle::None},
                                                                  {"bar", ProgressStyle::Bar},
                                                                  {"json", ProgressStyle::Json}};
        const auto found = kStyles.find(batch.progress);
        return found == kStyles.end() ? ProgressStyle::Auto : found->second;
    }

    void begin(std::size_t i) {
        const Batch::Item& item = batch_.items[i];
        results_[i].item = &item;
        if (!item.document.empty()) {
            keys_[i] = key_of(batch_, item);
            const Json document = read_document(item.document);
            if (!batch_.again && is_done(item, document, keys_[i])) {
                results_[i] = {&item, document["exit_code"],        true, true,
                               0.0,   document.value("verdict", "")};
                count();
                return;
            }
            std::error_code error;
            fs::create_directories(item.document.parent_path(), error);
            fs::remove(item.document, error);  // what is there is that of another run
        }
        std::vector<std::string> words = item.words;
        words.insert(words.end(), {"--json", "--progress", "none"});
        if (const int error = processes_.start(i, words); error != 0) {
            finish(i, kInternal, fmt::format("no process: {}", std::strerror(error)));
        }
    }

    void end(const BatchProcesses::Ended& ended) {
        BatchResult& result = results_[ended.item];
        const Batch::Item& item = *result.item;
        result.seconds = ended.seconds;
        if (processes_.stop_signal() && ended.code >= kSignalBase) {
            result.verdict = "interrupted";
            return;
        }
        Json document = Json::parse(ended.printed, nullptr, /*allow_exceptions=*/false);
        if (!document.is_object()) {
            finish(ended.item, ended.code >= kSignalBase ? kInternal : ended.code,
                   "the program ended without a word: " + ended.said.substr(0, 300));
            return;
        }
        finish(ended.item, ended.code, document.value("verdict", ""));
        if (item.document.empty()) {
            return;
        }
        Json sizes = Json::object();
        for (const fs::path& file : {item.output, item.picture}) {
            std::error_code error;
            const auto size = file.empty() ? 0 : fs::file_size(file, error);
            if (!file.empty() && !error) {
                sizes[file.string()] = size;
            }
        }
        document["batch"] = {{"key", keys_[ended.item]}, {"sizes", std::move(sizes)}};
        // Last of all: a run that was killed before has no document, and is done again.
        if (const auto written = write_text_file(item.document, to_text(document)); !written) {
            finish(ended.item, kInternal, written.error().message);
        }
    }

    void finish(std::size_t i, int code, std::string verdict) {
        results_[i].ran = true;
        results_[i].code = code;
        results_[i].verdict = std::move(verdict);
        count();
    }

    void count() {
        int ended = 0;
        for (const BatchResult& result : results_) {
            ended += result.ran ? 1 : 0;
        }
        display_.show(static_cast<double>(ended) / static_cast<double>(results_.size()),
                      fmt::format("{} of {} files", ended, results_.size()));
    }

    int tell() {
        for (std::size_t i = 0; i < results_.size(); ++i) {
            results_[i].item = &batch_.items[i];
        }
        Outcome outcome = summarize(batch_, results_, watch_.seconds());
        if (processes_.stop_signal()) {
            outcome.exit_code = kSignalBase + *processes_.stop_signal();
        }
        std::vector<fs::path> summaries = batch_.summaries;
        if (!batch_.folder.empty()) {
            summaries.push_back(batch_.folder / "summary.json");
            summaries.push_back(batch_.folder / "summary.html");
        }
        for (const fs::path& file : summaries) {
            const auto written =
                write_text_file(file, summary_text(batch_, outcome, results_, file));
            if (!written) {
                print_error(written.error().message);
                outcome.exit_code = kInternal;
            }
        }
        const ResultStream out(false);
        const std::string text = batch_.json ? summary_text(batch_, outcome, results_, "x.json")
                                             : text_of(outcome, /*verbose=*/true);
        if (const auto told = out.print(text); !told) {
            print_error(told.error().message);
            return kInternal;
        }
        return outcome.exit_code;
    }

    const Batch& batch_;
    Stopwatch watch_;
    ProgressDisplay display_;
    BatchProcesses processes_;
    std::vector<BatchResult> results_;
    std::map<std::size_t, std::string> keys_;
};

}  // namespace

int run_batch(const Batch& batch) {
    return BatchRun(batch).run();
}

}  // namespace suture::cli

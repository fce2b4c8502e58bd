#include "cli/batch_summary.h"

#include "cli/report_html.h"
#include "cli/report_json.h"
#include "suture/base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

namespace suture::cli {
namespace {

std::string_view status_of(const BatchResult& result) {
    if (!result.ran) {
        return "not run";
    }
    switch (result.code) {
        case kDone:
            return "done";
        case kUsage:
            return "wrong usage";
        case kUnreadable:
            return "unreadable";
        case kNothingToDo:
            return "nothing to do";
        case kOutOfTolerance:
            return "out of tolerance";
        default:
            return "failed";
    }
}

/// From good to bad.
int rank(int code) {
    constexpr std::array kOrder{kDone, kNothingToDo, kOutOfTolerance, kUnreadable, kUsage};
    return static_cast<int>(std::ranges::find(kOrder, code) - kOrder.begin());
}

std::string verdict_of(const std::vector<BatchResult>& results) {
    std::map<std::string_view, int> counts;
    int kept = 0;
    for (const BatchResult& result : results) {
        ++counts[status_of(result)];
        kept += result.kept ? 1 : 0;
    }
    std::vector<std::string> parts;
    for (const auto status : {"done", "nothing to do", "out of tolerance", "unreadable",
                              "wrong usage", "failed", "not run"}) {
        if (counts.contains(status)) {
            parts.push_back(fmt::format("{} {}", counts[status], status));
        }
    }
    return fmt::format("{}: {}{}", counted(static_cast<int>(results.size()), "file"),
                       fmt::join(parts, ", "),
                       kept > 0 ? fmt::format("; {} done before and unchanged", kept) : "");
}

std::string text_or_dash(const std::filesystem::path& path) {
    return path.empty() ? "-" : path.string();
}

std::string quoted_field(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

std::string csv_of(const std::vector<BatchResult>& results) {
    std::string text = "input,status,exit_code,kept,seconds,output,verdict\r\n";
    for (const BatchResult& result : results) {
        text +=
            fmt::format("{},{},{},{},{:.3f},{},{}\r\n", quoted_field(result.item->input.string()),
                        status_of(result), result.code, result.kept ? 1 : 0, result.seconds,
                        quoted_field(result.item->output.string()), quoted_field(result.verdict));
    }
    return text;
}

std::string junit_of(const Batch& batch, const std::vector<BatchResult>& results) {
    std::string cases;
    int failures = 0;
    int errors = 0;
    for (const BatchResult& result : results) {
        const bool fails = result.ran && result.code == kOutOfTolerance;
        const bool breaks =
            !result.ran || (result.code != kDone && result.code != kNothingToDo && !fails);
        failures += fails ? 1 : 0;
        errors += breaks ? 1 : 0;
        const std::string verdict = escape_markup(result.verdict);
        const std::string inside = fails || breaks
                                       ? fmt::format("<{0} message=\"{1}\">{1}</{0}>",
                                                     fails ? "failure" : "error", verdict)
                                       : "";
        cases += fmt::format(
            "    <testcase classname=\"suture {}\" name=\"{}\" time=\"{:.3f}\">{}</testcase>\n",
            batch.command, escape_markup(result.item->input.string()), result.seconds, inside);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
        "  <testsuite name=\"suture {}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n"
        "{}  </testsuite>\n</testsuites>\n",
        batch.command, results.size(), failures, errors, cases);
}

/// The pictures that there are, above the table.
std::string gallery(const std::vector<BatchResult>& results, const std::filesystem::path& file) {
    std::string html;
    std::error_code error;
    for (const BatchResult& result : results) {
        const std::filesystem::path& picture = result.item->picture;
        if (picture.empty() || !std::filesystem::exists(picture, error)) {
            continue;
        }
        const auto place = std::filesystem::absolute(picture).lexically_normal().lexically_relative(
            std::filesystem::absolute(file).lexically_normal().parent_path());
        html += fmt::format(
            "<figure style=\"display:inline-block;margin:.3rem;width:320px\">"
            "<img src=\"{}\" width=\"320\" loading=\"lazy\" alt=\"\">"
            "<figcaption>{}: {}</figcaption></figure>\n",
            escape_markup(place.string()), escape_markup(result.item->input.filename().string()),
            status_of(result));
    }
    return html;
}

Command command_of(const Batch& batch) {
    Command command;
    command.name = batch.command;
    return command;
}

}  // namespace

int worse_code(int a, int b) {
    return rank(a) >= rank(b) ? a : b;
}

Outcome summarize(const Batch& batch, const std::vector<BatchResult>& results, double seconds) {
    Outcome outcome;
    Section section{"Files", Table({"file", "result", ">s", "verdict"}), {}, false};
    Json files = Json::array();
    for (const BatchResult& result : results) {
        const std::string status(status_of(result));
        if (result.ran) {
            outcome.exit_code = worse_code(outcome.exit_code, result.code);
        }
        section.table.add({result.item->input.string(), result.kept ? status + " before" : status,
                           fmt::format("{:.1f}", result.seconds), result.verdict});
        files.push_back({{"input", result.item->input.string()},
                         {"output", text_or_dash(result.item->output)},
                         {"document", text_or_dash(result.item->document)},
                         {"status", status},
                         {"exit_code", result.ran ? Json(result.code) : Json()},
                         {"kept", result.kept},
                         {"seconds", result.seconds},
                         {"verdict", result.verdict}});
    }
    outcome.sections.push_back(std::move(section));
    outcome.verdict = verdict_of(results);
    outcome.document = {{"jobs", batch.jobs}, {"seconds", seconds}, {"files", std::move(files)}};
    return outcome;
}

std::string summary_text(const Batch& batch, const Outcome& outcome,
                         const std::vector<BatchResult>& results,
                         const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".csv") {
        return csv_of(results);
    }
    if (ending == ".xml") {
        return junit_of(batch, results);
    }
    if (ending == ".html") {
        std::string page = html_report(command_of(batch), outcome);
        constexpr std::string_view kBefore = "<div id=\"report\">\n";
        const std::size_t place = page.find(kBefore);
        return page.insert(place + kBefore.size(), gallery(results, file));
    }
    return to_text(whole_document(command_of(batch), outcome));
}

}  // namespace suture::cli

#include "cli/report_html.h"

#include "cli/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace suture::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(HtmlReport, EscapesWhatComesFromFiles) {
    CLI::App app;
    const auto command = add_command(app, "inspect", {"", "", ""});
    command->input = "/tmp/<script>.step";
    Outcome outcome;
    outcome.verdict = "a < b & \"c\"";
    outcome.sections.push_back({"<h>", Table({"<t>"}), {"<n>"}});
    outcome.sections[0].table.add({"<script>alert(1)</script>"});
    const std::string page = html_report(*command, outcome);
    EXPECT_THAT(page, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
    EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt;"));
    for (const char* raw : {"<script>", "<h>", "<t>", "<n>"}) {
        EXPECT_THAT(page, Not(HasSubstr(raw)));
    }
}

TEST(HtmlReport, HasEveryRow) {
    CLI::App app;
    const auto command = add_command(app, "check", {"", "", ""});
    Outcome outcome;
    outcome.sections.push_back({"Edges", Table({">edge"}), {}});
    for (int i = 0; i < 300; ++i) {
        outcome.sections[0].table.add({std::to_string(i)});
    }
    const std::string page = html_report(*command, outcome);
    EXPECT_THAT(page, HasSubstr("<td class=\"n\">0</td>"));
    EXPECT_THAT(page, HasSubstr("<td class=\"n\">299</td>"));
}

}  // namespace
}  // namespace suture::cli

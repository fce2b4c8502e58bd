#include "cli/report_html.h"

#include "suture/base/text.h"

#include "report/scene.h"
#include <fmt/format.h>

namespace suture::cli {
namespace {

constexpr std::string_view kStyle = R"(
body { font: 16px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem;
       color: #1c2024; background: #fff; }
h1 { font-size: 1.5rem; margin-bottom: 0; } h2 { font-size: 1.15rem; margin-top: 2rem; }
.file { color: #59636e; margin-top: 0; overflow-wrap: anywhere; }
.verdict { border-left: .4rem solid #2da44e; background: #f0f8f2; padding: .6rem 1rem; }
.verdict.warn { border-color: #d4a017; background: #fdf8e8; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .8rem .25rem 0; text-align: left; vertical-align: top;
         border-bottom: 1px solid #d8dee4; }
th { color: #59636e; font-weight: 600; } .n { text-align: right; }
footer { margin-top: 3rem; color: #59636e; font-size: .85rem; }
@media (prefers-color-scheme: dark) {
  body { color: #e6e8ea; background: #15181b; } th, td { border-color: #343a40; }
  .verdict { background: #17251b; } .verdict.warn { background: #2a2412; } }
)";

std::string row_of(const std::vector<std::string>& cells, const std::vector<bool>& right,
                   std::string_view tag) {
    std::string row = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        row += fmt::format("<{0}{1}>{2}</{0}>", tag, right[i] ? " class=\"n\"" : "",
                           escape_markup(cells[i]));
    }
    return row + "</tr>\n";
}

std::string html_of(const Section& section) {
    std::string html = fmt::format("<h2>{}</h2>\n", escape_markup(section.heading));
    if (!section.table.empty()) {
        const auto& right = section.table.right_aligned();
        html += "<div class=\"scroll\"><table>\n<thead>" +
                row_of(section.table.headings(), right, "th") + "</thead>\n<tbody>\n";
        for (const auto& row : section.table.rows()) {
            html += row_of(row, right, "td");
        }
        html += "</tbody></table></div>\n";
    }
    for (const std::string& note : section.notes) {
        html += fmt::format("<p>{}</p>\n", escape_markup(note));
    }
    return html;
}

}  // namespace

std::string html_report(const Command& command, const Outcome& outcome, std::string_view scene) {
    if (report::viewer_script().empty()) {
        scene = {};  // built without it (SUTURE_REPORT=OFF)
    }
    const std::string file = escape_markup(command.input.filename().string());
    const std::string title = fmt::format("suture {}", command.name);
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}{}{}</title>\n<style>{}</style>\n</head>\n<body>\n",
        title, file.empty() ? "" : ": ", file,
        scene.empty() ? kStyle : std::string_view(report::viewer_style()));
    html += fmt::format("<h1>{}</h1>\n<p class=\"file\">{}</p>\n", title,
                        escape_markup(command.input.string()));
    html += fmt::format("<p class=\"verdict{}\">{}</p>\n",
                        outcome.exit_code == kDone ? "" : " warn", escape_markup(outcome.verdict));
    html += "<div id=\"report\">\n";
    for (const Section& section : outcome.sections) {
        if (scene.empty() || !section.of_edges) {
            html += html_of(section);
        }
    }
    html += fmt::format(
        "<footer>Suture {}. Lengths in millimetres, angles in degrees. Edge and face numbers are "
        "those of FreeCAD (Edge1, Face1).</footer>\n</div>\n",
        SUTURE_VERSION);
    if (!scene.empty()) {
        html +=
            "<noscript><p>The 3D view and the table of edges need JavaScript.</p></noscript>\n"
            "<script type=\"application/json\" id=\"suture-scene\">";
        html += scene;
        html += "</script>\n<script>" + report::viewer_script() + "</script>\n";
    }
    return html + "</body>\n</html>\n";
}

}  // namespace suture::cli

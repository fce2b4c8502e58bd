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

constexpr std::string_view kNoScript =
    "<noscript><p>The 3D view and the table of edges need JavaScript.</p></noscript>\n";

/// What stands between head and end: the pictures or nothing, then the tables.
struct Page {
    std::string_view pictures;
    std::string_view scenes;  ///< script elements; empty: a page without the viewer
};

std::string html_of(const Command& command, const Outcome& outcome, const Page& page) {
    const bool alive = !page.scenes.empty();
    const std::string file = escape_markup(command.input.filename().string());
    const std::string title = fmt::format("suture {}", command.name);
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}{}{}</title>\n<style>{}</style>\n</head>\n<body>\n",
        title, file.empty() ? "" : ": ", file,
        alive ? std::string_view(report::viewer_style()) : kStyle);
    html += fmt::format("<h1>{}</h1>\n<p class=\"file\">{}</p>\n", title,
                        escape_markup(command.input.string()));
    html += fmt::format("<p class=\"verdict{}\">{}</p>\n",
                        outcome.exit_code == kDone ? "" : " warn", escape_markup(outcome.verdict));
    html += page.pictures;
    html += "<div id=\"report\">\n";
    for (const Section& section : outcome.sections) {
        if (!alive || !section.of_edges) {
            html += html_of(section);
        }
    }
    html += fmt::format(
        "<footer>Suture {}. Lengths in millimetres, angles in degrees. Edge and face numbers are "
        "those of FreeCAD (Edge1, Face1).</footer>\n</div>\n",
        SUTURE_VERSION);
    if (alive) {
        html += kNoScript;
        html += page.scenes;
        html += "<script>" + report::viewer_script() + "</script>\n";
    }
    return html + "</body>\n</html>\n";
}

std::string figure_of(const GalleryItem& item, const std::string& id) {
    const std::string name = escape_markup(item.name);
    std::string html =
        fmt::format("<figure{} data-scene=\"{}\"><a href=\"#{}\" aria-label=\"Open {} of {}\">",
                    item.good ? " class=\"good\"" : "", id, id, name, escape_markup(item.group));
    for (const char* shading : {"shaded", "zebra"}) {
        html += fmt::format("<img data-shading=\"{0}\" alt=\"{1}, {0}\">", shading, name);
    }
    return html + fmt::format("</a><figcaption><b>{}</b> {}</figcaption></figure>\n", name,
                              escape_markup(item.caption));
}

}  // namespace

std::string html_report(const Command& command, const Outcome& outcome, std::string_view scene) {
    if (scene.empty() || report::viewer_script().empty()) {  // built with SUTURE_REPORT=OFF
        return html_of(command, outcome, {});
    }
    const std::string element =
        fmt::format("<script type=\"application/json\" id=\"suture-scene\">{}</script>\n", scene);
    return html_of(command, outcome, {{}, element});
}

std::string gallery_report(const Command& command, const Outcome& outcome,
                           const std::vector<GalleryItem>& items) {
    if (report::viewer_script().empty()) {
        return html_of(command, outcome, {});
    }
    std::string pictures = "<div id=\"gallery\">\n";
    std::string scenes;
    for (std::size_t i = 0; i < items.size();) {
        const std::string& group = items[i].group;
        std::string figures;
        std::string refused;
        for (; i < items.size() && items[i].group == group; ++i) {
            const GalleryItem& item = items[i];
            if (item.scene.empty()) {
                refused += fmt::format("<li>{}: {}</li>\n", escape_markup(item.name),
                                       escape_markup(item.caption));
                continue;
            }
            const std::string id = escape_markup(fmt::format("{}.{}", group, item.name));
            figures += figure_of(item, id);
            scenes += fmt::format(
                "<script type=\"application/json\" class=\"suture-scene\" id=\"scene:{}\" "
                "data-title=\"{}\">{}</script>\n",
                id, escape_markup(fmt::format("{}, {}: {}", group, item.name, item.caption)),
                item.scene);
        }
        pictures += fmt::format(
            "<section><h2>{}</h2>\n<div class=\"cards\">\n{}</div>\n<details class=\"refused\">"
            "<summary>Methods that refuse</summary><ul>\n{}</ul></details></section>\n",
            escape_markup(group), figures, refused);
    }
    pictures += "</div>\n";
    return html_of(command, outcome, {pictures, scenes});
}

}  // namespace suture::cli

#include "cli/methods.h"

#include "cli/arguments.h"
#include "cli/options.h"

#include <fmt/format.h>

#include <algorithm>

namespace suture::cli {
namespace {

constexpr CommandHelp kHelp{
    "List the fill methods",
    "List the fill methods: what `suture fill --method` takes, for which holes each is, how "
    "smoothly it can join, and where it comes from.",
    "  suture methods                    the table\n"
    "  suture methods --json             for a program\n"
    "  suture fill part.step -o filled.step --method extend\n"};

Outcome list_methods() {
    Section section{"", Table({"method", "what it does", "sides", "up to", "source"}), {}};
    Json methods = Json::array();
    for (const MethodRow& row : method_rows()) {
        section.table.add({std::string(row.id), std::string(row.title), std::string(row.sides),
                           std::string(to_string(row.highest)), std::string(row.source)});
        Json options = Json::array();
        for (const MethodOption& option : row.options) {
            section.notes.push_back(fmt::format("{} --option {}={}: {}", row.id, option.key,
                                                option.values, option.text));
            options.push_back(
                {{"key", option.key}, {"value", option.values}, {"text", option.text}});
        }
        methods.push_back({{"id", row.id},
                           {"title", row.title},
                           {"sides", row.sides},
                           {"highest_continuity", to_string(row.highest)},
                           {"source", row.source},
                           {"options", std::move(options)}});
    }
    Outcome outcome;
    outcome.verdict = counted(static_cast<int>(method_rows().size()), "method");
    outcome.sections.push_back(std::move(section));
    outcome.document = {{"methods", methods}, {"default", "auto"}};
    return outcome;
}

}  // namespace

std::vector<MethodRow> method_rows() {
    std::vector<MethodRow> rows{{"auto", "Tries what applies, measures, keeps the best", "any",
                                 Continuity::G2, "the methods below"}};
    for (const FillMethod& method : fill_methods()) {
        rows.push_back(
            {method.id, method.title, method.sides, method.highest, method.source, method.options});
    }
    rows.push_back({"occt", "OCCT's own filling, for comparison", "1 loop", Continuity::G2,
                    "BRepOffsetAPI_MakeFilling (OpenCASCADE)"});
    return rows;
}

Result<void> expect_method(std::string_view id) {
    std::vector<std::string_view> known;
    std::string list;
    for (const MethodRow& row : method_rows()) {
        if (row.id == id) {
            return {};
        }
        known.push_back(row.id);
        list += fmt::format("{}{}", list.empty() ? "" : ", ", row.id);
    }
    const auto meant = nearest(id, known);
    return fail(ErrorCode::Usage, "there is no method '{}'{}; the methods are {}", id,
                meant ? fmt::format(", did you mean '{}'?", *meant) : "", list);
}

std::shared_ptr<Command> add_methods(CLI::App& app) {
    auto command = add_command(app, "methods", kHelp);
    command->run = [](Run&) -> Result<Outcome> { return list_methods(); };
    return command;
}

}  // namespace suture::cli

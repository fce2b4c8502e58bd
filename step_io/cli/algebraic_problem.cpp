#include "cli/algebraic_problem.h"

#include "cli/json_file.h"
#include "suture/fill/algebraic/jets.h"
#include "suture/fill/algebraic/parse.h"
#include "suture/fill/algebraic/sheet.h"

#include <fmt/format.h>

#include <map>

namespace suture::cli {
namespace {

using algebraic::ExactProblem;
using algebraic::ExactSolution;
using algebraic::Point;
using algebraic::Rational;
using Eigen::Vector3d;

// What goes beyond these is a slip of the pen, and would take days.
constexpr std::size_t kMostSides = 32;
constexpr int kHighestOrder = 8;
constexpr int kHighestDegree = 20;

/// A number, or its exact value as text.
Result<Rational> number_of(const Json& json) {
    const std::string text = json.is_string() ? json.get<std::string>() : json.dump();
    const auto value = algebraic::parse_polynomial(text);
    if (!value) {
        return tl::unexpected(value.error());
    }
    if (value->degree != 0) {
        return fail(ErrorCode::Usage, "'{}' is no number", text);
    }
    return value->coefficients[0];
}

Result<Point<Rational>> point_of(const Json& json) {
    if (!json.is_array() || json.size() != 3) {
        return fail(ErrorCode::Usage, "{} is no point [x, y, z]", json.dump());
    }
    Point<Rational> point;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto value = number_of(json[c]);
        if (!value) {
            return tl::unexpected(value.error());
        }
        point[c] = *value;
    }
    return point;
}

Result<algebraic::Polynomial<Rational>> polynomial_of(const Json& side, const char* key) {
    if (!side.contains(key) || !side[key].is_string()) {
        return fail(ErrorCode::Usage, "a side needs \"{}\", a polynomial as text", key);
    }
    return algebraic::parse_polynomial(side[key].get<std::string>());
}

Result<void> read_sides(const Json& json, ExactProblem& problem) {
    for (const Json& side : json) {
        const auto f = polynomial_of(side, "surface");
        const auto F = polynomial_of(side, "plane");
        const auto corner = side.contains("from") ? point_of(side["from"])
                                                  : fail(ErrorCode::Usage, "a side needs \"from\"");
        if (!f || !F || !corner) {
            return tl::unexpected(!f ? f.error() : !F ? F.error() : corner.error());
        }
        problem.sides.push_back({*f, *F, problem.k});
        problem.corners.push_back(*corner);
    }
    return {};
}

Result<void> read_choices(const Json& json, ExactProblem& problem) {
    const auto centre = point_of(json.value("centre", Json::array()));
    if (!centre) {
        return fail(ErrorCode::Usage, "\"centre\": {}", centre.error().message);
    }
    problem.centre = *centre;
    if (json.contains("outer")) {
        const auto outer = point_of(json["outer"]);
        if (!outer) {
            return fail(ErrorCode::Usage, "\"outer\": {}", outer.error().message);
        }
        problem.outer = *outer;
    }
    if (json.contains("degree")) {
        const auto degree = json["degree"].get<double>();
        if (!(degree >= 1.0 && degree <= kHighestDegree)) {
            return fail(ErrorCode::Usage, "\"degree\" is {}, not from 1 to {}", degree,
                        kHighestDegree);
        }
        problem.search.degree = static_cast<int>(degree);
    }
    if (json.contains("cells")) {
        const auto cells = json["cells"].get<std::string>();
        if (cells != "axis" && cells != "inner") {
            return fail(ErrorCode::Usage, "\"cells\" is \"axis\" or \"inner\", not \"{}\"", cells);
        }
        problem.search.inner_cells = cells == "inner";
    }
    if (json.contains("sphere")) {
        problem.sphere = json["sphere"].get<double>();
    }
    return {};
}

Json json_of(const Vector3d& p) {
    return Json::array({p.x(), p.y(), p.z()});
}

}  // namespace

Result<ExactProblem> read_problem(const std::filesystem::path& file) {
    const Result<Json> read = read_json(file);
    if (!read) {
        return tl::unexpected(read.error());
    }
    const Json& json = *read;
    if (!json.is_object() || !json.contains("sides") || !json["sides"].is_array()) {
        return fail(ErrorCode::Unreadable, "{}: no JSON object with \"sides\"", file.string());
    }
    if (json["sides"].size() > kMostSides) {
        return fail(ErrorCode::Usage, "{}: it has {} sides, more than {}", file.string(),
                    json["sides"].size(), kMostSides);
    }
    ExactProblem problem;
    try {
        problem.k = json.value("k", 1);
        if (problem.k < 0 || problem.k > kHighestOrder) {
            return fail(ErrorCode::Usage, "{}: \"k\" is {}, not from 0 to {}", file.string(),
                        problem.k, kHighestOrder);
        }
        for (const auto& part : {read_sides(json["sides"], problem), read_choices(json, problem)}) {
            if (!part) {
                return fail(ErrorCode::Usage, "{}: {}", file.string(), part.error().message);
            }
        }
    } catch (const nlohmann::json::exception& wrong) {
        return fail(ErrorCode::Usage, "{}: {}", file.string(), wrong.what());
    }
    return problem;
}

Json json_of(const ExactProblem& problem, const ExactSolution& solution) {
    const algebraic::Partition& partition = solution.found.partition;
    Json cells = Json::array();
    for (std::size_t c = 0; c < solution.cells.size(); ++c) {
        Json cones = Json::array();
        for (const algebraic::Sector& sector : partition.sectors) {
            if (sector.cell != static_cast<int>(c)) {
                continue;
            }
            Json rays = Json::array();
            for (const int ray : sector.rays) {
                rays.push_back(json_of(Vector3d(
                    solution.unit.size * solution.found.rays[static_cast<std::size_t>(ray)])));
            }
            cones.push_back(rays);
        }
        cells.push_back({{"cones", cones},
                         {"exact", to_text(solution.cells[c])},
                         {"rounded", to_text(rounded(solution.cells[c]))}});
    }
    return {{"k", problem.k},
            {"degree", solution.found.degree},
            {"equations", solution.found.rows},
            {"unknowns", solution.found.columns},
            {"rank", solution.rank},
            {"dimension", solution.dimension},
            {"surfaces", solution.polynomials},
            {"chosen_under_conditions", !solution.found.guided_only},
            {"proven_slope", solution.found.slope},
            {"tried", solution.found.tried},
            {"centre", json_of(solution.unit.origin)},
            {"cells", cells}};
}

Result<std::string> obj_of(const ExactSolution& solution, int divisions) {
    std::string text;
    int vertices = 0;
    const auto& sectors = solution.found.partition.sectors;
    for (std::size_t s = 0; s < sectors.size(); ++s) {
        const algebraic::Sheet sheet(solution.problem, solution.found, static_cast<int>(s));
        std::map<std::pair<int, int>, int> numbers;
        for (int i = 0; i <= divisions; ++i) {
            for (int j = 0; i + j <= divisions; ++j) {
                const Vector3d b =
                    Vector3d(divisions - i - j, i, j) / static_cast<double>(divisions);
                const auto point = sheet.at(b, sheet.guess(b));
                if (!point) {
                    return fail(ErrorCode::Refused, "the sheet of cell {} ends inside its sector",
                                sectors[s].cell + 1);
                }
                const Vector3d p = solution.unit.out(*point);
                const Vector3d n = evaluate(sheet.polynomial(), *point).gradient.normalized();
                text += fmt::format("v {:.17g} {:.17g} {:.17g}\nvn {:.9g} {:.9g} {:.9g}\n", p.x(),
                                    p.y(), p.z(), n.x(), n.y(), n.z());
                numbers[{i, j}] = ++vertices;
            }
        }
        const auto triangle = [&](int a, int b, int c) {
            text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, b, c);
        };
        for (int i = 0; i < divisions; ++i) {
            for (int j = 0; i + j < divisions; ++j) {
                const auto at = [&](int di, int dj) { return numbers.at({i + di, j + dj}); };
                triangle(at(0, 0), at(1, 0), at(0, 1));
                if (i + j + 1 < divisions) {
                    triangle(at(1, 0), at(1, 1), at(0, 1));
                }
            }
        }
    }
    return text;
}

}  // namespace suture::cli

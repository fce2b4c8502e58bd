#include "report/scene.h"

#include "suture/check/trace_edges.h"
#include "suture/occ/topology.h"

#include "report/base64.h"
#include "report/face_mesh.h"
#include "report/profile_json.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <set>

namespace suture::report {
namespace {

using Json = nlohmann::ordered_json;

// The courses of edges are drawn at so many points each, fewer where there are many edges; the
// worst edges come first where not all of them fit.
constexpr int kTracePoints = 33;
constexpr int kLeastTracePoints = 9;
constexpr std::size_t kMostTracePoints = 60'000;

Json json_of(const FaceMesh& mesh) {
    return {
        {"points", base64_of(mesh.points)},         {"normals", base64_of(mesh.normals)},
        {"curvatures", base64_of(mesh.curvatures)}, {"corners", base64_of(mesh.corners)},
        {"first", base64_of(mesh.first)},           {"edge_points", base64_of(mesh.edge_points)},
        {"edge_first", base64_of(mesh.edge_first)}, {"faces_without", mesh.faces_without}};
}

/// One number of every edge, as 32-bit floats.
template <class Get>
std::string column(const std::vector<EdgeContinuity>& edges, Get get) {
    std::vector<float> values;
    values.reserve(edges.size());
    for (const EdgeContinuity& edge : edges) {
        values.push_back(static_cast<float>(get(edge)));
    }
    return base64_of(values);
}

template <class Get>
std::string points_column(const std::vector<EdgeContinuity>& edges, Get get) {
    std::vector<float> values;
    for (const EdgeContinuity& edge : edges) {
        const Eigen::Vector3f at = get(edge).template cast<float>();
        values.insert(values.end(), at.data(), at.data() + 3);
    }
    return base64_of(values);
}

Json edges_json(const std::vector<EdgeContinuity>& edges, const Profile& profile) {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::uint32_t> numbers;
    std::vector<std::uint8_t> classes;
    std::vector<std::uint8_t> near_misses;
    Json remarks = Json::object();
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const EdgeContinuity& edge = edges[i];
        numbers.push_back(static_cast<std::uint32_t>(edge.edge));
        numbers.push_back(static_cast<std::uint32_t>(edge.faces[0]));
        numbers.push_back(static_cast<std::uint32_t>(edge.faces[1]));
        classes.push_back(static_cast<std::uint8_t>(edge.edge_class));
        near_misses.push_back(edge.samples == 0 ? 2 : is_near_miss(edge, profile) ? 1 : 0);
        const std::string fault = fault_of(edge, profile);
        const std::string text =
            fault + (fault.empty() || edge.note.empty() ? "" : "; ") + edge.note;
        if (!text.empty()) {
            remarks[std::to_string(i)] = text;
        }
    }
    return {
        {"numbers", base64_of(numbers)},
        {"classes", base64_of(classes)},
        {"near", base64_of(near_misses)},
        {"length", column(edges, [](const auto& e) { return e.length; })},
        {"gap", column(edges, [](const auto& e) { return e.max_gap; })},
        {"angle", column(edges, [](const auto& e) { return degrees(e.max_angle); })},
        {"mean", column(edges, [](const auto& e) { return degrees(e.mean_angle); })},
        {"curvature", column(edges, [](const auto& e) { return 100.0 * e.curvature_mismatch; })},
        {"curvature_sum",
         column(edges, [](const auto& e) { return 100.0 * e.curvature_mismatch_sum; })},
        {"opposite", column(edges, [](const auto& e) { return e.opposite_concavity ? 1 : 0; })},
        {"g3", column(edges,
                      [](const auto& e) {
                          return e.g3_samples > 0 ? degrees(e.g3_mismatch) : kNothing;
                      })},
        {"severity", column(edges, [&](const auto& e) { return severity(e, profile); })},
        {"gap_at", points_column(edges, [](const auto& e) { return e.gap_at; })},
        {"angle_at", points_column(edges, [](const auto& e) { return e.angle_at; })},
        {"remarks", remarks}};
}

/// The rows of the table that are traced are its first ones; of every point 14 numbers.
Json traces_json(const std::vector<EdgeTrace>& traces) {
    constexpr std::size_t kNumbers = 14;
    std::vector<float> values;
    std::vector<std::uint32_t> first = {0};
    for (const EdgeTrace& trace : traces) {
        for (const TracePoint& p : trace.points) {
            const std::array<double, kNumbers> row = {
                p.along,         p.point.x(),      p.point.y(),     p.point.z(),
                p.gap,           degrees(p.angle), p.curvature[0],  p.curvature[1],
                p.normal[0].x(), p.normal[0].y(),  p.normal[0].z(), p.normal[1].x(),
                p.normal[1].y(), p.normal[1].z()};
            for (const double value : row) {
                values.push_back(static_cast<float>(value));
            }
        }
        first.push_back(static_cast<std::uint32_t>(values.size() / kNumbers));
    }
    return {{"values", base64_of(values)}, {"first", base64_of(first)}};
}

Json knots_json(const SceneInput& input) {
    Json lines = Json::array();
    for (const KnotLine& line : input.knots) {
        lines.push_back({{"face", line.face},
                         {"direction", line.is_u ? "u" : "v"},
                         {"knot", line.knot},
                         {"parametric", line.parametric},
                         {"gap", line.max_gap},
                         {"angle", degrees(line.max_angle)},
                         {"curvature", 100.0 * line.curvature_mismatch},
                         {"near", is_near_miss(line, input.profile)},
                         {"at", {line.at.x(), line.at.y(), line.at.z()}}});
    }
    return lines;
}

/// Faces whose geometry is that of a new one: all instances of a part are filled.
std::vector<int> numbers_of_new(const SceneInput& input) {
    std::set<const TopoDS_TShape*> wanted;
    for (const TopoDS_Face& face : input.new_faces) {
        wanted.insert(face.TShape().get());
    }
    std::vector<int> numbers;
    const occ::Numbering numbering(input.shape);
    for (int i = 1; i <= numbering.faces.Extent() && !wanted.empty(); ++i) {
        if (wanted.contains(numbering.faces(i).TShape().get())) {
            numbers.push_back(i);
        }
    }
    return numbers;
}

Json holes_json(const std::vector<SceneHole>& holes) {
    Json list = Json::array();
    for (const SceneHole& hole : holes) {
        list.push_back({{"id", hole.id},
                        {"status", hole.status},
                        {"text", hole.text},
                        {"edges", hole.edges},
                        {"faces", hole.faces}});
    }
    return list;
}

Json parts_json(const std::vector<ScenePart>& parts) {
    Json list = Json::array();
    for (const ScenePart& part : parts) {
        const auto packed = [](const std::vector<int>& numbers) {
            return base64_of(std::vector<std::uint32_t>(numbers.begin(), numbers.end()));
        };
        list.push_back({{"name", part.name},
                        {"depth", part.depth},
                        {"faces", packed(part.faces)},
                        {"edges", packed(part.edges)}});
    }
    return list;
}

/// Nothing in the text is markup, or can end the script element that it stands in: JSON has
/// "\u003c" for "<".
std::string for_script_element(const std::string& json) {
    std::string text;
    text.reserve(json.size());
    for (const char c : json) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

}  // namespace

Result<std::string> make_scene(const SceneInput& input, const Progress& progress) {
    const std::vector<EdgeContinuity> edges = worst_first(input.report.edges, input.profile);
    std::vector<int> traced;
    const std::size_t count = std::min(edges.size(), kMostTracePoints / kLeastTracePoints);
    for (std::size_t i = 0; i < count; ++i) {
        traced.push_back(edges[i].edge);
    }
    const int points =
        std::clamp(static_cast<int>(kMostTracePoints / std::max<std::size_t>(count, 1)),
                   kLeastTracePoints, kTracePoints);
    const auto traces = trace_edges(input.shape, traced, points, progress);
    if (!traces) {
        return tl::unexpected(traces.error());
    }
    Json models = Json::array();
    for (const TopoDS_Shape& shape : {input.shape, input.before}) {
        if (shape.IsNull()) {
            continue;
        }
        const auto mesh = make_face_mesh(shape, FaceMeshOptions{}, progress);
        if (!mesh) {
            return tl::unexpected(mesh.error());
        }
        models.push_back(json_of(*mesh));
    }
    const CheckSummary& summary = input.summary;
    const Json document = {{"models", std::move(models)},
                           {"new_faces", numbers_of_new(input)},
                           {"profile", json_of(input.profile)},
                           {"edges", edges_json(edges, input.profile)},
                           {"traces", traces_json(*traces)},
                           {"knots", knots_json(input)},
                           {"holes", holes_json(input.holes)},
                           {"parts", parts_json(input.parts)},
                           {"free_edges", input.report.free_edges},
                           {"non_manifold_edges", input.report.non_manifold},
                           {"pass", summary.pass()}};
    return for_script_element(document.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace suture::report

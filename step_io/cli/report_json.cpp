#include "cli/report_json.h"

namespace suture::cli {
namespace {

template <class T>
Json strings_of(const std::vector<T>& values) {
    Json array = Json::array();
    for (const auto& value : values) {
        array.push_back(value);
    }
    return array;
}

Json json_of(const PatchFacts& patch) {
    return {
        {"kind", patch.kind},         {"face", patch.face},       {"degree_u", patch.degree_u},
        {"degree_v", patch.degree_v}, {"poles_u", patch.poles_u}, {"poles_v", patch.poles_v},
        {"rational", patch.rational}, {"exact", patch.exact},     {"fit_error", patch.fit_error}};
}

Json json_of(const SideReport& side) {
    return {{"edge", side.edge},
            {"face", side.face},
            {"continuity_requested", to_string(side.requested)},
            {"reason", side.reason},
            {"max_gap", side.gap},
            {"max_angle_deg", degrees(side.angle)},
            {"max_curvature_mismatch", side.curvature_mismatch}};
}

template <class T>
Json array_of(const std::vector<T>& values) {
    Json array = Json::array();
    for (const T& value : values) {
        array.push_back(json_of(value));
    }
    return array;
}

}  // namespace

Json document_head(const Command& command) {
    Json head{{"schema", kSchema},
              {"program", "suture"},
              {"version", SUTURE_VERSION},
              {"command", command.name}};
    if (!command.input.empty()) {
        head["input"] = command.input.string();
    }
    return head;
}

std::string to_text(const Json& document) {
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json whole_document(const Command& command, const Outcome& outcome) {
    Json document = document_head(command);
    document["exit_code"] = outcome.exit_code;
    document["verdict"] = outcome.verdict;
    document.update(outcome.document);
    return document;
}

Json error_document(const Command& command, const Error& error, int exit_code) {
    Json document = document_head(command);
    document["exit_code"] = exit_code;
    document["verdict"] = error.message;
    document["error"] = {{"code", to_string(error.code)}, {"message", error.message}};
    return document;
}

Json json_of(const Eigen::Vector3d& point) {
    return {point.x(), point.y(), point.z()};
}

Json json_of(const io::ModelFile& file) {
    Json json{{"format", io::to_string(file.format)}, {"unit", file.unit}};
    if (!file.schema.empty()) {
        json["step_schema"] = file.schema;
    }
    if (!file.notes.empty()) {
        json["notes"] = file.notes;
    }
    return json;
}

Json json_of(const SewingFacts& sewing) {
    Json left = Json::array();
    for (const LeftOpen& edge : sewing.left) {
        left.push_back({{"gap", edge.gap}, {"length", edge.length}, {"reason", edge.reason}});
    }
    return {{"changed", sewing.changed},
            {"loose_faces", sewing.loose_faces},
            {"sewn_edges", sewing.sewn_edges},
            {"walls", sewing.walls},
            {"tolerance", sewing.tolerance},
            {"largest_gap", sewing.largest_gap},
            {"free_edges_before", sewing.free_edges_before},
            {"free_edges_after", sewing.free_edges_after},
            {"left", left}};
}

Json json_of(const Validity& validity) {
    Json result = {{"closed", validity.closed},
                   {"valid", validity.valid},
                   {"free_edges", validity.free_edges},
                   {"solids", validity.solids},
                   {"shells", validity.shells},
                   {"faces", validity.faces},
                   {"max_tolerance", validity.max_tolerance},
                   {"problems", strings_of(validity.problems)}};
    if (validity.volume) {
        result["volume"] = *validity.volume;
    }
    return result;
}

Json json_of(const Finding& finding) {
    const auto number = [](int value) { return value > 0 ? Json(value) : Json(); };
    return {{"kind", to_string(finding.kind)},
            {"severity", to_string(finding.severity)},
            {"value", in_unit(finding.value, finding.kind)},
            {"limit", in_unit(finding.limit, finding.kind)},
            {"unit", unit_of(finding.kind)},
            {"hole", number(finding.hole)},
            {"edge", number(finding.edge)},
            {"face", number(finding.face)},
            {"other_face", number(finding.other_face)},
            {"at", finding.at.isZero() ? Json() : json_of(finding.at)},
            {"before", finding.before},
            {"text", to_text(finding)}};
}

Json json_of(const BoundaryLoop& loop, const io::Part& part, const std::vector<Corner>& corners) {
    std::vector<int> edges;
    std::vector<int> faces;
    for (const BoundaryEdge& side : loop.edges) {
        edges.push_back(side.edge_number);
        faces.push_back(side.face_number);
    }
    Json corner_list = Json::array();
    for (const Corner& corner : corners) {
        corner_list.push_back({{"point", json_of(corner.point)},
                               {"angle_deg", degrees(corner.angle)},
                               {"normal_mismatch_deg", degrees(corner.normal_mismatch)},
                               {"faces", {corner.face_before, corner.face_after}}});
    }
    return {{"id", loop.id},
            {"kind", to_string(loop.kind)},
            {"sides", loop.edges.size()},
            {"edges", edges},
            {"faces", faces},
            {"diameter", loop.diameter},
            {"length", loop.length},
            {"planar", loop.planar},
            {"gap", loop.gap},
            {"islands_with", loop.islands_with},
            {"reason", loop.reason},
            {"part", part.name},
            {"instances", part.instances},
            {"corners", corner_list}};
}

Json json_of(const ImplicitForm& form) {
    Json cells = Json::array();
    for (const ImplicitCell& cell : form.cells) {
        Json cones = Json::array();
        for (const Eigen::Matrix3d& cone : cell.cones) {
            cones.push_back({json_of(Eigen::Vector3d(cone.col(0))),
                             json_of(Eigen::Vector3d(cone.col(1))),
                             json_of(Eigen::Vector3d(cone.col(2)))});
        }
        cells.push_back({{"polynomial", cell.polynomial}, {"cones", cones}});
    }
    return {{"origin", json_of(form.origin)},
            {"size", form.size},
            {"centre", json_of(form.centre)},
            {"degree", form.degree},
            {"cells", cells}};
}

namespace {

Json recognised_of(const Recognised& found) {
    Json parameters = Json::object();
    for (const auto& [name, value] : found.parameters) {
        parameters[name] = value;
    }
    Json json{{"kind", found.kind},
              {"parameters", parameters},
              {"from", found.from},
              {"gap", found.gap},
              {"angle_deg", degrees(found.angle)}};
    if (!found.axis.isZero() || !found.point.isZero()) {
        json["point"] = cli::json_of(found.point);
    }
    if (!found.axis.isZero()) {
        json["axis"] = cli::json_of(found.axis);
    }
    return json;
}

}  // namespace

Json json_of(const HoleReport& hole, int sides) {
    const bool filled = hole.status == FillStatus::Filled;
    Json json{{"id", hole.ids.front()},
              {"ids", hole.ids},
              {"sides", sides},
              {"status", to_string(hole.status)},
              {"method_requested", hole.method_requested},
              {"method_used", hole.tried ? Json(hole.method_used) : Json()},
              {"continuity_requested", to_string(hole.continuity_requested)}};
    // Of a hole for which there was no fill nothing was measured: null, never a zero that looks
    // perfect.
    const auto measured = [&](auto value) { return hole.tried ? Json(value) : Json(); };
    json["severity"] = measured(to_string(hole.verdict.severity));
    json["findings"] = Json::array();
    for (const Finding& finding : hole.verdict.findings) {
        json["findings"].push_back(cli::json_of(finding));
    }
    json["continuity_reached"] = measured(to_string(hole.continuity_reached));
    json["within_tolerance"] = filled ? Json(hole.verdict.within()) : Json();
    json["max_gap"] = measured(hole.max_gap);
    json["max_angle_deg"] = measured(degrees(hole.max_angle));
    json["max_curvature_mismatch"] = measured(hole.max_curvature_mismatch);
    json["points_through"] = hole.through.size();
    json["max_distance_through"] =
        hole.through.empty() ? Json() : measured(hole.max_distance_through);
    json["max_angle_through_deg"] =
        any_normal(hole.through) ? measured(degrees(hole.max_angle_through)) : Json();
    json["patches"] = array_of(hole.patches);
    json["edges"] = array_of(hole.sides);
    if (hole.recognised) {
        json["recognised"] = recognised_of(*hole.recognised);
    }
    json["seconds"] = hole.seconds;
    json["reason"] = hole.reason;
    json["notes"] = strings_of(hole.notes);
    return json;
}

Json json_of(const EdgeContinuity& edge) {
    return {{"edge", edge.edge},
            {"faces", edge.faces},
            {"class", to_string(edge.edge_class)},
            {"length", edge.length},
            {"max_gap", edge.max_gap},
            {"edge_gap", edge.edge_gap},
            {"max_angle_deg", degrees(edge.max_angle)},
            {"mean_angle_deg", degrees(edge.mean_angle)},
            {"min_angle_deg", degrees(edge.min_angle)},
            {"curvature_mismatch", edge.curvature_mismatch},
            {"curvature_mismatch_sum", edge.curvature_mismatch_sum},
            {"curvature_difference", edge.curvature_difference},
            {"opposite_concavity", edge.opposite_concavity},
            {"g3_mismatch_deg", edge.g3_samples > 0 ? Json(degrees(edge.g3_mismatch)) : Json()},
            {"at", json_of(edge.angle_at)},
            {"gap_at", json_of(edge.gap_at)},
            {"curvature_at", json_of(edge.curvature_at)},
            {"angle_along", edge.angle_along},
            {"gap_along", edge.gap_along},
            {"curvature_along", edge.curvature_along},
            {"samples", edge.samples},
            {"note", edge.note}};
}

Json json_of(const KnotLine& line) {
    return {{"face", line.face},
            {"direction", line.is_u ? "u" : "v"},
            {"knot", line.knot},
            {"parametric", line.parametric},
            {"max_gap", line.max_gap},
            {"max_angle_deg", degrees(line.max_angle)},
            {"curvature_mismatch", line.curvature_mismatch},
            {"curvature_mismatch_sum", line.curvature_mismatch_sum},
            {"at", json_of(line.at)},
            {"samples", line.samples}};
}

}  // namespace suture::cli

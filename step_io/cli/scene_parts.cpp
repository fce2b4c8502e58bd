#include "cli/scene_parts.h"

#include "files/part_tree.h"

#include <fmt/ranges.h>

namespace suture::cli {
namespace {

std::vector<int> numbers_of(const TopTools_IndexedMapOfShape& all, const TopoDS_Shape& shape,
                            TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(shape, kind, own);
    std::vector<int> numbers;
    for (int i = 1; i <= own.Extent(); ++i) {
        if (const int number = all.FindIndex(own(i)); number > 0) {
            numbers.push_back(number);
        }
    }
    return numbers;
}

}  // namespace

std::vector<report::ScenePart> scene_parts(const io::ModelFile& model) {
    const occ::Numbering whole(model.shape());
    std::vector<report::ScenePart> parts;
    for (const io::TreeNode& node : io::part_tree(model)) {
        report::ScenePart& part = parts.emplace_back();
        part.name = node.name;
        part.depth = node.depth;
        if (node.is_part) {
            part.faces = numbers_of(whole.faces, node.shape, TopAbs_FACE);
            part.edges = numbers_of(whole.edges, node.shape, TopAbs_EDGE);
        }
    }
    return parts;
}

std::vector<report::SceneHole> scene_holes(const std::vector<PartLoops>& parts) {
    std::vector<report::SceneHole> holes;
    for (const PartLoops& part : parts) {
        for (const BoundaryLoop& loop : part.loops) {
            report::SceneHole& hole = holes.emplace_back();
            hole.id = std::to_string(loop.id);
            hole.status = to_string(loop.kind);
            hole.text = loop.reason;
            for (const BoundaryEdge& side : loop.edges) {
                hole.edges.push_back(side.edge_number);
                hole.faces.push_back(side.face_number);
            }
        }
    }
    return holes;
}

std::vector<report::SceneHole> scene_holes(const FillSummary& summary) {
    std::vector<report::SceneHole> holes;
    for (const HoleReport& report : summary.holes) {
        report::SceneHole& hole = holes.emplace_back();
        hole.id = fmt::format("{}", fmt::join(report.ids, "+"));
        hole.status = report.status == FillStatus::Filled ? to_string(report.verdict.severity)
                                                          : to_string(report.status);
        hole.text = report.reason;
        for (const SideReport& side : report.sides) {
            hole.edges.push_back(side.edge);
            hole.faces.push_back(side.face);
        }
    }
    return holes;
}

}  // namespace suture::cli

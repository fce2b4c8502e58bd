// Clashes and folds of faces of a model, and the CPU time that finding them takes: a JSON document.
// Usage: suture_face_measures FILE [FACE...]      without numbers: every face
#include "support/read_for_test.h"
#include "suture/check/clashes.h"
#include "suture/check/folds.h"
#include "suture/occ/topology.h"

#include <nlohmann/json.hpp>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <numbers>
#include <numeric>
#include <string>

namespace {

using nlohmann::json;

constexpr double kTolerance = 1e-3;
constexpr double kDegrees = 180.0 / std::numbers::pi;

TopoDS_Shape read(const std::string& path) {
    if (!path.ends_with(".brep")) {
        return suture::test::read_for_test(path);
    }
    TopoDS_Shape shape;
    const BRep_Builder builder;
    BRepTools::Read(shape, path.c_str(), builder);
    return shape;
}

double milliseconds(std::clock_t from) {
    return 1e3 * static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
}

json to_json(const Eigen::Vector3d& p) {
    return {p.x(), p.y(), p.z()};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::cerr << "usage: suture_face_measures FILE [FACE...]\n";
        return 1;
    }
    const TopoDS_Shape shape = read(argv[1]);
    std::vector<int> faces;
    for (int i = 2; i < argc; ++i) {
        faces.push_back(std::atoi(argv[i]));
    }
    if (faces.empty()) {
        faces.resize(static_cast<std::size_t>(suture::occ::Numbering(shape).faces.Extent()));
        std::iota(faces.begin(), faces.end(), 1);
    }
    json result;
    std::clock_t start = std::clock();
    const auto folds = suture::find_folds(shape, faces, {});
    result["folds_ms"] = milliseconds(start);
    start = std::clock();
    const auto clashes = suture::find_clashes(shape, faces, kTolerance, kTolerance, {});
    result["clashes_ms"] = milliseconds(start);
    if (!folds || !clashes) {
        std::cerr << (folds ? clashes.error() : folds.error()).message << '\n';
        return 2;
    }
    result["faces"] = faces.size();
    result["folds"] = result["undecided"] = result["backwards"] = result["clashes"] =
        result["overlays"] = json::array();
    for (const auto& fold : *folds) {
        json entry = {{"face", fold.face}, {"at", to_json(fold.at)}};
        if (fold.backwards) {
            result["backwards"].push_back(entry);
        }
        if (fold.verdict == suture::FoldVerdict::Fold) {
            entry["angle_deg"] = kDegrees * fold.angle;
            result["folds"].push_back(entry);
        } else if (fold.verdict == suture::FoldVerdict::Undecided) {
            entry.update({{"size", fold.size}, {"border", fold.at_border}, {"why", fold.reason}});
            result["undecided"].push_back(entry);
        }
    }
    for (const auto& clash : clashes->clashes) {
        result["clashes"].push_back({{"faces", {clash.face, clash.other}},
                                     {"at", to_json(clash.at)},
                                     {"depth", clash.depth},
                                     {"angle_deg", kDegrees * clash.angle}});
    }
    for (const auto& overlay : clashes->overlays) {
        result["overlays"].push_back({{"faces", {overlay.face, overlay.other}},
                                      {"share", overlay.share},
                                      {"distance", overlay.distance},
                                      {"neighbours", overlay.neighbours},
                                      {"opposed", overlay.opposed}});
    }
    std::cout << result.dump(1) << '\n';
    return 0;
}

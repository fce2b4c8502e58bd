// Whether the check finds the largest gap, angle and curvature mismatch of every edge: its figures
// against those of many more samples, with a search around the highest of them. A JSON document.
// Usage: suture_edge_peaks FILE SAMPLES [FACE...]     only the edges of these faces
#include "support/read_for_test.h"
#include "suture/check/continuity.h"
#include "suture/check/edge_sample.h"
#include "suture/check/edge_uses.h"
#include "suture/check/measure_edge.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <set>
#include <string>

namespace suture {
namespace {

using nlohmann::json;

// Figures below these are rounding, not peaks: radians, parts of the edge's length, parts.
constexpr double kLeastAngle = 1e-6;
constexpr double kLeastGap = 1e-8;
constexpr double kLeastMismatch = 1e-3;
constexpr int kPeaks = 6;  // that are searched around, of each figure
constexpr int kSteps = 60;

/// The faces at an edge, at any number of points.
class Scan {
  public:
    Scan(const TopoDS_Edge& edge, const std::array<TopoDS_Face, 2>& faces,
         const std::array<EdgeInFace, 2>& uses)
        : curve_(edge),
          range_{curve_.FirstParameter(), curve_.LastParameter()},
          length_(length_of(edge, curve_)),
          sides_{FaceSide(faces[0], uses[0].edge, range_, length_),
                 FaceSide(faces[1], uses[1].edge, range_, length_)} {}

    struct Peak {
        double value = 0.0, along = 0.0, width = 0.0;
    };
    Peak peak(double EdgeSample::*value, int count) {
        while (static_cast<int>(samples_.size()) < count) {
            samples_.push_back(at(static_cast<double>(samples_.size()) / (count - 1)));
        }
        std::vector<std::size_t> tops;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const bool rising = i == 0 || samples_[i].*value >= samples_[i - 1].*value;
            const bool falling =
                i + 1 == samples_.size() || samples_[i].*value >= samples_[i + 1].*value;
            if (rising && falling) {
                tops.push_back(i);
            }
        }
        std::ranges::stable_sort(tops, std::greater(),
                                 [&](std::size_t i) { return samples_[i].*value; });
        tops.resize(std::min<std::size_t>(tops.size(), kPeaks));
        Peak best;
        for (const std::size_t i : tops) {
            double low = static_cast<double>(i > 0 ? i - 1 : i) / (count - 1);
            double high = std::min(1.0, static_cast<double>(i + 1) / (count - 1));
            // By thirds: plain, and not the check's own search.
            for (int step = 0; step < kSteps; ++step) {
                const double left = low + (high - low) / 3.0;
                const double right = high - (high - low) / 3.0;
                const double at_left = at(left).*value;
                const double at_right = at(right).*value;
                (at_left < at_right ? low : high) = at_left < at_right ? left : right;
                const double here = std::max(at_left, at_right);
                if (here > best.value) {
                    best = {here, at_left < at_right ? right : left, 0.0};
                }
            }
            if (samples_[i].*value > best.value) {
                best = {samples_[i].*value, static_cast<double>(i) / (count - 1), 0.0};
            }
        }
        const auto above = std::ranges::count_if(
            samples_, [&](const EdgeSample& sample) { return sample.*value > 0.5 * best.value; });
        best.width = static_cast<double>(above) / count;
        return best;
    }
    [[nodiscard]] double length() const { return length_; }

  private:
    EdgeSample at(double s) {
        EdgeSample sample;
        sample.t = range_.first + s * (range_.last - range_.first);
        (void)occ::guarded("scanning an edge", [&] {
            gp_Vec tangent;
            curve_.D1(sample.t, sample.point, tangent);
            const BorderPoint one = sides_[0].at(sample.t, sample.point, tangent);
            const BorderPoint two = sides_[1].at(sample.t, sample.point, tangent);
            sample.gap = one.point.Distance(two.point);
            if (one.normal && two.normal) {
                sample.angle =
                    std::atan2(one.normal->CrossMagnitude(*two.normal), *one.normal * *two.normal);
            }
            if (one.curvature && two.curvature) {
                compare_curvatures(*one.curvature, *two.curvature, length_, sample);
            }
        });
        return sample;
    }

    BRepAdaptor_Curve curve_;
    EdgeRange range_;
    double length_;
    std::array<FaceSide, 2> sides_;
    std::vector<EdgeSample> samples_;
};

TopoDS_Shape read(const std::string& path) {
    if (!path.ends_with(".brep")) {
        return test::read_for_test(path);
    }
    TopoDS_Shape shape;
    const BRep_Builder builder;
    BRepTools::Read(shape, path.c_str(), builder);
    return shape;
}

int run(const std::string& path, int count, const std::set<int>& wanted) {
    const TopoDS_Shape shape = read(path);
    const occ::Numbering numbering(shape);
    std::set<int> edges;
    for (const int face : wanted) {
        for (const TopoDS_Edge& edge : occ::edges_of(numbering.faces(face))) {
            edges.insert(numbering.of(edge));
        }
    }
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const std::clock_t start = std::clock();
    const auto report = measure_continuity(shape, {}, {edges.begin(), edges.end()}, {});
    const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (!report) {
        std::cerr << report.error().message << '\n';
        return 2;
    }
    json result = {{"edges", report->edges.size()}, {"check_ms", ms}, {"missed", json::array()}};
    const auto uses = find_edge_uses(numbering, {});
    for (const EdgeContinuity& edge : report->edges) {
        const auto& both = uses[static_cast<std::size_t>(edge.edge - 1)];
        if (both.size() != 2 || edge.samples == 0) {
            continue;
        }
        Scan scan(TopoDS::Edge(numbering.edges(edge.edge)),
                  {TopoDS::Face(numbering.faces(both[0].face)),
                   TopoDS::Face(numbering.faces(both[1].face))},
                  {both[0], both[1]});
        const auto compare = [&](const char* figure, double EdgeSample::*value, double measured,
                                 double least) {
            const Scan::Peak peak = scan.peak(value, count);
            if (peak.value > least) {
                const double ratio = measured / peak.value;
                result[figure] = std::min(result.value(figure, 1.0), ratio);
                if (ratio < 0.95) {
                    result["missed"].push_back({{"edge", edge.edge},
                                                {"figure", figure},
                                                {"measured", measured},
                                                {"true", peak.value},
                                                {"along", peak.along},
                                                {"width", peak.width}});
                }
            }
        };
        compare("gap", &EdgeSample::gap, edge.max_gap, kLeastGap * scan.length());
        compare("angle", &EdgeSample::angle, edge.max_angle, kLeastAngle);
        compare("mismatch", &EdgeSample::mismatch, edge.curvature_mismatch, kLeastMismatch);
    }
    std::cout << result.dump(1) << '\n';
    return 0;
}

}  // namespace
}  // namespace suture

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "usage: suture_edge_peaks FILE SAMPLES [FACE...]\n";
        return 1;
    }
    std::set<int> faces;
    for (int i = 3; i < argc; ++i) {
        faces.insert(std::atoi(argv[i]));
    }
    return suture::run(argv[1], std::atoi(argv[2]), faces);
}

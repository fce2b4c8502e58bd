#include "suture/check/continuity.h"

#include "suture/check/edge_uses.h"
#include "suture/check/measure_edge.h"
#include "suture/occ/guard.h"

#include <tbb/parallel_for.h>

#include <TopoDS.hxx>

#include <algorithm>

namespace suture {

namespace {

// Edges between two looks at the progress and the user's wish to stop.
constexpr std::size_t kBatch = 256;

/// One edge to measure and its two uses.
struct Job {
    int edge = 0;
    std::array<EdgeInFace, 2> uses;
};

EdgeContinuity run_job(const Job& job, const occ::Numbering& numbering, const Profile& profile) {
    const auto face = [&](int i) { return TopoDS::Face(numbering.faces(job.uses.at(i).face)); };
    auto measured = occ::guarded("measuring the edge", [&] {
        return measure_edge(TopoDS::Edge(numbering.edges(job.edge)), {face(0), face(1)}, job.uses);
    });
    EdgeContinuity result;
    if (measured) {
        result = std::move(*measured);
    } else {
        result.note = measured.error().message;
    }
    result.edge = job.edge;
    result.faces = {job.uses[0].face, job.uses[1].face};
    result.edge_class = classify(result, profile);
    return result;
}

Result<void> check_arguments(const TopoDS_Shape& shape, const Profile& profile) {
    if (shape.IsNull()) {
        return fail(ErrorCode::Usage, "there is no shape to check");
    }
    return validate(profile);
}

}  // namespace

std::string_view to_string(EdgeClass edge_class) {
    switch (edge_class) {
        case EdgeClass::Sharp:
            return "sharp";
        case EdgeClass::G0:
            return "G0";
        case EdgeClass::G1:
            return "G1";
        case EdgeClass::G2:
            return "G2";
        case EdgeClass::G3:
            return "G3";
    }
    return "";
}

EdgeClass classify(const EdgeContinuity& edge, const Profile& profile) {
    const Tolerance& limit = profile.tolerance;
    if (edge.max_angle > profile.sharp) {
        return EdgeClass::Sharp;
    }
    if (edge.samples == 0 || edge.max_gap > limit.linear || edge.max_angle > limit.angular) {
        return EdgeClass::G0;
    }
    const double mismatch = profile.curvature_by == CurvatureMeasure::Larger
                                ? edge.curvature_mismatch
                                : edge.curvature_mismatch_sum;
    if (edge.curvature_samples == 0 || mismatch > limit.curvature) {
        return EdgeClass::G1;
    }
    return edge.g3_samples > 0 && edge.g3_mismatch <= profile.g3 ? EdgeClass::G3 : EdgeClass::G2;
}

Result<ContinuityReport> measure_continuity(const TopoDS_Shape& shape, const Profile& profile,
                                            const std::vector<int>& edges,
                                            const Progress& progress) {
    if (const auto usable = check_arguments(shape, profile); !usable) {
        return tl::unexpected(usable.error());
    }
    const occ::Numbering numbering(shape);
    for (const int edge : edges) {
        if (edge < 1 || edge > numbering.edges.Extent()) {
            return fail(ErrorCode::Usage, "there is no Edge{}: the shape has {} edges", edge,
                        numbering.edges.Extent());
        }
    }
    ContinuityReport report;
    std::vector<Job> jobs;
    const auto all_uses = find_edge_uses(numbering, edges);
    for (int edge = 1; edge <= numbering.edges.Extent(); ++edge) {
        const auto& uses = all_uses[static_cast<std::size_t>(edge - 1)];
        if (uses.size() == 1) {
            report.free_edges.push_back(edge);
        } else if (uses.size() == 2) {
            jobs.push_back({edge, {uses[0], uses[1]}});
        } else if (uses.size() > 2) {
            report.non_manifold.push_back(edge);
        }
    }
    report.edges.resize(jobs.size());
    for (std::size_t begin = 0; begin < jobs.size(); begin += kBatch) {
        if (progress.cancelled()) {
            return fail(ErrorCode::Cancelled, "check stopped after {} of {} edges", begin,
                        jobs.size());
        }
        progress(static_cast<double>(begin) / static_cast<double>(jobs.size()), "checking");
        tbb::parallel_for(begin, std::min(begin + kBatch, jobs.size()), [&](std::size_t i) {
            report.edges[i] = run_job(jobs[i], numbering, profile);
        });
    }
    progress(1.0, "checking");
    return report;
}

}  // namespace suture

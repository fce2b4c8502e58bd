#include "suture/edges/grow.h"

#include "suture/edges/grow_request.h"
#include "suture/occ/guard.h"
#include "suture/occ/isolate.h"
#include "suture/occ/topology.h"
#include "suture/platform/on_demand.h"

namespace suture {
namespace {

Result<GrownShape> run(GrowTask task, const char* what, const TopoDS_Shape& shape,
                       const std::vector<TopoDS_Face>& faces, std::chrono::milliseconds limit,
                       const Progress& progress) {
    static const std::string program = program_on_demand("suture_grow");
    const occ::Numbering before(shape);
    GrowMessage request{task, shape, {}};
    for (const TopoDS_Face& face : faces) {
        request.faces.emplace_back(before.of(face), 0);
    }
    const auto bytes = occ::run_isolated(what, program, packed(request), limit, progress);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    return occ::guarded(what, [&]() -> Result<GrownShape> {
        const GrowMessage answer = unpacked_grow_message(*bytes);
        const occ::Numbering after(answer.shape);
        GrownShape grown{answer.shape, {}};
        for (const auto& [old, now] : answer.faces) {
            grown.replaced.Bind(before.faces(old), after.faces(now));
        }
        return grown;
    });
}

}  // namespace

Result<GrownShape> grow_over(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces,
                             std::chrono::milliseconds limit, const Progress& progress) {
    return run(GrowTask::Remove, "letting the neighbours grow", shape, faces, limit, progress);
}

Result<GrownShape> merge_with_neighbours(const TopoDS_Shape& shape,
                                         const std::vector<TopoDS_Face>& faces,
                                         std::chrono::milliseconds limit,
                                         const Progress& progress) {
    return run(GrowTask::Merge, "merging faces", shape, faces, limit, progress);
}

}  // namespace suture

#include "suture/fill/manifold/guide.h"

#include "suture/fill/mvs.h"

namespace suture::manifold {

Result<GuideSurface> guide_surface(const Hole& hole, const FillOptions& options) {
    FillOptions plain = options;
    plain.own.clear();
    const auto fill = fill_mvs(hole, plain);
    if (!fill) {
        return tl::unexpected(fill.error());
    }
    const Patch& patch = fill->patches.front();
    GuideSurface guide{patch.surface, {}};
    for (const EdgeUse& use : patch.wires.front()) {
        guide.trims.push_back(use.at);
    }
    return guide;
}

}  // namespace suture::manifold

#include "suture/fill/extend.h"

#include "suture/base/contract.h"
#include "suture/fill/extend/trimmed.h"

namespace suture {
namespace {

/// The surface all sides share, or the two sides that differ.
Result<const Support*> common_support(const Hole& hole, const FillOptions& options) {
    const Ribbon& first = hole.loops.front().ribbons.front();
    for (const RibbonLoop& loop : hole.loops) {
        for (const Ribbon& ribbon : loop.ribbons) {
            if (ribbon.face == 0) {
                return fail(ErrorCode::Refused, "{} has no surface to continue", name_of(ribbon));
            }
            if (!ribbon.support) {
                return fail(ErrorCode::Refused, "face {} lies on a surface without a closed form",
                            ribbon.face);
            }
            if (!same_surface(first.support->surface, ribbon.support->surface, ribbon.at(0.5).point,
                              hole.diameter, options.tolerance.linear)) {
                return fail(ErrorCode::Refused,
                            "the neighbours lie on different surfaces: face {} ({}) and face {} "
                            "({})",
                            first.face, kind_name(first.support->surface), ribbon.face,
                            kind_name(ribbon.support->surface));
            }
        }
    }
    return &*first.support;
}

}  // namespace

Result<FillResult> fill_extend(const Hole& hole, const FillOptions& options) {
    SUTURE_EXPECTS(!hole.loops.empty() && !hole.loops.front().ribbons.empty());
    const auto support = common_support(hole, options);
    if (!support) {
        return tl::unexpected(support.error());
    }
    const Surface& surface = (*support)->surface;
    const auto reversed = extend::reversed_on(surface, extend::own_parameters, hole);
    if (!reversed) {
        return tl::unexpected(reversed.error());
    }
    return extend::trimmed(surface, extend::own_parameters, *reversed, hole,
                           options.tolerance.linear);
}

}  // namespace suture

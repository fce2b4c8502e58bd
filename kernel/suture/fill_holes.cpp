#include "suture/fill_holes.h"

#include "suture/flow/compute.h"
#include "suture/flow/plan.h"

namespace suture {

Result<FillOutcome> fill_holes(const TopoDS_Shape& shape, const occ::Numbering& numbering,
                               const FillRequest& request) {
    const auto plan = plan_fills(shape, numbering, request);
    if (!plan) {
        return tl::unexpected(plan.error());
    }
    auto computed = compute_fills(shape, *plan, request);
    if (!computed) {
        return tl::unexpected(computed.error());
    }
    auto outcome = apply_fills(shape, std::move(*computed));
    if (outcome) {
        outcome->holes.insert(outcome->holes.end(), plan->skipped.begin(), plan->skipped.end());
    }
    return outcome;
}

}  // namespace suture

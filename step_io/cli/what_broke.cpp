#include "cli/what_broke.h"

#include "cli/table.h"
#include "suture/check/validity.h"

#include <fmt/format.h>

namespace suture::cli {

std::string what_broke(const TopoDS_Shape& before, const TopoDS_Shape& after) {
    const Validity was = measure_validity(before, ValidityDepth::Valid);
    const Validity is = measure_validity(after, ValidityDepth::Valid);
    if (is.problems.size() > was.problems.size()) {
        return "the result is not valid: " + is.problems.front();
    }
    if (is.free_edges > was.free_edges) {
        return fmt::format("the result is open along {}",
                           counted(is.free_edges - was.free_edges, "edge"));
    }
    return is.solids < was.solids ? "nothing solid is left" : std::string();
}

}  // namespace suture::cli

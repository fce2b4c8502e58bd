#include "suture/model/ribbon.h"

#include <fmt/format.h>

namespace suture {

std::string name_of(const Ribbon& ribbon) {
    if (ribbon.edge == 0) {
        return "a connecting curve";
    }
    if (ribbon.face == 0) {
        return fmt::format("edge {} (no face)", ribbon.edge);
    }
    return fmt::format("edge {} (face {})", ribbon.edge, ribbon.face);
}

}  // namespace suture

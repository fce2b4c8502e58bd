#include "suture/model/ribbon.h"

#include <fmt/format.h>

namespace suture {

std::string name_of(const Ribbon& ribbon) {
    return fmt::format("edge {} (face {})", ribbon.edge, ribbon.face);
}

}  // namespace suture

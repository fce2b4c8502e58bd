#include "suture/choose/report.h"

namespace suture {

std::string_view to_string(FillStatus status) {
    constexpr std::string_view kNames[] = {"filled", "refused", "skipped"};
    return kNames[static_cast<int>(status)];
}

}  // namespace suture

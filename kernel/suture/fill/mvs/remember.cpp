#include "suture/fill/mvs/remember.h"

#include <memory>
#include <unordered_map>

namespace suture::mvs {

Hole remember(const Hole& hole) {
    Hole result = hole;
    for (RibbonLoop& loop : result.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            const auto known = std::make_shared<std::unordered_map<double, RibbonPoint>>();
            ribbon.at = [known, ask = ribbon.at](double s) {
                const auto found = known->find(s);
                return found != known->end() ? found->second
                                             : known->emplace(s, ask(s)).first->second;
            };
        }
    }
    return result;
}

}  // namespace suture::mvs

#include "fuzz/targets/target.h"

#include <cstdio>
#include <cstdlib>

namespace suture::fuzz {

const std::vector<Target>& targets() {
    static const std::vector<Target> all = [] {
        std::vector<Target> result = reader_targets();
        for (Target& target : shape_targets()) {
            result.push_back(std::move(target));
        }
        return result;
    }();
    return all;
}

void broken(const std::string& promise) {
    std::fprintf(stderr, "broken promise: %s\n", promise.c_str());
    std::abort();
}

}  // namespace suture::fuzz

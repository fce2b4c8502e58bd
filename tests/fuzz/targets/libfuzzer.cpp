// LLVM's libFuzzer on the target that SUTURE_FUZZ_TARGET names; tests/fuzz/libfuzzer.sh runs it.
#include "fuzz/targets/target.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace {

const suture::fuzz::Target* chosen = nullptr;

}  // namespace

/// Chooses the target; writes its seeds into SUTURE_FUZZ_SEEDS if that is set.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
    const char* name = std::getenv("SUTURE_FUZZ_TARGET");
    const auto& all = suture::fuzz::targets();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& target) {
        return name != nullptr && std::string(target.name) == name;
    });
    if (found == all.end()) {
        for (const auto& target : all) {
            std::puts(target.name);
        }
        std::exit(name == nullptr ? 0 : 1);
    }
    chosen = &*found;
    if (const char* folder = std::getenv("SUTURE_FUZZ_SEEDS")) {
        for (std::size_t i = 0; i < chosen->seeds.size(); ++i) {
            std::ofstream(std::string(folder) + "/seed-" + std::to_string(i), std::ios::binary)
                << chosen->seeds[i];
        }
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    chosen->run({reinterpret_cast<const char*>(data), size});
    return 0;
}

#include "suture/base/on_demand.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace suture {

void* symbol_on_demand(const char* library, const char* symbol) {
    void* const handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    void* const found = handle ? dlsym(handle, symbol) : nullptr;
    if (!found) {
        const char* const reason = dlerror();
        throw std::runtime_error("the installation is broken: " +
                                 std::string(reason ? reason : library));
    }
    return found;
}

}  // namespace suture

#include "suture/platform/on_demand.h"

#include <dlfcn.h>
#include <link.h>
#include <unistd.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

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

std::string program_on_demand(const char* name) {
    void* const self = dlopen(nullptr, RTLD_LAZY);
    Dl_serinfo size{};
    if (self && dlinfo(self, RTLD_DI_SERINFOSIZE, &size) == 0) {
        std::vector<std::max_align_t> memory(size.dls_size / sizeof(std::max_align_t) + 1);
        auto* const paths = reinterpret_cast<Dl_serinfo*>(memory.data());
        paths->dls_size = size.dls_size;
        paths->dls_cnt = size.dls_cnt;
        if (dlinfo(self, RTLD_DI_SERINFO, paths) == 0) {
            for (unsigned i = 0; i < paths->dls_cnt; ++i) {
                std::string file = std::string(paths->dls_serpath[i].dls_name) + "/" + name;
                if (access(file.c_str(), X_OK) == 0) {
                    return file;
                }
            }
        }
    }
    throw std::runtime_error(std::string("the installation is broken: there is no program ") +
                             name);
}

}  // namespace suture

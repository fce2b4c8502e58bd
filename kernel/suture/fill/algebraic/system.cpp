#include "suture/fill/algebraic/system.h"

#include <queue>

namespace suture::algebraic {

Paths paths_of(const Partition& partition) {
    Paths paths;
    paths.to.resize(static_cast<std::size_t>(partition.cells));
    std::vector<bool> reached(static_cast<std::size_t>(partition.cells), false);
    std::vector<bool> used(partition.interfaces.size(), false);
    std::queue<int> next;
    next.push(0);
    reached[0] = true;
    while (!next.empty()) {
        const int cell = next.front();
        next.pop();
        for (std::size_t j = 0; j < partition.interfaces.size(); ++j) {
            const Interface& interface = partition.interfaces[j];
            if (interface.a != cell && interface.b != cell) {
                continue;
            }
            const bool forwards = interface.a == cell;
            const int beyond = forwards ? interface.b : interface.a;
            if (!reached[static_cast<std::size_t>(beyond)]) {
                reached[static_cast<std::size_t>(beyond)] = true;
                used[j] = true;
                auto& path = paths.to[static_cast<std::size_t>(beyond)];
                path = paths.to[static_cast<std::size_t>(cell)];
                path.push_back({static_cast<int>(j), forwards ? 1 : -1});
                next.push(beyond);
            }
        }
    }
    for (std::size_t j = 0; j < used.size(); ++j) {
        if (!used[j]) {
            paths.closing.push_back(static_cast<int>(j));
        }
    }
    return paths;
}

}  // namespace suture::algebraic

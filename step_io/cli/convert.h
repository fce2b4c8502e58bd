#pragma once

#include "files/write.h"
#include "suture/base/result.h"

#include <optional>

namespace CLI {  // NOLINT: the library's name
class App;
}

namespace suture::cli {

/// The options of mesh outputs as given on the command line: millimetres and degrees.
struct MeshSettings {
    std::optional<double> deflection;
    std::optional<double> angular_deflection;
};

void add_mesh(CLI::App& app, MeshSettings& mesh);
[[nodiscard]] Result<void> validate_mesh(const MeshSettings& mesh);
[[nodiscard]] io::MeshOptions to_io(const MeshSettings& mesh);

}  // namespace suture::cli

#include "cli/text_file.h"

#include "files/atomic_file.h"

#include <fmt/format.h>

#include <system_error>

namespace suture::cli {

namespace fs = std::filesystem;

Result<void> write_text_file(const fs::path& file, std::string_view text) {
    return io::write_atomically(file, [&](std::ostream& stream) -> Result<void> {
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        return {};
    });
}

void remove_temporaries(const fs::path& output, int process) {
    std::error_code error;
    const fs::path folder = fs::weakly_canonical(fs::absolute(output, error), error).parent_path();
    const std::string prefix = fmt::format(".suture-{}-", process);
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().filename().string().starts_with(prefix)) {
            fs::remove(entry.path(), error);
        }
    }
}

}  // namespace suture::cli

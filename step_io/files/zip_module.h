#pragma once

#include <ctime>
#include <string>
#include <string_view>
#include <vector>

namespace suture::io {

struct ZipEntry {
    const char* name = nullptr;
    std::string_view content;
};

struct ZipArchive {
    std::string bytes;
    std::string error;  ///< empty if all went well
};

/// All that calls libzip, which brings a library of cryptography along: a module of its own, loaded
/// only by runs that write 3MF.
/// Every entry is dated `time`, as it stands there.
using MakeZip = ZipArchive(const std::vector<ZipEntry>& entries, const std::tm& time);

}  // namespace suture::io

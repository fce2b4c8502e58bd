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

struct UnpackedNames {
    std::vector<std::string> names;
    std::string error;  ///< empty if all went well
};

struct Unpacked {
    std::string bytes;
    std::string error;  ///< empty if all went well
};

// All that calls libzip, which brings a library of cryptography along, and zlib: a module of its
// own, loaded only by runs that write 3MF or read a packed file.

/// Every entry is dated `time`, as it stands there.
using MakeZip = ZipArchive(const std::vector<ZipEntry>& entries, const std::tm& time);

/// The names of all files in an archive.
using ListZip = UnpackedNames(std::string_view archive);

/// One file of an archive, of at most so many bytes.
using ReadZip = Unpacked(std::string_view archive, const char* name, std::size_t most);

/// What a gzip file holds, of at most so many bytes.
using Gunzip = Unpacked(std::string_view bytes, std::size_t most);

}  // namespace suture::io

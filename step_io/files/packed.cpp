#include "files/packed.h"

#include "files/foreign.h"
#include "files/zip_module.h"
#include "suture/platform/descriptor.h"
#include "suture/platform/on_demand.h"

#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace suture::io {

namespace {

constexpr std::string_view kGzip = "\x1F\x8B";
constexpr std::string_view kZip = "PK\x03\x04";
constexpr const char* kFreecadEntry = "Document.xml";

/// An archive that unpacks to more is a mistake, or meant to harm.
constexpr std::size_t kMostBytes = std::size_t{4} << 30;

template <class Function>
Function* of_module(const char* symbol) {
    return *static_cast<Function* const*>(symbol_on_demand("suture_zip.so", symbol));
}

bool names_model(const std::string& entry) {
    static constexpr std::array kEndings = {".step", ".stp", ".p21",  ".iges",
                                            ".igs",  ".brp", ".brep", ".bbrep"};
    std::string lower(entry);
    std::ranges::transform(lower, lower.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    // ISO 10303-21 edition 3 names the root of an archive so.
    return lower == "iso-10303-21.txt" || std::ranges::any_of(kEndings, [&](const char* ending) {
               return lower.ends_with(ending);
           });
}

Error no_model(const std::filesystem::path& file, const std::vector<std::string>& entries) {
    if (std::ranges::any_of(entries, [](const auto& name) { return name.starts_with("3D/"); })) {
        return {ErrorCode::Unreadable,
                fmt::format("{} {}", file.string(), describe_foreign("file.3mf", {}))};
    }
    if (const std::string what = describe_foreign(file, {}); !what.empty()) {
        return {ErrorCode::Unreadable, fmt::format("{} {}", file.string(), what)};
    }
    return {ErrorCode::Unreadable,
            fmt::format("{} is an archive without a STEP, IGES or BREP file in it", file.string())};
}

Result<std::string> take(Unpacked unpacked, const std::filesystem::path& file) {
    if (!unpacked.error.empty()) {
        return fail(ErrorCode::Unreadable, "{} cannot be unpacked: {}", file.string(),
                    unpacked.error);
    }
    return std::move(unpacked.bytes);
}

Result<std::string> unpack_zip(std::string bytes, const std::filesystem::path& file) {
    const UnpackedNames list = of_module<ListZip>("suture_list_zip")(bytes);
    if (!list.error.empty()) {
        return fail(ErrorCode::Unreadable, "{} cannot be unpacked: {}", file.string(), list.error);
    }
    if (std::ranges::find(list.names, kFreecadEntry) != list.names.end()) {
        return bytes;
    }
    std::vector<std::string> models;
    std::ranges::copy_if(list.names, std::back_inserter(models), names_model);
    if (models.empty()) {
        return tl::unexpected(no_model(file, list.names));
    }
    if (models.size() > 1) {
        constexpr std::size_t kMostNames = 3;
        const std::size_t count = models.size();
        models.resize(std::min(count, kMostNames));
        return fail(ErrorCode::Unreadable, "{} holds {} models ({}{}): unpack it, and give one",
                    file.string(), count, fmt::join(models, ", "),
                    count > kMostNames ? ", ..." : "");
    }
    return unpack_entry(bytes, models.front(), file);
}

}  // namespace

NamedBytes::NamedBytes(std::string_view bytes) : file_(make_memory_file("suture")) {
    while (file_ >= 0 && !bytes.empty()) {
        const ssize_t written = write(file_, bytes.data(), bytes.size());
        if (written < 0) {
            return;
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    if (file_ >= 0) {
        path_ = path_of(file_);
    }
}

NamedBytes::~NamedBytes() {
    if (file_ >= 0) {
        close(file_);
    }
}

bool is_packed(std::string_view bytes) {
    return bytes.starts_with(kGzip) || bytes.starts_with(kZip);
}

bool is_freecad_document(std::string_view bytes) {
    return bytes.starts_with(kZip);
}

Result<std::string> unpack(std::string bytes, const std::filesystem::path& file) {
    if (bytes.starts_with(kGzip)) {
        return take(of_module<Gunzip>("suture_gunzip")(bytes, kMostBytes), file);
    }
    return unpack_zip(std::move(bytes), file);
}

Result<std::string> unpack_entry(std::string_view archive, const std::string& entry,
                                 const std::filesystem::path& file) {
    return take(of_module<ReadZip>("suture_read_zip")(archive, entry.c_str(), kMostBytes), file);
}

}  // namespace suture::io

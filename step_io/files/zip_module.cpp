#include "files/zip_module.h"

#include <zip.h>

#include <algorithm>

namespace suture::io {

namespace {

/// Zip counts in steps of two seconds, from 1980 to 2107.
zip_uint16_t dos_time(const std::tm& time) {
    return static_cast<zip_uint16_t>((time.tm_hour << 11) | (time.tm_min << 5) | (time.tm_sec / 2));
}

zip_uint16_t dos_date(const std::tm& time) {
    constexpr int kFirst = 80;  // of tm_year
    constexpr int kLast = 207;
    const int year = std::clamp(time.tm_year, kFirst, kLast) - kFirst;
    return static_cast<zip_uint16_t>((year << 9) | ((time.tm_mon + 1) << 5) | time.tm_mday);
}

/// A zip archive in memory.
class Archive {
  public:
    Archive()
        : bytes_(zip_source_buffer_create(nullptr, 0, 0, nullptr)),
          zip_(zip_open_from_source(bytes_, ZIP_TRUNCATE, nullptr)) {
        zip_source_keep(bytes_);
    }
    ~Archive() {
        zip_discard(zip_);
        zip_source_free(bytes_);
    }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    void add(const ZipEntry& entry, const std::tm& time) {
        zip_source_t* source =
            zip_source_buffer(zip_, entry.content.data(), entry.content.size(), 0);
        const zip_int64_t index = zip_file_add(zip_, entry.name, source, ZIP_FL_ENC_UTF_8);
        // As in the archive: zip_file_set_mtime would go by the local time.
        good_ = good_ && index >= 0 &&
                zip_file_set_dostime(zip_, static_cast<zip_uint64_t>(index), dos_time(time),
                                     dos_date(time), 0) == 0;
    }

    ZipArchive close() {
        good_ = good_ && zip_close(zip_) == 0;
        if (!good_) {
            return {{}, zip_strerror(zip_)};
        }
        zip_ = nullptr;
        zip_source_open(bytes_);
        zip_source_seek(bytes_, 0, SEEK_END);
        std::string content(static_cast<std::size_t>(zip_source_tell(bytes_)), '\0');
        zip_source_seek(bytes_, 0, SEEK_SET);
        zip_source_read(bytes_, content.data(), content.size());
        zip_source_close(bytes_);
        return {std::move(content), {}};
    }

  private:
    zip_source_t* bytes_;
    zip_t* zip_;
    bool good_ = true;
};

ZipArchive make_zip(const std::vector<ZipEntry>& entries, const std::tm& time) {
    Archive archive;
    for (const ZipEntry& entry : entries) {
        archive.add(entry, time);
    }
    return archive.close();
}

}  // namespace

}  // namespace suture::io

extern "C" {
/// What write_3mf looks for.
extern suture::io::MakeZip* const suture_make_zip;
suture::io::MakeZip* const suture_make_zip = suture::io::make_zip;
}

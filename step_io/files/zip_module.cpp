#include "files/zip_module.h"

#include <zip.h>

namespace suture::io {

namespace {

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

    void add(const ZipEntry& entry) {
        zip_source_t* source =
            zip_source_buffer(zip_, entry.content.data(), entry.content.size(), 0);
        good_ = good_ && zip_file_add(zip_, entry.name, source, ZIP_FL_ENC_UTF_8) >= 0;
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

ZipArchive make_zip(const std::vector<ZipEntry>& entries) {
    Archive archive;
    for (const ZipEntry& entry : entries) {
        archive.add(entry);
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

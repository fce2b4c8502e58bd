#include "files/zip_module.h"

#include <zip.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

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

/// An archive that is read.
class OpenArchive {
  public:
    explicit OpenArchive(std::string_view bytes) {
        zip_error_init(&error_);
        zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error_);
        zip_ = source == nullptr
                   ? nullptr
                   : zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error_);
        if (zip_ == nullptr && source != nullptr) {
            zip_source_free(source);
        }
    }
    ~OpenArchive() {
        if (zip_ != nullptr) {
            zip_discard(zip_);
        }
        zip_error_fini(&error_);
    }
    OpenArchive(const OpenArchive&) = delete;
    OpenArchive& operator=(const OpenArchive&) = delete;

    [[nodiscard]] zip_t* get() const { return zip_; }
    [[nodiscard]] std::string error() {
        return zip_ == nullptr ? zip_error_strerror(&error_) : zip_strerror(zip_);
    }

  private:
    zip_error_t error_{};
    zip_t* zip_ = nullptr;
};

constexpr const char* kTooMuch = "it holds more than Suture takes";

UnpackedNames list_zip(std::string_view bytes) {
    OpenArchive archive(bytes);
    if (archive.get() == nullptr) {
        return {{}, archive.error()};
    }
    UnpackedNames list;
    const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        const char* name = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0);
        list.names.emplace_back(name == nullptr ? "" : name);
    }
    return list;
}

Unpacked read_zip(std::string_view bytes, const char* name, std::size_t most) {
    OpenArchive archive(bytes);
    zip_stat_t about;
    if (archive.get() == nullptr || zip_stat(archive.get(), name, 0, &about) != 0) {
        return {{}, archive.error()};
    }
    if ((about.valid & ZIP_STAT_SIZE) == 0 || about.size > most) {
        return {{}, kTooMuch};
    }
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen(archive.get(), name, 0),
                                                                 zip_fclose);
    if (file == nullptr) {
        return {{}, archive.error()};
    }
    Unpacked result{std::string(about.size, '\0'), {}};
    const zip_int64_t read = zip_fread(file.get(), result.bytes.data(), result.bytes.size());
    char more = 0;  // reading on to the end checks the sum
    const zip_int64_t rest = read < 0 ? read : zip_fread(file.get(), &more, 1);
    if (rest < 0) {
        return {{}, zip_file_strerror(file.get())};
    }
    if (rest > 0 || static_cast<zip_uint64_t>(read) != about.size) {
        return {{}, "its length is not as it says"};
    }
    return result;
}

Unpacked gunzip(std::string_view bytes, std::size_t most) {
    z_stream stream{};
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream, kGzipOnly) != Z_OK) {
        return {{}, "zlib cannot start"};
    }
    const std::unique_ptr<z_stream, int (*)(z_stream*)> ending(&stream, inflateEnd);
    constexpr std::size_t kStep = std::size_t{1} << 20;
    constexpr std::size_t kMostAtOnce = std::numeric_limits<uInt>::max();
    Unpacked result;
    std::size_t taken = 0;
    std::size_t made = 0;
    int state = Z_OK;
    while (true) {
        result.bytes.resize(std::max(made + kStep, result.bytes.size()));
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + taken));
        stream.avail_in = static_cast<uInt>(std::min(bytes.size() - taken, kMostAtOnce));
        stream.next_out = reinterpret_cast<Bytef*>(result.bytes.data() + made);
        stream.avail_out = kStep;
        const uInt before = stream.avail_in;
        state = inflate(&stream, Z_NO_FLUSH);
        taken += before - stream.avail_in;
        made += kStep - stream.avail_out;
        if (made > most) {
            return {{}, kTooMuch};
        }
        if (state == Z_STREAM_END && taken < bytes.size() && bytes[taken] == '\x1F') {
            inflateReset(&stream);  // gzip files may stand one after another
        } else if (state != Z_OK) {
            break;
        }
    }
    if (state != Z_STREAM_END) {
        return {{}, state == Z_BUF_ERROR ? "it is cut off" : "its content is damaged"};
    }
    result.bytes.resize(made);
    return result;
}

}  // namespace

}  // namespace suture::io

extern "C" {
/// What write_3mf and unpack look for.
extern suture::io::MakeZip* const suture_make_zip;
extern suture::io::ListZip* const suture_list_zip;
extern suture::io::ReadZip* const suture_read_zip;
extern suture::io::Gunzip* const suture_gunzip;
suture::io::MakeZip* const suture_make_zip = suture::io::make_zip;
suture::io::ListZip* const suture_list_zip = suture::io::list_zip;
suture::io::ReadZip* const suture_read_zip = suture::io::read_zip;
suture::io::Gunzip* const suture_gunzip = suture::io::gunzip;
}

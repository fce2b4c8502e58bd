#pragma once

#include "files/document.h"
#include "files/read.h"
#include "files/write.h"

#include <gtest/gtest.h>

#include <Quantity_Color.hxx>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace suture::io::test {

/// A folder of its own for each test, gone afterwards.
class Folder {
  public:
    Folder() {
        std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
        std::ranges::replace(test, '/', '-');  // of a test with parameters
        path_ = std::filesystem::temp_directory_path() /
                fmt::format("suture-files-{}-{}", ::getpid(), test);
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
        return path_ / name;
    }
    [[nodiscard]] int files() const {
        return static_cast<int>(std::distance(std::filesystem::directory_iterator(path_),
                                              std::filesystem::directory_iterator()));
    }

  private:
    std::filesystem::path path_;
};

inline std::string content(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

inline void save(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

inline std::filesystem::path cad(const std::string& name) {
    return std::filesystem::path(SUTURE_CAD_DIR) / "files" / name;
}

inline ModelFile read(const std::filesystem::path& file) {
    Result<ModelFile> model = read_model(file, {});
    if (!model) {
        throw std::runtime_error(model.error().message);
    }
    return *std::move(model);
}

inline void write(const ModelFile& model, const std::filesystem::path& file, Format format) {
    const auto done = write_model(model, file, format, {});
    ASSERT_TRUE(done) << done.error().message;
}

/// A model of one part.
inline ModelFile model_of(const TopoDS_Shape& shape, const std::string& name) {
    ModelFile model;
    model.document = make_document();
    set_name(shapes_of(model.document)->AddShape(shape, false), name);
    return model;
}

#define SUTURE_NEEDS_CAD_FILES()                                           \
    if (!std::filesystem::exists(std::filesystem::path(SUTURE_CAD_DIR))) { \
        GTEST_SKIP() << "no CAD files in " SUTURE_CAD_DIR;                 \
    }

}  // namespace suture::io::test

#include "files/write_time.h"

#include "files/file_bytes.h"
#include "files/write.h"

#include "step_io/files/assembly.h"

#include <cstdlib>

namespace suture::io::test {

namespace {

/// SOURCE_DATE_EPOCH for as long as this lives.
class Epoch {
  public:
    explicit Epoch(const char* value) { setenv("SOURCE_DATE_EPOCH", value, 1); }
    ~Epoch() { unsetenv("SOURCE_DATE_EPOCH"); }
    Epoch(const Epoch&) = delete;
    Epoch& operator=(const Epoch&) = delete;
};

std::string bytes_of(Format format, const std::string& name) {
    const Folder folder;
    const ModelFile model = two_level_assembly();
    const auto written = write_model(model, folder / name, format, MeshOptions());
    return written ? read_bytes(folder / name).value() : written.error().message;
}

}  // namespace

TEST(WriteTime, IsThatOfTheEnvironment) {
    const Epoch epoch("951827696");  // 2000-02-29 12:34:56
    const auto time = time_of_writing();
    ASSERT_TRUE(time);
    EXPECT_EQ(step_time(*time), "2000-02-29T12:34:56");
    EXPECT_EQ(iges_time(*time), "20000229.123456");
}

TEST(WriteTime, IsNowWithoutTheEnvironment) {
    unsetenv("SOURCE_DATE_EPOCH");
    const std::time_t before = std::time(nullptr);
    auto time = time_of_writing();
    ASSERT_TRUE(time);
    const std::time_t found = timegm(&*time);
    EXPECT_GE(found, before);
    EXPECT_LE(found, std::time(nullptr));
}

TEST(WriteTime, RefusesWhatIsNoTime) {
    for (const char* value : {"", "yesterday", "-1", "12.5", "1 ", "99999999999999999999"}) {
        const Epoch epoch(value);
        const auto time = time_of_writing();
        ASSERT_FALSE(time) << value;
        EXPECT_EQ(time.error().code, ErrorCode::Usage);
        EXPECT_NE(time.error().message.find("SOURCE_DATE_EPOCH"), std::string::npos);
    }
}

TEST(WriteTime, MakesTheSameBytesInEveryFormat) {
    for (const auto& [format, name] :
         {std::pair(Format::Step, "a.step"), std::pair(Format::Iges, "a.iges"),
          std::pair(Format::BrepText, "a.brep"), std::pair(Format::BrepFreecad, "a.bin"),
          std::pair(Format::Stl, "a.stl"), std::pair(Format::Off, "a.off"),
          std::pair(Format::Obj, "a.obj"), std::pair(Format::ThreeMf, "a.3mf"),
          std::pair(Format::Gltf, "a.glb")}) {
        std::string early;
        {
            const Epoch epoch("951827696");
            early = bytes_of(format, name);
            // Several times: addresses decide about the order of tables in OCCT.
            for (int k = 0; k < 5; ++k) {
                EXPECT_TRUE(early == bytes_of(format, name)) << name;
            }
        }
        const Epoch epoch("982368000");
        const bool dated =
            format == Format::Step || format == Format::Iges || format == Format::ThreeMf;
        EXPECT_EQ(bytes_of(format, name) != early, dated) << name;
    }
}

TEST(WriteTime, IsNotThatOfTheTimeZone) {
    const Epoch epoch("951827696");
    setenv("TZ", "Asia/Tokyo", 1);
    tzset();
    const std::string east = bytes_of(Format::ThreeMf, "a.3mf");
    setenv("TZ", "America/New_York", 1);
    tzset();
    const std::string west = bytes_of(Format::ThreeMf, "a.3mf");
    unsetenv("TZ");
    tzset();
    EXPECT_TRUE(east == west);
}

}  // namespace suture::io::test

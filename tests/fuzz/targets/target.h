#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What is given arbitrary bytes: one reader, or one step of the flow.
namespace suture::fuzz {

struct Target {
    const char* name;
    /// Must return; what it must not do, besides crashing, it says by `broken`.
    void (*run)(std::string_view bytes);
    std::vector<std::string> seeds;  ///< inputs that go far
};

[[nodiscard]] const std::vector<Target>& targets();
[[nodiscard]] std::vector<Target> reader_targets();
[[nodiscard]] std::vector<Target> shape_targets();

/// Ends the process: a promise is broken.
[[noreturn]] void broken(const std::string& promise);

/// Bytes as numbers; zeros when they have run out.
class Bytes {
  public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

    [[nodiscard]] int byte() {
        return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : 0;
    }
    [[nodiscard]] int from(int low, int high) { return low + byte() % (high - low + 1); }
    /// In [-1, 1], in steps of 1/127.
    [[nodiscard]] double unit() { return (byte() - 128) / 127.0; }
    [[nodiscard]] bool empty() const { return at_ >= bytes_.size(); }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

}  // namespace suture::fuzz

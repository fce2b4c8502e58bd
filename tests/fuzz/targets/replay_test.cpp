// Without a fuzzer: what once broke a target, and seeds that are damaged in the same way every
// time.
#include "fuzz/targets/target.h"
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

namespace suture::fuzz {
namespace {

namespace fs = std::filesystem;

std::string damaged(std::string bytes, std::mt19937& random) {
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    for (std::size_t times = 1 + below(4); times > 0; --times) {
        const std::size_t at = below(bytes.size() + 1);
        switch (below(5)) {
            case 0:
                bytes.insert(at, 1, static_cast<char>(below(256)));
                break;
            case 1:
                bytes = bytes.substr(0, at) + bytes.substr(std::min(bytes.size(), at + below(9)));
                break;
            case 2:
                bytes.insert(at, bytes.substr(below(bytes.size() + 1), below(40)));
                break;
            case 3: {
                static const std::vector<std::string> kWild = {
                    "nan", "1e999", "-1",  "99999999999999999999", "'", "\"", "/*",
                    "#",   "(((",   "\xff"};
                bytes.insert(at, kWild.at(below(kWild.size())));
                break;
            }
            default:
                if (at < bytes.size()) {
                    bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
                }
        }
    }
    return bytes;
}

class Fuzzed : public testing::TestWithParam<std::size_t> {};

TEST_P(Fuzzed, KeepsItsPromisesOnDamagedSeeds) {
    const Target& target = targets().at(GetParam());
    const bool slow = std::string_view(target.name) == "faces";
    std::mt19937 random(24);
    for (const std::string& seed : target.seeds) {
        target.run(seed);
        for (int number = 0; number < (slow ? 40 : 400) / SUTURE_TEST_SLOWDOWN; ++number) {
            target.run(damaged(seed, random));
        }
    }
}

TEST_P(Fuzzed, KeepsItsPromisesOnWhatOnceBrokeIt) {
    const Target& target = targets().at(GetParam());
    const fs::path corpus = fs::path(SUTURE_SOURCE_DIR) / "tests/fuzz/corpus/targets" / target.name;
    target.run({});
    if (!fs::is_directory(corpus)) {
        return;
    }
    for (const auto& entry : fs::directory_iterator(corpus)) {
        std::ifstream file(entry.path(), std::ios::binary);
        target.run(std::string(std::istreambuf_iterator<char>(file), {}));
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzzed, testing::Range(std::size_t{0}, targets().size()),
                         [](const auto& target) { return targets().at(target.param).name; });

TEST(FuzzedDeathTest, ABrokenPromiseEndsTheProcess) {
    EXPECT_DEATH(broken("something"), "broken promise: something");
}

}  // namespace
}  // namespace suture::fuzz

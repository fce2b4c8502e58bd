#include "files/iges_text.h"

#include <array>
#include <charconv>

namespace suture::io {

namespace {

constexpr std::size_t kSection = 72;  // column 73 names a line's section
constexpr std::string_view kSections = "SGDP";

struct LineCounts {
    std::array<long, 4> counted{};
    std::array<long, 4> stated{};
    bool terminated = false;
};

/// The last line: S, G, D, P, each followed by its section's number of lines in seven columns.
void read_terminator(std::string_view line, LineCounts& lines) {
    constexpr std::size_t kField = 8;
    lines.terminated = true;
    for (std::size_t section = 0; section < kSections.size(); ++section) {
        std::string_view field = line.substr(section * kField, kField);
        lines.terminated = lines.terminated && field.front() == kSections[section];
        field.remove_prefix(std::min(field.size(), field.find_first_of("0123456789")));
        std::from_chars(field.data(), field.data() + field.size(), lines.stated[section]);
    }
}

LineCounts count_lines(std::string_view text) {
    LineCounts lines;
    while (!text.empty() && !lines.terminated) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        if (line.size() <= kSection) {
            continue;
        }
        if (line[kSection] == 'T') {
            read_terminator(line, lines);
        } else if (const std::size_t s = kSections.find(line[kSection]); s != kSections.npos) {
            ++lines.counted[s];
        }
    }
    return lines;
}

}  // namespace

Result<void> check_iges_text(std::string_view text, const std::filesystem::path& file) {
    const LineCounts lines = count_lines(text);
    if (!lines.terminated) {
        return fail(ErrorCode::Unreadable, "{} is cut off: its last line, of section T, is missing",
                    file.string());
    }
    for (std::size_t section = 0; section < kSections.size(); ++section) {
        if (lines.counted[section] != lines.stated[section]) {
            return fail(ErrorCode::Unreadable,
                        "{} is damaged: section {} has {} lines, and its last line states {}",
                        file.string(), kSections[section], lines.counted[section],
                        lines.stated[section]);
        }
    }
    return {};
}

}  // namespace suture::io

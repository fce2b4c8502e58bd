#include "cli/json_file.h"

#include "files/file_bytes.h"

namespace suture::cli {

Result<nlohmann::ordered_json> read_json(const std::filesystem::path& file) {
    using Json = nlohmann::ordered_json;
    constexpr std::size_t kMostBytes = 1 << 20;
    constexpr int kDeepest = 32;  // printing a document is recursive
    const Result<std::string> text = io::read_bytes(file, kMostBytes);
    if (!text) {
        return tl::unexpected(text.error());
    }
    bool too_deep = false;
    const Json::parser_callback_t look = [&](int depth, Json::parse_event_t /*event*/, Json&) {
        too_deep = too_deep || depth > kDeepest;
        return !too_deep;
    };
    Json document = Json::parse(*text, look, /*allow_exceptions=*/false);
    if (too_deep) {
        return fail(ErrorCode::Unreadable, "{}: its JSON is nested more than {} deep",
                    file.string(), kDeepest);
    }
    if (document.is_discarded()) {
        return fail(ErrorCode::Unreadable, "{}: it is no JSON document", file.string());
    }
    return document;
}

}  // namespace suture::cli

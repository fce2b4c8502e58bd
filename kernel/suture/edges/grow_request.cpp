#include "suture/edges/grow_request.h"

#include <BinTools.hxx>

#include <sstream>

namespace suture {

// Both processes are of one build: numbers are as they lie in memory.
std::string packed(const GrowMessage& message) {
    std::ostringstream out;
    out.write(reinterpret_cast<const char*>(&message.task), sizeof message.task);
    const std::size_t count = message.faces.size();
    out.write(reinterpret_cast<const char*>(&count), sizeof count);
    for (const auto& [one, other] : message.faces) {
        out.write(reinterpret_cast<const char*>(&one), sizeof one);
        out.write(reinterpret_cast<const char*>(&other), sizeof other);
    }
    BinTools::Write(message.shape, out);
    return out.str();
}

GrowMessage unpacked_grow_message(const std::string& bytes) {
    std::istringstream in(bytes);
    GrowMessage message;
    in.read(reinterpret_cast<char*>(&message.task), sizeof message.task);
    std::size_t count = 0;
    in.read(reinterpret_cast<char*>(&count), sizeof count);
    message.faces.resize(count);
    for (auto& [one, other] : message.faces) {
        in.read(reinterpret_cast<char*>(&one), sizeof one);
        in.read(reinterpret_cast<char*>(&other), sizeof other);
    }
    BinTools::Read(message.shape, in);
    return message;
}

}  // namespace suture

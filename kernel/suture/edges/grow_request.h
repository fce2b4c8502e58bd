#pragma once

#include <TopoDS_Shape.hxx>

#include <string>
#include <utility>
#include <vector>

namespace suture {

/// What the program suture_grow does with faces of a shape.
enum class GrowTask {
    Remove,  ///< takes them away and lets their neighbours meet
    Merge,   ///< makes them one with neighbours on the same surface
};

/// What the program suture_grow is asked and answers: a shape and numbers of its faces, 1-based as
/// FaceN. In a request `faces` holds those that the task is for; in an answer pairs: a face that
/// was there, and what it is in the shape that was made.
struct GrowMessage {
    GrowTask task = GrowTask::Remove;
    TopoDS_Shape shape;
    std::vector<std::pair<int, int>> faces;
};

[[nodiscard]] std::string packed(const GrowMessage& message);
[[nodiscard]] GrowMessage unpacked_grow_message(const std::string& bytes);

}  // namespace suture

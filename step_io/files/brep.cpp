#include "files/brep.h"

#include "suture/occ/guard.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_LocationSet.hxx>
#include <BinTools_ShapeSet.hxx>

#include <algorithm>
#include <cctype>
#include <new>
#include <sstream>

namespace suture::io {

namespace {

/// After the shape set: one byte and two integers (OCCT) or three integers (FreeCAD).
constexpr std::streamoff kOcctEnding = 9;
constexpr std::streamoff kFreecadEnding = 12;

/// Takes the last line that is not blank off a text.
std::string take_last_line(std::string_view& text) {
    text.remove_suffix(text.size() - std::min(text.size(), text.find_last_not_of(" \r\n\t") + 1));
    const std::size_t line = text.find_last_of("\n\r");
    const std::size_t begin = line == text.npos ? 0 : line + 1;
    std::string last(text.substr(begin));
    text.remove_suffix(text.size() - begin);
    return last;
}

/// The last line says which of the shapes is the file's: orientation and number, then the number of
/// its location. It is the first thing that a cut takes away. DRAW's `save` writes one line with a
/// 0 after it: the end of its own list.
bool has_text_ending(const std::string& bytes) {
    std::string_view text = bytes;
    std::string line = take_last_line(text);
    if (line == "0") {
        line = take_last_line(text);
    }
    std::istringstream last(line);
    char orientation = 0;
    int shape = 0;
    int location = -1;
    last >> orientation >> shape >> location;
    return std::string_view("+-ie").find(orientation) != std::string_view::npos && shape > 0 &&
           location >= 0 && (last >> std::ws).eof();
}

/// What OCCT makes of a file: where it makes nothing, or raises something, the file is damaged.
template <class Read>
Result<TopoDS_Shape> made_by_occt(const std::filesystem::path& file, const Read& read) {
    bool told = false;  // the reason is known
    auto shape = occ::guarded("reading", [&]() -> Result<TopoDS_Shape> {
        try {
            auto result = read();
            told = !result;
            return result;
        } catch (const std::bad_alloc&) {
            told = true;
            throw;
        }
    });
    if (!told && (!shape || shape->IsNull())) {
        return fail(ErrorCode::Unreadable, "{} is damaged: OCCT makes no shape of it",
                    file.string());
    }
    return shape;
}

/// Near which line of a text its reader found something else than it needed.
std::string where_it_failed(const std::string& bytes, std::istringstream& stream) {
    stream.exceptions(std::ios::goodbit);
    const bool at_end = stream.eof();
    stream.clear();
    const std::streamoff position = stream.tellg();
    if (at_end || position < 0) {
        return "it ends too early";
    }
    return fmt::format("what stands in line {} is not what should be there",
                       1 + std::count(bytes.begin(), bytes.begin() + position, '\n'));
}

/// The last list of sub-shapes ends in '*', right before either ending.
bool has_binary_ending(const std::string& bytes) {
    const auto ends_list = [&](std::streamoff ending) {
        const auto from_end = static_cast<std::size_t>(ending) + 1;
        return bytes.size() > from_end && bytes[bytes.size() - from_end] == '*';
    };
    return ends_list(kOcctEnding) || ends_list(kFreecadEnding);
}

TopoDS_Shape read_freecad_ending(BinTools_ShapeSet& shapes, std::istream& stream) {
    int shape = 0;
    int location = 0;
    int orientation = 0;
    BinTools::GetInteger(stream, shape);
    BinTools::GetInteger(stream, location);
    BinTools::GetInteger(stream, orientation);
    if (!stream || shape < 1 || shape > shapes.NbShapes() || location < 0 ||
        location > shapes.Locations().NbLocations() || orientation < TopAbs_FORWARD ||
        orientation > TopAbs_EXTERNAL) {
        return {};
    }
    TopoDS_Shape result = shapes.Shape(shape);
    result.Location(shapes.Locations().Location(location));
    result.Orientation(static_cast<TopAbs_Orientation>(orientation));
    return result;
}

}  // namespace

Result<TopoDS_Shape> read_brep_text(const std::string& bytes, const std::filesystem::path& file) {
    if (!has_text_ending(bytes)) {
        return fail(ErrorCode::Unreadable,
                    "{} is cut off: its last line, which names the shape, is missing",
                    file.string());
    }
    std::istringstream stream(bytes);
    // OCCT's reader asks a stream that has failed for more, in some places for ever.
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    return made_by_occt(file, [&]() -> Result<TopoDS_Shape> {
        TopoDS_Shape shape;
        try {
            BRepTools::Read(shape, stream, BRep_Builder());
        } catch (const std::ios::failure&) {
            return fail(ErrorCode::Unreadable, "{} is damaged: {}", file.string(),
                        where_it_failed(bytes, stream));
        }
        return shape;
    });
}

Result<TopoDS_Shape> read_brep_binary(const std::string& bytes, const std::filesystem::path& file) {
    if (!has_binary_ending(bytes)) {
        return fail(ErrorCode::Unreadable,
                    "{} is cut off: its last bytes, which name the shape, are missing",
                    file.string());
    }
    std::istringstream stream(bytes, std::ios::binary);
    return made_by_occt(file, [&]() -> Result<TopoDS_Shape> {
        BinTools_ShapeSet shapes;
        shapes.Read(stream);
        const std::streamoff left = static_cast<std::streamoff>(bytes.size()) - stream.tellg();
        TopoDS_Shape shape;
        if (stream && left == kFreecadEnding) {
            shape = read_freecad_ending(shapes, stream);
        } else if (stream && left == kOcctEnding) {
            shapes.ReadSubs(shape, stream, shapes.NbShapes());
        } else {
            return fail(ErrorCode::Unreadable, "{} is damaged: after its shapes it ends {}",
                        file.string(), stream ? fmt::format("in {} bytes", left) : "too early");
        }
        return shape;
    });
}

Result<void> write_brep_text(const TopoDS_Shape& shape, std::ostream& stream) {
    BRepTools::Write(shape, stream, false, false, TopTools_FormatVersion_VERSION_1);
    return {};
}

Result<void> write_brep_binary(const TopoDS_Shape& shape, std::ostream& stream) {
    BinTools::Write(shape, stream, false, false, BinTools_FormatVersion_VERSION_3);
    return {};
}

Result<void> write_brep_freecad(const TopoDS_Shape& shape, std::ostream& stream) {
    BinTools_ShapeSet shapes;
    shapes.SetWithTriangles(false);
    shapes.SetFormatNb(BinTools_FormatVersion_VERSION_3);
    const int number = shapes.Add(shape);
    const int location = shapes.Locations().Index(shape.Location());
    shapes.Write(stream);
    BinTools::PutInteger(stream, number);
    BinTools::PutInteger(stream, location);
    BinTools::PutInteger(stream, shape.Orientation());
    return {};
}

}  // namespace suture::io

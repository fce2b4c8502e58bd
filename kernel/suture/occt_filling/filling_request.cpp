#include "suture/occt_filling/filling_request.h"

#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <cstddef>
#include <sstream>
#include <type_traits>

namespace suture {
namespace {

/// Both processes are of one build: bytes are as they lie in memory.
template <class T>
void put(std::ostream& out, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    out.write(reinterpret_cast<const char*>(&value), sizeof(T));
}

template <class T>
T get(std::istream& in) {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    in.read(reinterpret_cast<char*>(&value), sizeof(T));
    return value;
}

void put_text(std::ostream& out, const std::string& text) {
    put(out, text.size());
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

std::string get_text(std::istream& in) {
    std::string text(get<std::size_t>(in), '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    return text;
}

}  // namespace

std::string packed(const PlateRequest& request) {
    std::ostringstream out;
    put(out, request.arguments);
    put(out, request.through.size());
    for (const gp_Pnt& point : request.through) {
        put(out, point.X());
        put(out, point.Y());
        put(out, point.Z());
    }
    put(out, request.sides.size());
    const BRep_Builder builder;
    TopoDS_Compound shapes;
    builder.MakeCompound(shapes);
    for (const PlateSide& side : request.sides) {
        put(out, side.constraint);
        put_text(out, side.name);
        put(out, side.face.IsNull());
        builder.Add(shapes, side.edge);
        if (!side.face.IsNull()) {
            builder.Add(shapes, side.face);
        }
    }
    BinTools::Write(shapes, out);
    return out.str();
}

PlateRequest unpacked_request(const std::string& bytes) {
    std::istringstream in(bytes);
    PlateRequest request;
    request.arguments = get<PlateArguments>(in);
    request.through.resize(get<std::size_t>(in));
    for (gp_Pnt& point : request.through) {
        const auto x = get<double>(in);
        const auto y = get<double>(in);
        point = gp_Pnt(x, y, get<double>(in));
    }
    request.sides.resize(get<std::size_t>(in));
    std::vector<bool> faceless;
    for (PlateSide& side : request.sides) {
        side.constraint = get<GeomAbs_Shape>(in);
        side.name = get_text(in);
        faceless.push_back(get<bool>(in));
    }
    TopoDS_Shape shapes;
    BinTools::Read(shapes, in);
    TopoDS_Iterator next(shapes);
    for (std::size_t i = 0; i < request.sides.size(); ++i) {
        request.sides[i].edge = TopoDS::Edge(next.Value());
        next.Next();
        if (!faceless[i]) {
            request.sides[i].face = TopoDS::Face(next.Value());
            next.Next();
        }
    }
    return request;
}

std::string packed(const TopoDS_Compound& made) {
    std::ostringstream bytes;
    BinTools::Write(made, bytes);
    return bytes.str();
}

TopoDS_Shape unpacked_shape(const std::string& bytes) {
    std::istringstream stream(bytes);
    TopoDS_Shape shape;
    BinTools::Read(shape, stream);
    return shape;
}

}  // namespace suture

#pragma once

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace suture {

/// Facts about a shape as a B-rep.
struct Validity {
    bool valid = false;    ///< BRepCheck finds nothing
    bool closed = false;   ///< every shell is closed: no free edges
    int solids = 0;
    int shells = 0;
    int faces = 0;
    int free_edges = 0;
    double max_tolerance = 0.0;
    double volume = 0.0;   ///< of the solids; positive where the normals point outwards
    std::vector<std::string> problems;  ///< what BRepCheck says, each with its FaceN or EdgeN
};

[[nodiscard]] Validity measure_validity(const TopoDS_Shape& shape);

}  // namespace suture

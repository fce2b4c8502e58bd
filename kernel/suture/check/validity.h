#pragma once

#include <TopoDS_Shape.hxx>

#include <optional>
#include <string>
#include <vector>

namespace suture {

/// How much of a shape's validity to look at.
enum class ValidityDepth {
    Full,
    Valid,     ///< without the volume, which can take longer than writing the model
    Topology,  ///< without BRepCheck as well
};

/// Facts about a shape as a B-rep.
struct Validity {
    bool checked = false;  ///< BRepCheck was run
    bool valid = false;    ///< BRepCheck was run and finds nothing
    bool closed = false;   ///< there are faces and no free edges
    int solids = 0;
    int shells = 0;
    int faces = 0;
    int free_edges = 0;
    double max_tolerance = 0.0;    ///< of any vertex, edge or face
    std::optional<double> volume;  ///< of the solids, by OCCT's GProp; positive if normals point
                                   ///< outwards; none: not Full
    std::vector<std::string> problems;  ///< what BRepCheck says, each with its FaceN or EdgeN
};

/// Runs on all cores. Where OCCT fails itself, that is one of the problems.
[[nodiscard]] Validity measure_validity(const TopoDS_Shape& shape,
                                        ValidityDepth depth = ValidityDepth::Full);

}  // namespace suture

#include "suture/check/brepcheck_problems.h"

#include <fmt/format.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <string_view>

namespace suture {

namespace {

std::string_view words(BRepCheck_Status status) {
    switch (status) {
        case BRepCheck_NoError:
            return "";
        case BRepCheck_InvalidPointOnCurve:
            return "vertex is off the edge's curve";
        case BRepCheck_InvalidPointOnCurveOnSurface:
            return "vertex is off the edge's curve on the surface";
        case BRepCheck_InvalidPointOnSurface:
            return "vertex is off the surface";
        case BRepCheck_No3DCurve:
            return "no 3D curve";
        case BRepCheck_Multiple3DCurve:
            return "more than one 3D curve";
        case BRepCheck_Invalid3DCurve:
            return "invalid 3D curve";
        case BRepCheck_NoCurveOnSurface:
            return "no curve on the surface";
        case BRepCheck_InvalidCurveOnSurface:
            return "curve on the surface is off the edge";
        case BRepCheck_InvalidCurveOnClosedSurface:
            return "curves on the closed surface are off the edge";
        case BRepCheck_InvalidSameRangeFlag:
            return "curves have different ranges";
        case BRepCheck_InvalidSameParameterFlag:
            return "curves have different parameters";
        case BRepCheck_InvalidDegeneratedFlag:
            return "wrongly marked as degenerated";
        case BRepCheck_FreeEdge:
            return "free edge";
        case BRepCheck_InvalidMultiConnexity:
            return "edge of too many faces";
        case BRepCheck_InvalidRange:
            return "invalid range";
        case BRepCheck_EmptyWire:
            return "empty wire";
        case BRepCheck_RedundantEdge:
            return "redundant edge";
        case BRepCheck_SelfIntersectingWire:
            return "self-intersecting wire";
        case BRepCheck_NoSurface:
            return "no surface";
        case BRepCheck_InvalidWire:
            return "invalid wire";
        case BRepCheck_RedundantWire:
            return "redundant wire";
        case BRepCheck_IntersectingWires:
            return "intersecting wires";
        case BRepCheck_InvalidImbricationOfWires:
            return "wires are nested wrongly";
        case BRepCheck_EmptyShell:
            return "empty shell";
        case BRepCheck_RedundantFace:
            return "redundant face";
        case BRepCheck_InvalidImbricationOfShells:
            return "shells are nested wrongly";
        case BRepCheck_UnorientableShape:
            return "cannot be oriented";
        case BRepCheck_NotClosed:
            return "not closed";
        case BRepCheck_NotConnected:
            return "not connected";
        case BRepCheck_SubshapeNotInShape:
            return "subshape is not part of the shape";
        case BRepCheck_BadOrientation:
            return "bad orientation";
        case BRepCheck_BadOrientationOfSubshape:
            return "bad orientation of a subshape";
        case BRepCheck_InvalidPolygonOnTriangulation:
            return "polygon is off the triangulation";
        case BRepCheck_InvalidToleranceValue:
            return "invalid tolerance";
        case BRepCheck_EnclosedRegion:
            return "enclosed region";
        case BRepCheck_CheckFail:
            return "the check itself failed";
    }
    return "unknown problem";
}

/// Names shapes by kind and 1-based number, as FreeCAD does.
class Namer {
  public:
    explicit Namer(const TopoDS_Shape& shape, const occ::Numbering& numbering)
        : numbering_(numbering) {
        TopExp::MapShapes(shape, TopAbs_WIRE, wires_);
        TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
        TopExp::MapShapes(shape, TopAbs_SHELL, shells_);
        TopExp::MapShapes(shape, TopAbs_SOLID, solids_);
    }

    [[nodiscard]] std::string operator()(const TopoDS_Shape& shape) const {
        switch (shape.ShapeType()) {
            case TopAbs_FACE:
                return fmt::format("Face{}", numbering_.faces.FindIndex(shape));
            case TopAbs_EDGE:
                return fmt::format("Edge{}", numbering_.edges.FindIndex(shape));
            case TopAbs_WIRE:
                return fmt::format("Wire{}", wires_.FindIndex(shape));
            case TopAbs_VERTEX:
                return fmt::format("Vertex{}", vertices_.FindIndex(shape));
            case TopAbs_SHELL:
                return fmt::format("Shell{}", shells_.FindIndex(shape));
            case TopAbs_SOLID:
                return fmt::format("Solid{}", solids_.FindIndex(shape));
            default:
                return "Compound";
        }
    }

  private:
    const occ::Numbering& numbering_;
    TopTools_IndexedMapOfShape wires_, vertices_, shells_, solids_;
};

void add_problems(const BRepCheck_ListOfStatus& list, const std::string& where,
                  std::vector<std::string>& problems) {
    for (const BRepCheck_Status status : list) {
        if (status == BRepCheck_NoError) {
            continue;
        }
        auto problem = fmt::format("{}: {}", where, words(status));
        if (std::ranges::find(problems, problem) == problems.end()) {
            problems.push_back(std::move(problem));
        }
    }
}

}  // namespace

std::vector<std::string> find_brepcheck_problems(const TopoDS_Shape& shape,
                                                 const occ::Numbering& numbering) {
    const BRepCheck_Analyzer analyzer(shape, /*GeomControls=*/Standard_True,
                                      /*theIsParallel=*/Standard_True);
    std::vector<std::string> problems;
    if (analyzer.IsValid()) {
        return problems;
    }
    const Namer name(shape, numbering);
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(shape, all);
    for (const auto kind :
         {TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE, TopAbs_WIRE, TopAbs_EDGE, TopAbs_VERTEX}) {
        for (int i = 1; i <= all.Extent(); ++i) {
            if (all(i).ShapeType() != kind) {
                continue;
            }
            const auto& result = analyzer.Result(all(i));
            if (result.IsNull()) {
                continue;
            }
            add_problems(result->Status(), name(all(i)), problems);
            for (result->InitContextIterator(); result->MoreShapeInContext();
                 result->NextShapeInContext()) {
                add_problems(result->StatusOnShape(),
                             name(all(i)) + " in " + name(result->ContextualShape()), problems);
            }
        }
    }
    if (problems.empty()) {
        problems.emplace_back("BRepCheck finds the shape invalid without saying where");
    }
    return problems;
}

}  // namespace suture

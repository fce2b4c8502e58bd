#pragma once

#include <TopoDS_Shape.hxx>

namespace suture {

/// Gives each open shell its own side of the walls that it shares with others.
///
/// Two bodies with a wall between them are often written with that wall in one of them alone; the
/// edges around it are common. The other one then looks open there. A face of another shell is such
/// a wall if most of its edges are free edges of the open shell. It gets a face of its own, the
/// other way around, on the same edges.
struct Walls {
    TopoDS_Shape shape;  ///< the input where there is no such wall
    int count = 0;
};
[[nodiscard]] Walls give_walls(const TopoDS_Shape& shape);

}  // namespace suture

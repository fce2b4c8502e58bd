#include "suture/faces/make_shell.h"

#include "suture/faces/make_faces.h"
#include "suture/occ/guard.h"

#include <Eigen/Geometry>

#include <BRep_Builder.hxx>

namespace suture {

Result<TopoDS_Shell> make_shell(const FillResult& sheet) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : sheet.inner_vertices) {
        box.extend(vertex);
    }
    Hole none;
    none.diameter = box.diagonal().norm();
    const auto made = make_faces({}, none, sheet);
    if (!made) {
        return tl::unexpected(made.error());
    }
    return occ::guarded("making a shell", [&]() -> Result<TopoDS_Shell> {
        const BRep_Builder builder;
        TopoDS_Shell shell;
        builder.MakeShell(shell);
        for (const TopoDS_Face& face : made->faces) {
            builder.Add(shell, face);
        }
        return shell;
    });
}

FillResult without_hole(FillResult fill, const std::vector<std::vector<Eigen::Vector3d>>& corners) {
    std::vector<int> first_corner, first_side;  // of each loop
    for (const std::vector<Eigen::Vector3d>& loop : corners) {
        first_corner.push_back(static_cast<int>(fill.inner_vertices.size()));
        fill.inner_vertices.insert(fill.inner_vertices.end(), loop.begin(), loop.end());
    }
    const auto freed = [&](const Node& node) {
        return node.loop < 0
                   ? node
                   : Node{-1, first_corner[static_cast<std::size_t>(node.loop)] + node.index};
    };
    for (InnerEdge& edge : fill.inner_edges) {
        edge = {freed(edge.from), freed(edge.to)};
    }
    for (std::size_t l = 0; l < corners.size(); ++l) {
        first_side.push_back(static_cast<int>(fill.inner_edges.size()));
        const int n = static_cast<int>(corners[l].size());
        for (int i = 0; i < n; ++i) {
            fill.inner_edges.push_back(
                {freed({static_cast<int>(l), i}), freed({static_cast<int>(l), (i + 1) % n})});
        }
    }
    for (Patch& patch : fill.patches) {
        for (std::vector<EdgeUse>& wire : patch.wires) {
            for (EdgeUse& use : wire) {
                if (use.loop >= 0) {
                    use.index += first_side[static_cast<std::size_t>(use.loop)];
                    use.loop = -1;
                }
            }
        }
    }
    return fill;
}

}  // namespace suture

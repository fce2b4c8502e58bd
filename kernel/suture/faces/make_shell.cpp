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

}  // namespace suture

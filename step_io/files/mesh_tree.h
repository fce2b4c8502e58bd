#pragma once

#include "files/mesh.h"
#include "files/model_file.h"
#include "suture/base/result.h"

#include <gp_Trsf.hxx>

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace suture::io {

/// An object in its place.
struct MeshInstance {
    std::size_t object = 0;
    std::string name;
    gp_Trsf place;
};

/// A part with its triangles, or an assembly with what it holds.
struct MeshObject {
    std::string name;
    Mesh mesh;
    std::vector<int>
        colours;  ///< of each triangle, in MeshTree::colours; -1: none. Empty: none at all
    std::vector<MeshInstance> children;
};

/// A model as meshes: every part once, however often it stands in the assembly tree.
struct MeshTree {
    std::vector<std::array<double, 4>> colours;  ///< red, green, blue (sRGB), opacity, in [0, 1]
    std::vector<MeshObject> objects;             ///< what an assembly holds before the assembly
    std::vector<MeshInstance> roots;
};

/// Meshes every part by itself, all with the deflection that the whole model asks for.
///
/// Refuses  as make_mesh
[[nodiscard]] Result<MeshTree> make_mesh_tree(const ModelFile& model, const MeshOptions& options);

/// What is to be said of all parts together: sums, and the largest deflection.
[[nodiscard]] MeshFacts facts_of(const MeshTree& tree);

/// 3MF: objects, components, names and colours (base materials). Lengths are millimetres.
[[nodiscard]] Result<void> write_3mf(const MeshTree& tree, std::ostream& stream);

/// OBJ: an object for every instance, where it stands, by name; colours by `usemtl`, if the file
/// has materials beside it.
[[nodiscard]] Result<void> write_obj(const MeshTree& tree, const std::string& material_file,
                                     std::ostream& stream);

/// The materials of an OBJ file.
[[nodiscard]] Result<void> write_mtl(const MeshTree& tree, std::ostream& stream);

}  // namespace suture::io

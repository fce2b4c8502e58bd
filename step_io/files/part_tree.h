#pragma once

#include "files/model_file.h"

#include <TopoDS_Shape.hxx>

#include <string>
#include <vector>

namespace suture::io {

/// An assembly or a part where it stands in the model.
struct TreeNode {
    std::string name;
    int depth = 0;         ///< 0: a root
    TopoDS_Shape shape;    ///< in its place, with the model's own sub-shapes
    bool is_part = false;  ///< no assembly
};

/// The assembly tree, parents before their children, every instance for itself.
[[nodiscard]] std::vector<TreeNode> part_tree(const ModelFile& model);

}  // namespace suture::io

#include "files/part_tree.h"

#include "files/document.h"

namespace suture::io {

namespace {

void visit(const TDF_Label& label, const TopLoc_Location& place, int depth,
           std::vector<TreeNode>& nodes) {
    const TDF_Label target = referred(label);
    TreeNode& node = nodes.emplace_back();
    node.name = name_of(label);
    if (node.name.empty() || target != label) {
        // An instance is called as its part is, unless a file says more than a number of it.
        node.name = name_of(target).empty() ? node.name : name_of(target);
    }
    node.depth = depth;
    node.shape = XCAFDoc_ShapeTool::GetShape(label);
    node.shape.Move(place);
    node.is_part = !XCAFDoc_ShapeTool::IsAssembly(target);
    const TopLoc_Location inner = node.shape.Location();
    for (const TDF_Label& component : components_of(target)) {
        visit(component, inner, depth + 1, nodes);
    }
}

}  // namespace

std::vector<TreeNode> part_tree(const ModelFile& model) {
    std::vector<TreeNode> nodes;
    for (const TDF_Label& root : roots_of(model.document)) {
        visit(root, {}, 0, nodes);
    }
    return nodes;
}

}  // namespace suture::io

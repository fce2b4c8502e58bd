#pragma once

#include "suture/check/crossing.h"
#include "suture/check/surface_tree.h"

#include <array>
#include <optional>

namespace suture {

/// Looks for the deepest clash of two faces, or of one with itself.
class ClashPair {
  public:
    ClashPair(SurfaceTree& a, SurfaceTree& b, const SharedBorder& shared, double tolerance,
              double resolution)
        : a_(a),
          b_(b),
          shared_(shared),
          tolerance_(tolerance),
          allowed_(std::max(tolerance, shared.tolerance())),
          resolution_(resolution) {}

    std::optional<Crossing> deepest() {
        look(0, 0);
        return best_;
    }

  private:
    [[nodiscard]] bool is_leaf(const SurfaceTree& tree, const SurfaceTree::Cell& cell) const {
        return (cell.flat_known && cell.sag <= resolution_) || tree.is_smallest(cell);
    }
    [[nodiscard]] bool is_self() const { return &a_ == &b_; }
    void look(int i, int j);
    [[nodiscard]] bool passes_not_itself(int i, int j) const;
    void meet(const SurfaceTree::Cell& one, const SurfaceTree::Cell& two);
    void refine(const std::array<double, 2>& uv_a, const std::array<double, 2>& uv_b);

    SurfaceTree& a_;
    SurfaceTree& b_;
    const SharedBorder& shared_;
    double tolerance_, allowed_, resolution_;
    std::optional<Crossing> best_;
    int more_ = 32;  ///< meetings that are refined after one that was a clash
};

}  // namespace suture

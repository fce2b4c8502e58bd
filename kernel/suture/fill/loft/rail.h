#pragma once

#include "suture/model/ribbon.h"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

namespace suture::loft {

/// A run of neighbouring sides of one loop as a whole, in the direction of the loop or against it,
/// for u from 0 to 1. Of several sides u is the share of the run's length; of one side it is the
/// side's own parameter, so that what is a polynomial stays one.
class Rail {
  public:
    /// Input  sides: indices of loop.ribbons in the order of the loop.
    Rail(const RibbonLoop& loop, std::vector<std::size_t> sides, bool backwards);

    /// What the neighbour is like at u; tangent and inward are those of the loop's own direction. A
    /// run that closes goes on beyond 0 and 1.
    [[nodiscard]] RibbonPoint at(double u) const;

    /// Where on the run a side is.
    [[nodiscard]] double place_of(std::size_t side, double s) const;

    /// Whether a parameter is where two sides meet: these, each once, ends included.
    [[nodiscard]] std::vector<double> joints() const;

    [[nodiscard]] const std::vector<std::size_t>& sides() const { return sides_; }

  private:
    /// The length of a side up to equally spaced parameters.
    struct Side {
        std::function<RibbonPoint(double)> at;
        double before = 0.0;  ///< of the sides before this one
        std::vector<double> lengths;
        [[nodiscard]] double length_to(double s) const;
        [[nodiscard]] double at_length(double length) const;
    };

    std::vector<std::size_t> sides_;
    std::vector<Side> table_;
    double total_ = 0.0;
    bool backwards_ = false;
};

}  // namespace suture::loft

#pragma once

#include "suture/model/ribbon.h"

#include <functional>
#include <vector>

namespace suture::tube {

/// A side by its length: the parameter around the tube. Sides that are run through at nearly even
/// speed keep their own parameter, scaled, so that a quadratic side stays quadratic.
class Course {
  public:
    explicit Course(const Ribbon& ribbon);

    [[nodiscard]] double length() const { return lengths_.back(); }
    [[nodiscard]] bool even() const { return even_; }
    [[nodiscard]] double s_of(double length) const;
    [[nodiscard]] double length_of(double s) const;
    /// Speed |dP/ds| at its least and at its most.
    [[nodiscard]] double slowest() const { return slowest_; }
    [[nodiscard]] double fastest() const { return fastest_; }

  private:
    std::function<RibbonPoint(double)> at_;
    std::vector<double> lengths_;  ///< up to the end of each panel
    double slowest_, fastest_;
    bool even_;

    [[nodiscard]] double piece(double from, double to) const;
};

}  // namespace suture::tube

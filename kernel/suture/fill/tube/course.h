#pragma once

#include "suture/model/ribbon.h"

#include <utility>
#include <vector>

namespace suture::tube {

/// A side by its length: the parameter around the tube. Sides that are run through evenly, and
/// quadratic ones whose speed varies little, keep their own parameter, scaled, so that a quadratic
/// side stays quadratic.
class Course {
  public:
    explicit Course(const Ribbon& ribbon);

    [[nodiscard]] double length() const { return lengths_.back(); }
    [[nodiscard]] double s_of(double length) const;
    [[nodiscard]] double length_of(double s) const;
    /// d length_of / ds
    [[nodiscard]] double speed_of(double s) const;

  private:
    /// At the ends of equal panels; between them the length is the cubic that these determine.
    std::vector<double> lengths_, speeds_;
    bool even_ = false;

    /// The panel of an s, and where in it, 0 to 1.
    [[nodiscard]] std::pair<std::size_t, double> panel_of(double s) const;
    /// The length at t in [0,1] of a panel, and its derivative by t.
    [[nodiscard]] std::pair<double, double> length_in(std::size_t panel, double t) const;
};

}  // namespace suture::tube

#pragma once

#include "suture/detect/seams.h"

#include <vector>

namespace suture {

/// The smallest tolerance that is sewn with, as a share of the model's diagonal: room for numbers
/// written with seven digits, as many IGES files have them.
inline constexpr double kLeastTolerance = 1e-6;

/// The widest gap that is a seam by its length and stays below the features.
///
/// Input   partners: of the free edges that are still open; floor: the least tolerance, and the
///         size below which nothing is a feature.
/// Result  at least the floor.
[[nodiscard]] double choose_tolerance(const std::vector<EdgePartner>& partners, double floor);

}  // namespace suture

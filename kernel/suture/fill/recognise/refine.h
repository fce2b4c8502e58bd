#pragma once

#include "suture/fill/recognise/border.h"

#include <vector>

namespace suture::recognise {

/// What of a form is known already and not fitted.
struct Hold {
    bool direction = false;   ///< of its axis
    bool axis = false;        ///< its axis as a line
    std::vector<bool> sizes;  ///< in the order of sizes_of; empty: none
};

/// The form nearest to the border's points, by Gauss-Newton steps on their distances: least squares
/// up to the model's noise, and beyond it least distances, so that a side which lies off does not
/// draw the others with it.
///
/// What the points alone do not determine stays as it was at the start, where the normals have
/// said it: steps are taken in the directions whose singular values are not small only.
/// Source   Huber, Robust estimation of a location parameter, Ann. Math. Statist. 35 (1964);
/// Lukacs, Marshall & Martin, Geometric least-squares fitting of spheres, cylinders, cones
///          and tori, RECCAD report (1997).
[[nodiscard]] Surface refine(Surface form, const Border& border, const Hold& hold = {});

/// Root mean square distance of the points, and the median one.
[[nodiscard]] double rms(const Surface& form, const Border& border);
[[nodiscard]] double middle(const Surface& form, const Border& border);

}  // namespace suture::recognise

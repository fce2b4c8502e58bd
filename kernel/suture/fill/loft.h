#pragma once

#include "suture/fill/fill.h"

#include <array>

namespace suture {

inline constexpr std::array kLoftOptions = {MethodOption{
    "tension", OptionKind::Number, "FACTOR",
    "how far the tangents at both sides reach: 1 (default) as far as the gap is wide", 0.0}};

/// The bridge between two chains of sides with curves without a face between their ends, or the
/// tube between two closed rims: across from one to the other it is a cubic, tangent to both
/// neighbours, and the free sides are the curves that bound it there. Where the chains have
/// corners, one has to have as many as the other, and there is a patch from corner to corner.
///
/// Result   B-spline patches, cubic across; position and tangency of the neighbours to the accuracy
///          of the fit along them, exact where these are polynomials. Sides without a face are met
///          by straight lines across.
/// Refuses  other holes, free curves that are not such cubics, chains with different numbers of
///          corners, points to pass through.
/// Source   Ferguson, Multivariable curve interpolation, 1964: cubic Hermite blending.
[[nodiscard]] Result<FillResult> fill_loft(const Hole& hole, const FillOptions& options);

}  // namespace suture

#pragma once

#include "suture/base/result.h"
#include "suture/fill/recognise/border.h"

#include <Eigen/Core>

#include <functional>

namespace suture::recognise {

/// Where a point of the border stands to a surface, in model units: its distance, and the
/// surface's unit normal X_u x X_v at the foot.
struct Foot {
    double distance = 0.0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};
using FootFinder = std::function<Foot(const Eigen::Vector3d& point)>;

/// How well a surface fits a border.
struct Agreement {
    /// Largest distance of the border but for rough sides, as a share of the hole's diameter.
    double gap = 0.0;
    double angle = 0.0;      ///< largest median angle of the sides that are tangent, radians
    double tangent = 0.0;    ///< share of the border, by length or by sides, that is tangent
    double exact = 0.0;      ///< ... that lies on it and is tangent to within the model's noise
    int outward = 0;         ///< tangent sides whose outside is X_u x X_v
    int inward = 0;          ///< ... and -(X_u x X_v)
    double rough = 0.0;      ///< of rough sides: largest distance over what their edges miss
    bool plane = false;      ///< it is a plane itself
    std::vector<int> faces;  ///< tangent neighbours, FaceN

    [[nodiscard]] bool reversed() const { return inward > outward; }
};

[[nodiscard]] Agreement measure(const FootFinder& foot, const Border& border);

/// Of a closed form in the border's own coordinates.
[[nodiscard]] Agreement measure(const Surface& form, const Border& border);

/// The largest gap, as a share of the diameter, at which a surface is believed to be the one that
/// the border was cut from; 0 where the model is too inexact to believe anything.
[[nodiscard]] double largest_gap(const Border& border);

/// Whether the border lies in a plane, as the rim of an opening does.
[[nodiscard]] bool is_flat(const Border& border);

/// What speaks for a surface besides its agreement.
struct Evidence {
    /// A face of the model lies on it, so that sides on it may be sharp.
    bool of_model = false;
    /// A gap, as a share of the diameter, that is not held against it in any case.
    double allowed = 0.0;
    /// How probable numbers as plain as its own are by chance.
    double chance = 1.0;
    /// A congruent face has it: the judge compares how either meets its neighbours.
    bool twin = false;
};

/// Refuses  a border that lies off by more than the model's noise, but for a small part of it that
///          belongs to a surface with plain numbers; neighbours that meet the surface in another
///          normal; a surface that says no more than a plane would. With the figures.
[[nodiscard]] Result<void> believe(const Agreement& agreement, const Border& border,
                                   const Evidence& evidence = {});

}  // namespace suture::recognise

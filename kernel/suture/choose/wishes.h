#pragma once

#include "suture/choose/request.h"
#include "suture/model/ribbon.h"

#include <string>
#include <vector>

namespace suture {

/// The continuity wanted along one side, and why.
struct Wish {
    Continuity continuity = Continuity::G1;
    std::string reason;
    bool hoped = false;  ///< G2 by our own choice: G1 will do where it costs gap or angle
    bool own = false;    ///< G1 or G2 by our own choice: position will do where no fill is tangent
    bool given_up = false;  ///< position, because no fill was found that is tangent there
    bool wall = false;      ///< given up where the neighbour stands on the opening like a wall
    bool sharp = false;     ///< position, because no face with this border is tangent there
};

/// Whether a side is a curve alone: the new face ends there, and nothing but its place is given.
[[nodiscard]] inline bool is_free(const Ribbon& ribbon) {
    return ribbon.face == 0;
}

/// What to ask for along each side, side by side in the order of the loops.
///
/// Along a curve without a face there is only position. What the request says holds. Else (auto) G2
/// if the method can and the neighbours agree in normal and curvature at both ends of the side,
/// otherwise G1, but G0
///  - all around an opening on whose best plane all neighbours stand steeply (the end of a duct, a
///    box without a lid): a tangent fill would be a dome that nobody drew; steps in the border, of
///    sides no longer than the tolerance, do not count;
///  - along a side whose neighbour lies in a planar opening itself;
///  - everywhere, if the method joins in position only;
///  - along a side whose neighbour leads away from the hole while its corners are not smooth;
///  - along a side at both of whose ends the border itself leaves the neighbour's plane by more
///    than 10 degrees: no face within that border is tangent there.
[[nodiscard]] std::vector<Wish> wishes_for(const Hole& hole, const FillRequest& request);

/// Which sides' neighbours stand on the best plane through the border at more than 45 degrees
/// somewhere, side by side in the order of the loops: a fill can hardly be tangent to them.
[[nodiscard]] std::vector<bool> steep_sides(const Hole& hole);

/// Which sides' normals differ from those of both sides beside them by more than this at the
/// corners, where these sides agree with the next ones: single sides that belong to no smooth
/// surrounding.
[[nodiscard]] std::vector<bool> odd_sides(const Hole& hole, double angle);

/// Which sides' neighbours do so all along, and on an opening that is nearly planar: walls, to
/// which nobody draws a tangent lid.
[[nodiscard]] std::vector<bool> walls_of(const Hole& hole);

}  // namespace suture

#pragma once

#include "suture/fill/manifold/middle.h"
#include "suture/fill/manifold/surface.h"

#include <string>

namespace suture::manifold {

/// How the middle of a star is to be written.
enum class MiddleForm {
    Auto,   ///< quads; for k = 0 and 1, whose kinks they follow badly, cells where quads do not do
    Quads,  ///< fitted, n of them
    Cells,  ///< exact, hundreds of them, for k = 0 and 1
};

struct MadeMiddle {
    Middle middle;
    double error = 0.0;  ///< largest distance from the surface; cells are exact
    bool exact = false;
    int spans = 0;     ///< of a quad, in each direction; 0: cells
    std::string note;  ///< what it is, for the user
};

/// The middle in the form asked for.
///
/// Input    tolerance: of quads, in model units; they get more spans until they are within it, or
///          there are as many as a file can hold: the error says then how far they are off.
/// Refuses  cells that make_cells() refuses, if cells were asked for.
[[nodiscard]] Result<MadeMiddle> make_middle(const StarSurface& surface, MiddleForm form,
                                             double tolerance);

}  // namespace suture::manifold

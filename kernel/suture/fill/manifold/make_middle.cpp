#include "suture/fill/manifold/make_middle.h"

#include "suture/fill/manifold/cells.h"
#include "suture/fill/manifold/centre.h"

namespace suture::manifold {
namespace {

/// With more spans than these in a quad a file holds more than anyone wants to open. A C0 or C1
/// surface needs more knots for as many spans, and gets little for them.
int most_spans(int k) {
    constexpr int kMany = 64;
    constexpr int kFew = 16;
    return k > kMostExactOrder ? kMany : kFew;
}

MadeMiddle as_quads(const StarSurface& surface, double tolerance) {
    const Centre centre = fit_centre(surface, tolerance, most_spans(surface.star().k()));
    MadeMiddle made;
    made.middle = quads_of(surface, centre);
    made.error = centre.error;
    made.spans = centre.spans;
    made.note = fmt::format("the middle is fitted to {:.2g} by {} quads of {}x{} spans",
                            centre.error, centre.quads.size(), centre.spans, centre.spans);
    return made;
}

Result<MadeMiddle> as_cells(const StarSurface& surface) {
    auto cells = make_cells(surface);
    if (!cells) {
        return tl::unexpected(cells.error());
    }
    MadeMiddle made;
    made.exact = true;
    made.note = fmt::format("the middle is {} exact rational cells", cells->patches.size());
    made.middle = std::move(*cells);
    return made;
}

}  // namespace

Result<MadeMiddle> make_middle(const StarSurface& surface, MiddleForm form, double tolerance) {
    if (form == MiddleForm::Cells) {
        return as_cells(surface);
    }
    MadeMiddle quads = as_quads(surface, tolerance);
    if (form == MiddleForm::Quads || quads.error <= tolerance ||
        surface.star().k() > kMostExactOrder) {
        return quads;
    }
    auto cells = as_cells(surface);
    if (!cells) {
        quads.note += "; not exactly: " + cells.error().message;
        return quads;
    }
    cells->note += fmt::format(": quads of {}x{} spans are off by {:.2g}", quads.spans, quads.spans,
                               quads.error);
    return cells;
}

}  // namespace suture::manifold

#pragma once

#include "suture/model/ribbon.h"
#include "suture/model/surface.h"
#include "suture/occ/handle.h"

#include <Geom_Surface.hxx>

#include <optional>

namespace suture {

/// A surface of OCCT in a form of ours, as far as a hole reaches: extruded and revolved ones as
/// rational B-splines, exact; offsets as B-splines near to 1e-7 of the hole's diameter.
///
/// Result   nothing where OCCT cannot convert it.
[[nodiscard]] std::optional<Surface> to_surface(const occ::Handle<Geom_Surface>& surface,
                                                const Hole& hole);

}  // namespace suture

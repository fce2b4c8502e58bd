#pragma once

#include "suture/occ/handle.h"

#include <Geom_Surface.hxx>

namespace suture {

/// What the fill methods pass on without a look into it (model/patch.h): a surface as the model has
/// it.
struct ModelSurface {
    occ::Handle<Geom_Surface> surface;
};

}  // namespace suture

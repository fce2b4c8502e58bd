#pragma once

#include <STEPConstruct_UnitContext.hxx>
#include <Standard_Version.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#if OCC_VERSION_HEX >= 0x070800
#include <StepData_Factors.hxx>
#endif

#include "suture/occ/handle.h"

namespace suture::occ {

/// Reads the units of a STEP representation context: OCCT 7.8 and newer measure them against
/// factors of the reader's own, which are millimetre and radian here as they always were before.
inline void compute_factors(STEPConstruct_UnitContext& units,
                            const Handle<StepRepr_GlobalUnitAssignedContext>& context) {
#if OCC_VERSION_HEX >= 0x070800
    units.ComputeFactors(context, StepData_Factors());
#else
    units.ComputeFactors(context);
#endif
}

}  // namespace suture::occ

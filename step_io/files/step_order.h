#pragma once

#include "files/step_scan.h"

#include <StepData_StepModel.hxx>

#include <string>
#include <vector>

namespace suture::io {

/// Counts the instances of assemblies from 1: OCCT counts on from one file to the next.
void count_instances(const StepData_StepModel& entities);

/// The text of a STEP file whose entities are numbered from 1.
struct NumberedText {
    std::string text;
    std::vector<StepId> numbers;  ///< by the old number, what an entity's is now
};

/// The same entities in an order that depends on nothing but the model. OCCT writes the colours of
/// parts, one MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION each, in the order of
/// addresses; here they come last, by what they say.
[[nodiscard]] NumberedText in_fixed_order(std::string text);

}  // namespace suture::io

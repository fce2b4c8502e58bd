#pragma once

#include <TopoDS_Face.hxx>

#include <span>
#include <vector>

namespace suture::io {

/// The accuracies that a STEP or IGES file may state, in model units, in the order in which they
/// should be tried: an old file's own first, if the new faces allow for it.
///
/// Readers take it for the distance up to which an edge's curve on a surface and its curve in space
/// are the same. OCCT's (XSAlgo_AlgoContainer::CheckPCurve) drops a curve on a surface whose ends
/// are farther than that from those of the curve in space, or makes another one and takes the
/// better of the two where they are twice as far apart anywhere. That one runs through a few
/// points, and can be anywhere between them. So what is stated has to cover the ends, and half of
/// the new edges' tolerances; further values cover all of these, and more.
///
/// Input    own: of the model, 0 if it states none; faces: the new ones.
[[nodiscard]] std::vector<double> accuracies_to_state(double own,
                                                      std::span<const TopoDS_Face> faces);

}  // namespace suture::io

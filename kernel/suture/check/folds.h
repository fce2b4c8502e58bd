#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <Eigen/Core>

#include <TopoDS_Shape.hxx>

#include <array>
#include <string>
#include <vector>

namespace suture {

/// Whether a face turns over within itself.
enum class FoldVerdict {
    None,  ///< proven: regular, and nowhere turning by 120 degrees within a hundredth of its width
    Fold,  ///< found: two normals 120 degrees or more apart, nearer than that or at one point
    Undecided,  ///< neither: a box is left in which the surface may be singular, or none can be
                ///< made
};

struct FaceFold {
    int face = 0;  ///< FaceN, 1-based
    FoldVerdict verdict = FoldVerdict::None;
    /// Of a fold and of the smallest box left: where.
    std::array<double, 2> uv = {0.0, 0.0};
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double angle = 0.0;      ///< of a fold: between the two normals, radians
    double size = 0.0;       ///< of the box left: its diagonal
    bool at_border = false;  ///< the face's border passes the box left: it may end in a point there
    /// The loops run the wrong way round: the face is what lies outside of them, or its surface
    /// passes the border in the direction opposite to the edges'.
    bool backwards = false;
    std::string reason;  ///< why it is undecided, else empty
};

/// Proves span by span that faces do not fold.
///
/// S_u x S_v of every polynomial piece is a polynomial, in Bernstein's form within the cone of its
/// coefficients; a piece whose cone is narrower than 60 degrees to either side cannot turn over.
/// Others are halved. What lies outside of the face's loops is left out, and a surface may end in a
/// point or be tangent to itself in a corner. docs/check.md tells the rest.
///
/// Input    faces: FaceN of the shape, 1-based.
/// Result   one entry for each, in the order given.
/// Refuses  a null shape, a face that does not exist (Usage); a cancelled run.
[[nodiscard]] Result<std::vector<FaceFold>> find_folds(const TopoDS_Shape& shape,
                                                       const std::vector<int>& faces,
                                                       const Progress& progress);

}  // namespace suture

#pragma once

#include <Eigen/Core>

#include <compare>
#include <string>
#include <string_view>

namespace suture {

/// How far a result is from what was asked.
enum class Severity {
    Good,  ///< within the limit
    Near,  ///< up to ten times the limit
    Poor,  ///< beyond, but a model that can be worked with
    Bad,   ///< a careful person would throw it away
};

[[nodiscard]] std::string_view to_string(Severity severity);

/// What can be wrong with a fill or a model. The unit of value and limit stands behind each.
enum class FindingKind {
    Gap,              ///< model units
    Angle,            ///< radians, along a side or between new faces
    Curvature,        ///< mismatch relative to the larger curvature
    Crease,           ///< radians, across a knot line inside a new face
    Fold,             ///< 1: the face turns over
    Clash,            ///< model units: how deep it reaches through another face
    LiesOnFace,       ///< part of the new face's area that lies on another face
    Balloon,          ///< area over that of a coarse spanning surface
    ToleranceGrown,   ///< model units, of an edge; the limit is what the measured gap accounts for
    TangencyGivenUp,  ///< radians, along a side on which tangency was wanted first
    Through,          ///< model units, of a point that was to be passed
    ThroughAngle,     ///< radians, from the normal that was wanted at such a point
    OpenEdge,         ///< 1: an edge that only one face uses, or more than two
    NotMeasured,      ///< 1: a face or a side was not found again, or could not be measured
    NotValid,         ///< 1: BRepCheck does not accept the shape
    ChangedByWriting  ///< what was read back from the file, over what memory had
};

[[nodiscard]] std::string_view to_string(FindingKind kind);

/// The unit in which people and programs are told a kind's figures: "mm", "deg", "%", or nothing.
[[nodiscard]] std::string_view unit_of(FindingKind kind);

/// A figure of this kind in that unit.
[[nodiscard]] double in_unit(double value, FindingKind kind);

/// One thing that is not as it should be, and how much.
struct Finding {
    FindingKind kind = FindingKind::Gap;
    Severity severity = Severity::Good;
    double value = 0.0;
    double limit = 0.0;
    int hole = 0;        ///< id of the hole, 0: the model
    int edge = 0;        ///< the side that it is about, EdgeN of the input; 0: none
    int face = 0;        ///< FaceN of the output; 0: none
    int other_face = 0;  ///< the face that it clashes with
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    bool before = false;  ///< the input has this fault itself; it counts in no severity
    std::string detail;   ///< what the figures do not say, for people
};

/// By how many times the limit is exceeded.
[[nodiscard]] double excess(const Finding& finding);

/// The worse one is the greater: by severity, then by how much the limit is exceeded.
[[nodiscard]] bool is_worse(const Finding& a, const Finding& b);

/// "gap 0.0049 mm, allowed are 0.001, at (1, 2, 3) on edge 12": the one place that makes prose of
/// findings.
[[nodiscard]] std::string to_text(const Finding& finding);

}  // namespace suture

#pragma once

#include "suture/base/tolerance.h"
#include "suture/check/fill_measures.h"
#include "suture/judge/finding.h"
#include "suture/model/continuity.h"

#include <optional>
#include <string>
#include <vector>

namespace suture {

/// The angles along an edge, radians.
struct AngleRange {
    double least = 0.0, largest = 0.0;
};

/// What was asked of a fill along one side, and what the surroundings leave possible there.
struct AskedSide {
    int edge = 0;            ///< EdgeN of the input
    bool alone = false;      ///< a curve without a face: the new face may end there
    bool supported = false;  ///< a face was named that the new one is to be tangent to there
    Continuity continuity = Continuity::G1;
    bool given_up = false;  ///< tangency was wanted first, and no fill was found that has it
    bool wall = false;      ///< the neighbour stands on the opening like a wall
    /// By how much the two neighbours miss each other at the side's ends: nothing that fits both
    /// can be nearer. Model units and radians.
    double corner_gap = 0.0, corner_angle = 0.0;
    double tolerance = 0.0;  ///< of the edge, in the input
    double noise = 0.0;      ///< how far the edge lies off its neighbour, in the input, model units
    /// Of a fill that is a copy of a congruent face of the model: how that one meets its own
    /// neighbour along this side, if it has one there.
    std::optional<AngleRange> of_twin;
};

/// What was asked of a fill.
struct AskedFill {
    int hole = 0;                  ///< id, for the findings
    std::vector<AskedSide> sides;  ///< in the order of FillMeasures::sides
    double diameter = 0.0;         ///< of the hole, model units
    /// A cylinder, a ball or the like, which goes as far as it goes: it is no balloon.
    bool closed_form = false;
    /// It is the surface that the lost face had: what its sides miss is the model's own noise, up
    /// to kOwnNoise in angle, and in position to kOwnGap or to what an edge misses its own
    /// neighbour by.
    bool recognised = false;
    /// The face that it is a copy of folds itself.
    bool twin_folds = false;
    Tolerance tolerance;  ///< the request's: the one that every figure is held against
};

/// What a fill is worth.
struct Judgement {
    Severity severity = Severity::Good;
    std::vector<Finding> findings;  ///< the worst first; empty: nothing to say
    /// The largest measure over its limit, of all that counts: at most 1 is within tolerance.
    double score = 0.0;

    [[nodiscard]] bool within() const { return severity == Severity::Good; }
};

/// Judges a fill by its measures: the only place that says what counts as good.
///
/// A measure up to its limit is good, up to ten times near, beyond poor. Bad is what a careful
/// person would throw away: a gap above 1e-3 of the hole's diameter, a side that is sharp (more
/// than Profile::sharp) though it was asked to be tangent and its corners do not force it, a face
/// that folds, clashes, lies on the back of its neighbour or is a balloon.
/// Where the neighbours miss each other at a corner themselves, by at most kOwnNoise in angle, no
/// more than that is asked of the two sides there; the finding is marked `before`.
[[nodiscard]] Judgement judge_fill(const AskedFill& asked, const FillMeasures& measures);

/// Adds what was found elsewhere: by writing and reading back.
void add_finding(Finding finding, Judgement& verdict);

/// How smooth a fill is all around, within the tolerance.
[[nodiscard]] Continuity reached_by(const AskedFill& asked, const FillMeasures& measures);

/// Judges the faults that a result has, by BRepCheck and by grown tolerances, against those that
/// the input had: as many or fewer are the input's own.
[[nodiscard]] Finding judge_problems(const std::vector<std::string>& after,
                                     const std::vector<std::string>& before);

/// Neighbours that miss each other by up to this at a corner show how exact the model is; beyond
/// they are different surfaces.
inline constexpr double kOwnNoise = radians(1.0);

/// The gap that a recognised surface may leave, as a share of the hole's diameter.
inline constexpr double kOwnGap = 1e-4;

}  // namespace suture

#include "suture/judge/judge_fill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suture {
namespace {

/// Near is up to so many times the limit.
constexpr double kNear = 10.0;

/// A gap above this part of the hole's diameter closes nothing.
constexpr double kBadGap = 1e-3;

/// A new face of which more than this part lies on another one closes nothing.
constexpr double kLiesOn = 0.5;

/// A side may be so much sharper than its corners before they no longer explain it: the search for
/// the maximum is good to a few per cent, and half way along a short side both corners act.
constexpr double kForced = 1.5;

/// An edge's tolerance may be so many times the gap that was measured.
constexpr double kToleranceShare = 1.5;

/// Readers compute the tolerance that an edge had before to this much.
constexpr double kReadAgain = 1.01;

/// A fill that has so many times the area of a coarse surface across the hole is a balloon. Half a
/// ball has 2, the tip of a pen (a cone of 20 degrees) 6.
constexpr double kBalloon = 8.0;

class Judge {
  public:
    explicit Judge(const AskedFill& asked) : asked_(asked) {}

    void side(const AskedSide& side, const EdgeContinuity& edge) {
        if (edge.samples == 0) {
            Finding finding = make(FindingKind::NotMeasured, 1.0, 0.0);
            finding.edge = side.edge;
            finding.detail = edge.note.empty() ? "the side was not found again" : edge.note;
            add(std::move(finding), Severity::Poor);
            return;
        }
        gap(edge, side.edge, side.corner_gap, side.noise);
        if (side.continuity >= Continuity::G1) {
            angle(edge, &side);
        } else {
            given_up(side, edge);
        }
        if (side.continuity >= Continuity::G2) {
            curvature(edge, side.edge);
        }
    }

    /// An edge between new faces has to be as smooth as the smoothest side.
    void inner(const EdgeContinuity& edge, Continuity wanted) {
        gap(edge, 0, 0.0, 0.0);
        if (wanted >= Continuity::G1) {
            angle(edge, nullptr);
        }
        if (wanted >= Continuity::G2) {
            curvature(edge, 0);
        }
    }

    void crease(const KnotLine& line, Continuity wanted) {
        const auto told = [&](FindingKind kind, double value, double limit) {
            Finding finding = make(kind, value, limit);
            finding.face = line.face;
            finding.at = line.at;
            finding.detail = "inside the face";
            return finding;
        };
        add(told(FindingKind::Gap, line.max_gap, asked_.tolerance.linear),
            of_gap(line.max_gap, asked_.tolerance.linear));
        if (wanted >= Continuity::G1) {
            add(told(FindingKind::Crease, line.max_angle, asked_.tolerance.angular),
                of_angle(line.max_angle, asked_.tolerance.angular, /*sharp_is_bad=*/true));
        }
        if (wanted >= Continuity::G2) {
            add(told(FindingKind::Curvature, line.curvature_mismatch, asked_.tolerance.curvature),
                of(line.curvature_mismatch, asked_.tolerance.curvature));
        }
    }

    void shape(const FillMeasures& measures) {
        for (const FaceFold& fold : measures.folds) {
            if (fold.verdict == FoldVerdict::Fold || fold.backwards) {
                Finding finding = make(FindingKind::Fold, 1.0, 0.0);
                finding.face = fold.face;
                finding.at = fold.at;
                finding.detail = fold.backwards ? "its surface runs against its border"
                                                : fmt::format(
                                                      "two of its normals are {:.0f} deg "
                                                      "apart there",
                                                      degrees(fold.angle));
                if (asked_.twin_folds && !fold.backwards) {
                    finding.before = true;
                    finding.detail += ", as in the face that it is a copy of";
                }
                const Severity severity = finding.before ? Severity::Poor : Severity::Bad;
                add(std::move(finding), severity);
            }
        }
        const double ratio = measures.area.ratio();
        if (ratio > kBalloon && !asked_.closed_form) {
            add(make(FindingKind::Balloon, ratio, kBalloon), Severity::Bad);
        }
        for (const Clash& clash : measures.clashes) {
            Finding finding = make(FindingKind::Clash, clash.depth, asked_.tolerance.linear);
            finding.face = clash.face;
            finding.other_face = clash.other;
            finding.at = clash.at;
            add(std::move(finding), Severity::Bad);
        }
        for (const Overlay& overlay : measures.overlays) {
            const bool same_place =
                overlay.neighbours || overlay.distance <= asked_.tolerance.linear;
            if (overlay.share > kLiesOn && same_place) {
                Finding finding = make(FindingKind::LiesOnFace, overlay.share, kLiesOn);
                finding.face = overlay.face;
                finding.other_face = overlay.other;
                finding.at = overlay.at;
                add(std::move(finding), Severity::Bad);
            }
        }
    }

    void through(const FillMeasures& measures) {
        Finding finding = make(FindingKind::Through, measures.through, asked_.tolerance.linear);
        finding.at = measures.through_at;
        add(std::move(finding), of(measures.through, asked_.tolerance.linear));
        Finding turned =
            make(FindingKind::ThroughAngle, measures.through_angle, asked_.tolerance.angular);
        turned.at = measures.through_angle_at;
        add(std::move(turned), of(measures.through_angle, asked_.tolerance.angular));
    }

    void topology(const FillMeasures& measures) {
        for (const auto& [edges, detail] :
             {std::pair(&measures.open_edges, "one face uses it"),
              std::pair(&measures.crowded_edges, "more than two faces use it")}) {
            for (const EdgeFacts& edge : *edges) {
                Finding finding = make(FindingKind::OpenEdge, 1.0, 0.0);
                const std::size_t side = side_of(edge.edge, measures);
                if (edges == &measures.open_edges && side < asked_.sides.size() &&
                    asked_.sides[side].alone) {
                    continue;
                }
                finding.edge = side < asked_.sides.size() ? asked_.sides[side].edge : 0;
                finding.at = edge.at;
                finding.detail = detail;
                add(std::move(finding), Severity::Poor);
            }
        }
        for (int i = 0; i < measures.lost_faces; ++i) {
            Finding finding = make(FindingKind::NotMeasured, 1.0, 0.0);
            finding.detail = "a new face was not found again in the output";
            add(std::move(finding), Severity::Poor);
        }
    }

    /// The tolerances of the edges, against what was measured along them. What stays within the
    /// request's tolerance harms nothing.
    void tolerances(const FillMeasures& measures) {
        for (const EdgeFacts& edge : measures.edges) {
            const std::size_t side = side_of(edge.edge, measures);
            double before = 0.0;
            double measured = 0.0;
            Finding finding = make(FindingKind::ToleranceGrown, edge.tolerance, 0.0);
            if (side < asked_.sides.size()) {
                finding.edge = asked_.sides[side].edge;
                before = asked_.sides[side].tolerance;
                measured = gap_along(measures.sides[side]);
            } else {
                const auto inner =
                    std::find_if(measures.inner.begin(), measures.inner.end(),
                                 [&](const EdgeContinuity& e) { return e.edge == edge.edge; });
                measured = inner != measures.inner.end() ? gap_along(*inner) : 0.0;
            }
            finding.limit = std::max(
                {kToleranceShare * measured, kReadAgain * before, asked_.tolerance.linear});
            finding.at = edge.at;
            add(std::move(finding), of(edge.tolerance, finding.limit));
        }
    }

    [[nodiscard]] Judgement take() && { return std::move(verdict_); }

  private:
    static double gap_along(const EdgeContinuity& edge) {
        return std::max(edge.edge_gap, edge.max_gap);
    }

    /// The side that an edge of the shape is; as many as there are if it is none.
    static std::size_t side_of(int edge, const FillMeasures& measures) {
        const auto found =
            std::find_if(measures.sides.begin(), measures.sides.end(),
                         [&](const EdgeContinuity& side) { return side.edge == edge; });
        return static_cast<std::size_t>(found - measures.sides.begin());
    }

    [[nodiscard]] Finding make(FindingKind kind, double value, double limit) const {
        Finding finding;
        finding.kind = kind;
        finding.hole = asked_.hole;
        finding.value = value;
        finding.limit = limit;
        return finding;
    }

    static Severity of(double value, double limit) {
        return value <= limit           ? Severity::Good
               : value <= kNear * limit ? Severity::Near
                                        : Severity::Poor;
    }

    [[nodiscard]] Severity of_gap(double value, double limit) const {
        return value > limit && value > kBadGap * asked_.diameter ? Severity::Bad
                                                                  : of(value, limit);
    }

    static Severity of_angle(double value, double limit, bool sharp_is_bad) {
        return sharp_is_bad && value > limit && value > sharp() ? Severity::Bad : of(value, limit);
    }

    static double sharp() {
        static const double sharp = Profile().sharp;
        return sharp;
    }

    /// Keeps what is not within its limit.
    void add(Finding finding, Severity severity) {
        finding.severity = std::isfinite(finding.value) ? severity : Severity::Bad;
        if (finding.severity > Severity::Good) {
            add_finding(std::move(finding), verdict_);
        } else {
            verdict_.score = std::max(verdict_.score, excess(finding));
        }
    }

    /// The same for a measure that the surroundings themselves allow no better.
    void add_forced(Finding finding, Severity severity, double forced) {
        finding.before = finding.value > finding.limit && finding.value <= forced;
        add(std::move(finding), severity);
    }

    void gap(const EdgeContinuity& edge, int number, double forced, double noise_there) {
        Finding finding = make(FindingKind::Gap, edge.max_gap, asked_.tolerance.linear);
        finding.edge = number;
        finding.at = edge.gap_at;
        if (asked_.recognised) {
            forced = std::max({forced, kOwnGap * asked_.diameter, kForced * noise_there});
        }
        const bool noise = forced <= kBadGap * asked_.diameter;
        add_forced(std::move(finding), of_gap(edge.max_gap, asked_.tolerance.linear),
                   noise ? forced : 0.0);
    }

    /// Whether the face of which the fill is a copy is as sharp there, all along.
    static bool as_twin(const EdgeContinuity& edge, const AskedSide* side) {
        return side != nullptr && !side->supported && side->of_twin &&
               std::abs(edge.max_angle - side->of_twin->largest) <= kOwnNoise &&
               std::abs(edge.min_angle - side->of_twin->least) <= kOwnNoise;
    }

    void angle(const EdgeContinuity& edge, const AskedSide* side) {
        Finding finding = make(FindingKind::Angle, edge.max_angle, asked_.tolerance.angular);
        finding.at = edge.angle_at;
        double forced = 0.0;
        const bool twins = as_twin(edge, side);
        if (twins) {
            finding.edge = side->edge;
            forced = edge.max_angle;
            finding.detail = "as the face that it is a copy of meets its own neighbour";
        } else if (side != nullptr) {
            finding.edge = side->edge;
            forced = side->corner_angle;
            if (asked_.recognised && forced < edge.max_angle && edge.max_angle <= kOwnNoise) {
                forced = edge.max_angle;
                finding.detail = "so its neighbour meets the recognised surface itself";
            } else if (forced > asked_.tolerance.angular) {
                finding.detail = fmt::format(
                    "its neighbour meets the next one at {:.3g} deg itself", degrees(forced));
            }
        } else {
            finding.detail = "between the new faces";
        }
        const bool explained = edge.max_angle <= kForced * forced;
        add_forced(std::move(finding),
                   of_angle(edge.max_angle, asked_.tolerance.angular, !explained),
                   twins || forced <= kOwnNoise ? forced : 0.0);
    }

    void curvature(const EdgeContinuity& edge, int number) {
        Finding finding =
            make(FindingKind::Curvature, edge.curvature_mismatch, asked_.tolerance.curvature);
        finding.edge = number;
        finding.at = edge.curvature_at;
        add(std::move(finding), of(edge.curvature_mismatch, asked_.tolerance.curvature));
    }

    void given_up(const AskedSide& side, const EdgeContinuity& edge) {
        // What is sharp all along a surface that was recognised was so by design.
        const bool by_design = asked_.recognised && edge.min_angle > sharp();
        if (side.given_up && !side.wall && !by_design) {
            Finding finding =
                make(FindingKind::TangencyGivenUp, edge.max_angle, asked_.tolerance.angular);
            finding.edge = side.edge;
            finding.at = edge.angle_at;
            add(std::move(finding), of(edge.max_angle, asked_.tolerance.angular));
        }
    }

    const AskedFill& asked_;
    Judgement verdict_;
};

Continuity highest(const AskedFill& asked) {
    Continuity highest = Continuity::G0;
    for (const AskedSide& side : asked.sides) {
        highest = std::max(highest, side.continuity);
    }
    return highest;
}

Continuity reached(const EdgeContinuity& edge, const Tolerance& tolerance) {
    if (edge.samples == 0 || edge.max_gap > tolerance.linear ||
        edge.max_angle > tolerance.angular) {
        return Continuity::G0;
    }
    return edge.curvature_mismatch <= tolerance.curvature ? Continuity::G2 : Continuity::G1;
}

}  // namespace

Judgement judge_fill(const AskedFill& asked, const FillMeasures& measures) {
    Judge judge(asked);
    const Continuity smoothest = highest(asked);
    for (std::size_t i = 0; i < asked.sides.size(); ++i) {
        judge.side(asked.sides[i], measures.sides[i]);
    }
    for (const EdgeContinuity& edge : measures.inner) {
        judge.inner(edge, smoothest);
    }
    for (const KnotLine& line : measures.creases) {
        judge.crease(line, smoothest);
    }
    judge.shape(measures);
    judge.topology(measures);
    judge.through(measures);
    judge.tolerances(measures);
    return std::move(judge).take();
}

void add_finding(Finding finding, Judgement& verdict) {
    if (!finding.before) {
        verdict.score = std::max(verdict.score, excess(finding));
        verdict.severity = std::max(verdict.severity, finding.severity);
    }
    const auto place =
        std::upper_bound(verdict.findings.begin(), verdict.findings.end(), finding, is_worse);
    verdict.findings.insert(place, std::move(finding));
}

Finding judge_problems(const std::vector<std::string>& after,
                       const std::vector<std::string>& before) {
    Finding finding;
    finding.kind = FindingKind::NotValid;
    finding.value = static_cast<double>(after.size());
    finding.limit = static_cast<double>(before.size());
    finding.severity = Severity::Poor;
    finding.before = after.size() <= before.size();
    finding.detail = after.empty() ? "" : after.front();
    return finding;
}

Continuity reached_by(const AskedFill& asked, const FillMeasures& measures) {
    std::size_t ends = 0;  ///< sides where nothing but the new face is
    bool any = false;      ///< whether there is something to be smooth with
    Continuity result = Continuity::G2;
    for (std::size_t i = 0; i < measures.sides.size(); ++i) {
        const EdgeContinuity& side = measures.sides[i];
        const bool end = asked.sides[i].alone && side.faces[1] == 0;
        ends += end ? 1 : 0;
        if (!end || asked.sides[i].supported) {
            any = true;
            result = std::min(result, reached(side, asked.tolerance));
        }
    }
    for (const EdgeContinuity& edge : measures.inner) {
        result = std::min(result, reached(edge, asked.tolerance));
    }
    const bool open = measures.open_edges.size() > ends;
    return open || !any || !measures.crowded_edges.empty() || measures.lost_faces > 0
               ? Continuity::G0
               : result;
}

}  // namespace suture

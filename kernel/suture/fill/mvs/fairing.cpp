#include "suture/fill/mvs/fairing.h"

#include "suture/fill/mvs/knot_lines.h"
#include "suture/fill/mvs/levels.h"
#include "suture/fill/mvs/schedule.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace suture::mvs {
namespace {

// The unit is the diameter of the circle as long as the boundary: unlike the bounding box it does
// not depend on how the hole is turned in space.
Scale scale_of(const RibbonLoop& loop, const Layout& layout) {
    Scale scale;
    scale.length = std::accumulate(layout.lengths.begin(), layout.lengths.end(), 0.0) / kPi;
    for (const Ribbon& ribbon : loop.ribbons) {
        scale.centre += ribbon.at(0.0).point + ribbon.at(0.5).point;
    }
    scale.centre /= 2.0 * static_cast<double>(loop.ribbons.size());
    return scale;
}

// A corner's disagreement in II that the smallest spans turn into this part of the angle: a C2
// surface misses by a quarter of it times the span.
double least_twist(const FillOptions& options, const Schedule& schedule) {
    return schedule.twisted * options.tolerance.angular * 4.0 / schedule.least_span;
}

bool better(const Fairing& a, const Fairing& b) {
    const bool folds_a = a.regularity <= 0.0;
    const bool folds_b = b.regularity <= 0.0;
    return folds_a != folds_b ? folds_b : a.missed_by < b.missed_by;
}

// Whether a net without lines can come nearer than one with them did: its smallest spans miss by a
// quarter of the disagreement, in radians.
bool plain_may_help(const Fairing& with_lines, const LinedLayout& lined, const FillOptions& options,
                    const Schedule& schedule) {
    const double least = 0.25 * lined.twist * schedule.least_span;
    return with_lines.regularity <= 0.0 || with_lines.missed_by * options.tolerance.angular > least;
}

Result<Fairing> best_attempt(const Hole& hole, const Layout& layout, const FillOptions& options,
                             const Schedule& schedule, double most_work) {
    const RibbonLoop& loop = hole.loops.front();
    const Scale scale = scale_of(loop, layout);
    const LinedLayout plain{layout, {}, 0.0};
    const LinedLayout lined = with_knot_lines(loop, layout, scale, least_twist(options, schedule));
    std::optional<Fairing> best;
    double work = 0.0;
    const auto poor = [&] { return best->worst.angle > schedule.poor_angle; };
    for (const LinedLayout* with : {&lined, &plain}) {
        const bool lines = with == &lined;
        if (lines ? lined.lines.empty()
                  : best && !plain_may_help(*best, lined, options, schedule)) {
            continue;
        }
        const double up_to = (lines ? schedule.share_of_lines : 1.0) * most_work;
        for (const int spans : {schedule.first_spans, schedule.fine_first_spans}) {
            Result<Fairing> fairing =
                Levels(hole, *with, scale, options, schedule, spans, up_to - work).run();
            if (!fairing) {
                return fairing;
            }
            work += fairing->work;
            const bool off = fairing->worst.angle > schedule.poor_angle;
            const bool exhausted = fairing->exhausted;
            if (!best || better(*fairing, *best)) {
                best = std::move(*fairing);
            }
            if (best->missed_by <= schedule.within && best->regularity > 0.0) {
                return *best;
            }
            if (!off || !poor() || exhausted) {
                break;
            }
        }
    }
    return *best;
}

// Whether a side asks for curvature, and whether no surface has it at one of its ends.
struct Asked {
    bool curvature = false;
    bool twisted = false;
};

std::vector<Asked> asked_of(const RibbonLoop& loop, double diameter) {
    const std::vector<Corner> corners = corners_of(loop);
    std::vector<Asked> result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double twist = std::max(corners[i].twist, corners[(i + 1) % corners.size()].twist);
        result.push_back(
            {loop.ribbons[i].continuity >= Continuity::G2, twist * diameter > kSameBend});
    }
    return result;
}

// The same hole with tangency in place of curvature along some sides; their names are noted.
Hole with_less_curvature(const Hole& hole, bool all, std::vector<std::string>& names) {
    Hole result = hole;
    for (RibbonLoop& loop : result.loops) {
        const std::vector<Asked> asked = asked_of(loop, hole.diameter);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            if (asked[i].curvature && (all || asked[i].twisted)) {
                loop.ribbons[i].continuity = Continuity::G1;
                names.push_back(name_of(loop.ribbons[i]));
            }
        }
    }
    return result;
}

bool asks_for_curvature(const Hole& hole) {
    return std::ranges::any_of(hole.loops, [](const RibbonLoop& loop) {
        return std::ranges::any_of(
            loop.ribbons, [](const Ribbon& ribbon) { return ribbon.continuity >= Continuity::G2; });
    });
}

}  // namespace

Result<Fairing> fair(const Hole& hole, const Layout& layout, const FillOptions& options,
                     const Schedule& schedule) {
    const double some = asks_for_curvature(hole) ? schedule.share_of_curvature * schedule.most_work
                                                 : schedule.most_work;
    Result<Fairing> best = best_attempt(hole, layout, options, schedule, some);
    std::size_t given_up = 0;
    for (const bool all : {false, true}) {
        if (!best || (best->tangency_missed_by <= schedule.within && best->regularity > 0.0)) {
            return best;
        }
        std::vector<std::string> names;
        const Hole less = with_less_curvature(hole, all, names);
        if (names.size() <= given_up) {
            continue;
        }
        given_up = names.size();
        Result<Fairing> fairing = best_attempt(
            less, layout, options, schedule, asks_for_curvature(less) ? some : schedule.most_work);
        if (!fairing) {
            return fairing;
        }
        const bool folded = best->regularity <= 0.0 && fairing->regularity > 0.0;
        if (folded ||
            best->tangency_missed_by > schedule.curvature_price * fairing->tangency_missed_by) {
            best = std::move(fairing);
            best->tangent_only = std::move(names);
        }
    }
    return best;
}

}  // namespace suture::mvs

#include "suture/choose/attempts.h"

#include "suture/fill/fill.h"
#include "suture/ribbon/noise.h"

#include <algorithm>
#include <utility>

namespace suture {
namespace {

bool position_only(const Hole& hole) {
    return std::all_of(hole.loops.begin(), hole.loops.end(), [](const RibbonLoop& loop) {
        return std::all_of(loop.ribbons.begin(), loop.ribbons.end(), [](const Ribbon& ribbon) {
            return ribbon.continuity == Continuity::G0;
        });
    });
}

bool wants_curvature(const Hole& hole) {
    return std::any_of(hole.loops.begin(), hole.loops.end(), [](const RibbonLoop& loop) {
        return std::any_of(loop.ribbons.begin(), loop.ribbons.end(), [](const Ribbon& ribbon) {
            return ribbon.continuity >= Continuity::G2;
        });
    });
}

/// The same hole with position alone wanted along every side.
Hole without_tangency(Hole hole) {
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            ribbon.continuity = Continuity::G0;
        }
    }
    return hole;
}

/// Whether `auto` does without a method here.
bool left_out(const FillMethod& method, const Hole& hole, const FillRequest& request) {
    switch (method.in_auto) {
        case AutoUse::Always:
            return false;
        case AutoUse::Recognising:
            return !request.recognise;
        case AutoUse::Bridging:
            return !request.connect;
        case AutoUse::Improving:
            return request.effort == Effort::Quick || position_only(hole) ||
                   (wants_curvature(hole) && method.highest < Continuity::G2);
        case AutoUse::Never:
            break;
    }
    return true;
}

/// How much `mvs` may compute; the other methods look for no such option.
OptionValues work_of(Effort effort) {
    const double factor = effort == Effort::Quick ? 0.05 : effort == Effort::Normal ? 0.3 : 10.0;
    return {{"work", {OptionKind::Number, {factor}, {}}}};
}

std::string plate_name(PlateSetting setting, bool relaxed) {
    const bool tuned = setting == PlateSetting::Tuned;
    return relaxed ? (tuned ? "occt (tuned, position only)" : "occt (position only)")
                   : (tuned ? "occt (tuned)" : "occt");
}

}  // namespace

std::vector<Attempt> attempts_for(const Site& site, const Hole& hole, const FillRequest& request,
                                  const Tolerance& tolerance) {
    const bool automatic = request.method == "auto";
    FillOptions options{tolerance, request.progress,
                        automatic ? work_of(request.effort) : request.options};
    options.side_noise = noise_of_sides(site.loops, hole);
    options.noise = measure_noise(site.loops, hole);
    options.candidates = site.candidates;
    options.prefer = request.prefer;
    std::vector<Attempt> attempts;
    for (const FillMethod& method : fill_methods()) {
        if (automatic ? !left_out(method, hole, request) : request.method == method.id) {
            attempts.push_back(
                {std::string(method.id),
                 [&, method, options](std::optional<Recognised>& found, int passed_over) {
                     FillOptions own = options;
                     own.passed_over = passed_over;
                     own.recognised = [&](const Recognised& what) { found = what; };
                     return method.fill(hole, own);
                 },
                 /*improving=*/automatic && method.in_auto == AutoUse::Improving});
        }
    }
    std::stable_partition(attempts.begin(), attempts.end(),
                          [](const Attempt& attempt) { return !attempt.improving; });
    if (automatic && position_only(hole)) {
        // A lid, not the ball or the tip that a rim could also belong to.
        std::stable_partition(attempts.begin(), attempts.end(),
                              [](const Attempt& attempt) { return attempt.name == "plane"; });
    }
    const auto plate = [&](PlateSetting setting, bool relaxed = false) {
        attempts.push_back(
            {plate_name(setting, relaxed),
             [&, setting, relaxed](std::optional<Recognised>& /*found*/, int /*passed_over*/) {
                 return fill_with_plate(site.loops, relaxed ? without_tangency(hole) : hole,
                                        setting, request.plate_limit, request.progress);
             },
             /*improving=*/false, /*slow=*/true,
             /*last_resort=*/automatic && relaxed});
    };
    if (automatic) {
        plate(PlateSetting::Default);
        if (request.effort == Effort::Thorough) {
            plate(PlateSetting::Tuned);
        }
        plate(PlateSetting::Default, /*relaxed=*/true);
    } else if (request.method == "occt") {
        for (const PlateSetting setting : {request.plate_setting, PlateSetting::Default}) {
            plate(setting);
            if (!position_only(hole)) {
                plate(setting, /*relaxed=*/true);
            }
            if (setting == PlateSetting::Default) {
                break;
            }
        }
    }
    return attempts;
}

}  // namespace suture

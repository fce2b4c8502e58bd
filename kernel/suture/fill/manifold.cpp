#include "suture/fill/manifold.h"

#include "suture/base/tolerance.h"
#include "suture/fill/manifold/border_fit.h"
#include "suture/fill/manifold/layout.h"
#include "suture/fill/manifold/make_middle.h"
#include "suture/fill/manifold/ring.h"
#include "suture/fill/manifold/sides.h"
#include "suture/fill/manifold/spacing.h"
#include "suture/fill/manifold/star_border.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace suture {
namespace {

using namespace manifold;

/// How far the quads of the middle may be off, as a share of the hole's diameter.
constexpr double kFit = 1e-6;

/// However large the tolerance, the border is not farther off than this share of the diameter.
constexpr double kGap = 1e-5;

/// The layers to begin with, and those from which nets become too large to be opened.
constexpr int kFirstLayers = 8;
constexpr int kMostLayers = 30;

/// The same for the columns of a ring, of which layers are a share up to a limit: it is the border
/// that asks for many.
constexpr int kColumnsPerLayer = 4;
constexpr int kMostColumns = 640;
constexpr int kMostRingLayers = 12;

int order_of(const FillOptions& options) {
    return find_count(options.own, "k").value_or(2);
}

MiddleForm form_of(const FillOptions& options) {
    const auto word = find_word(options.own, "middle");
    return !word ? MiddleForm::Auto : *word == "exact" ? MiddleForm::Cells : MiddleForm::Quads;
}

/// A surface of some size, fitted to the border.
struct Fitted {
    int size = 0;  ///< layers of a star, columns of a ring
    BorderFit border;
};

/// The sizes that are tried: the first, times `growth`, ... up to `most`.
struct Sizes {
    int first = 0;
    int most = 0;
    double growth = 2.0;

    [[nodiscard]] int after(int size) const { return static_cast<int>(growth * size); }
};

/// Raises the size until the border is within half of the tolerance: the other half is for what
/// comes after.
Result<Fitted> fit_sizes(const Hole& hole, const FillOptions& options, const Sides& sides,
                         const Sizes& sizes, const GuideSurface* guide,
                         const std::function<Result<BorderModel>(int size)>& model) {
    constexpr double kEnough = 0.5;
    Tolerance limits = options.tolerance;
    limits.linear = kEnough * std::min(limits.linear, kGap * hole.diameter);
    limits.angular *= kEnough;
    std::optional<Fitted> best;
    double best_score = 0.0;
    Error error;
    int failed = 0;
    for (int size = sizes.first;; size = sizes.after(size)) {
        if (options.progress.cancelled()) {
            return fail(ErrorCode::Cancelled, "stopped while filling");
        }
        const auto border = model(size);
        if (!border) {
            return tl::unexpected(border.error());
        }
        auto fit = fit_border(*border, hole, sides, limits, guide);
        if (fit) {
            const double score = std::max(fit->gap / limits.linear, fit->angle / limits.angular);
            if (!best || score < best_score) {
                best = Fitted{size, std::move(*fit)};
                best_score = score;
            }
        } else {
            error = fit.error();
            ++failed;
        }
        // What folds three times folds however many layers there are.
        constexpr int kHopeless = 3;
        if (failed >= kHopeless) {
            return best ? Result<Fitted>(*best) : tl::unexpected(error);
        }
        if (sizes.after(size) > sizes.most || (best && best_score <= 1.0)) {
            return best ? Result<Fitted>(*best) : tl::unexpected(error);
        }
    }
}

std::string note_on(const Fitted& fitted, int layers, int k, std::string_view what) {
    std::string note =
        fmt::format("k = {}, {}, {} layers; along the border gap {:.2g}, angle {:.2g} deg", k, what,
                    layers, fitted.border.gap, degrees(fitted.border.angle));
    if (fitted.border.from_guide >= 0.0) {
        note +=
            fmt::format("; {:.2g} from the surface of least variation", fitted.border.from_guide);
    }
    if (!fitted.border.left_guide.empty()) {
        note += "; towards the surface of least variation " + fitted.border.left_guide;
    }
    return note;
}

Result<FillResult> fill_star(const Hole& hole, const FillOptions& options, const Sides& sides,
                             const GuideSurface* guide) {
    const int n = static_cast<int>(sides.sides.size());
    std::vector<std::vector<double>> joints;
    for (const Side& side : sides.sides) {
        joints.push_back(side.joints());
    }
    const auto spacing_of = [&](int layers) {
        constexpr int kLevels = 3;
        return spacing_for(order_of(options), layers,
                           find_number(options.own, "aperture").value_or(0.0), joints, kLevels);
    };
    // Strips need a width, and the wider they are the smaller is the middle, which is fitted.
    const int least = 2 * Star::least_layers(order_of(options), n);
    Sizes sizes{std::max(kFirstLayers, least), kMostLayers, 1.25};
    if (const auto asked = find_count(options.own, "layers")) {
        sizes.first = sizes.most = *asked;
    }
    const auto fitted =
        fit_sizes(hole, options, sides, sizes, guide, [&](int layers) -> Result<BorderModel> {
            const Spacing spacing = spacing_of(layers);
            const auto star = Star::make(spacing.size);
            if (!star) {
                return tl::unexpected(star.error());
            }
            return border_model(*star, hole.diameter, spacing.centres);
        });
    if (!fitted) {
        return tl::unexpected(fitted.error());
    }
    const Spacing spacing = spacing_of(fitted->size);
    const Star star = Star::make(spacing.size).value();
    const StarSurface surface(star, fitted->border.points);
    const BorderModel model = border_model(star, hole.diameter, spacing.centres);
    auto middle = make_middle(surface, form_of(options), kFit * hole.diameter);
    if (!middle) {
        return tl::unexpected(middle.error());
    }
    std::vector<std::vector<SideEdge>> edges;
    for (int m = 0; m < n; ++m) {
        std::vector<SideEdge>& side = edges.emplace_back();
        for (const Piece& piece : sides.sides[static_cast<std::size_t>(m)].pieces) {
            side.push_back(
                {piece.ribbon, [model, m, piece](double s) { return model.y_of(m, piece, s); }});
        }
    }
    FillResult result = lay_out(surface, std::move(middle->middle), edges);
    result.notes.push_back(note_on(*fitted, star.layers(), star.k(),
                                   fmt::format("{} sides, aperture {:.3g}", n, star.aperture())) +
                           "; " + middle->note);
    return result;
}

/// One exact patch whose sides go all the way around, with a seam to the apex.
FillResult lay_out_ring(const SplineSurface& spline, const BorderModel& model, const Side& side) {
    const double border = spline.knots_u.back();
    const double turn = spline.knots_v.back();
    FillResult result;
    result.inner_vertices = {evaluate(spline, 0.0, 0.0).point};
    result.inner_edges = {{{0, side.pieces.front().ribbon}, {-1, 0}}};
    Patch patch;
    patch.surface = spline;
    std::vector<EdgeUse>& wire = patch.wires.emplace_back();
    for (const Piece& piece : side.pieces) {
        wire.push_back(
            {0, piece.ribbon, false, [border, model, piece](double s) -> Eigen::Vector2d {
                 return {border, model.y_of(0, piece, s)};
             }});
    }
    const auto seam = [border](double y) -> TrimCurve {
        return [border, y](double s) -> Eigen::Vector2d { return {border * (1.0 - s), y}; };
    };
    wire.push_back({-1, 0, false, seam(turn), /*pole_after=*/true});
    wire.push_back({-1, 0, true, seam(0.0)});
    result.patches.push_back(std::move(patch));
    return result;
}

Result<FillResult> fill_ring(const Hole& hole, const FillOptions& options, const Sides& sides) {
    constexpr int kLeastOrder = 2;
    const int k = order_of(options);
    if (k < kLeastOrder) {
        return fail(ErrorCode::Refused, "the hole has no corner: a ring needs k of at least {}",
                    kLeastOrder);
    }
    const auto ring_of = [&](int columns) {
        return Ring(k, std::min(columns / kColumnsPerLayer, kMostRingLayers), columns);
    };
    Sizes sizes{kColumnsPerLayer * std::max(kFirstLayers, k + 2), kMostColumns};
    if (const auto asked = find_count(options.own, "layers")) {
        sizes.first = sizes.most = kColumnsPerLayer * std::max(*asked, k + 2);
    }
    const auto fitted =
        fit_sizes(hole, options, sides, sizes, nullptr, [&](int columns) -> Result<BorderModel> {
            return ring_of(columns).border_model(hole.diameter);
        });
    if (!fitted) {
        return tl::unexpected(fitted.error());
    }
    const Ring ring = ring_of(fitted->size);
    FillResult result = lay_out_ring(ring.spline(fitted->border.points),
                                     ring.border_model(hole.diameter), sides.sides.front());
    result.notes.push_back(note_on(*fitted, ring.layers(), k, "a ring closed at an apex"));
    return result;
}

}  // namespace

Result<FillResult> fill_manifold(const Hole& hole, const FillOptions& options) {
    if (!hole.through.empty()) {
        return fail(ErrorCode::Refused, "manifold passes through no inner points, {} are given",
                    hole.through.size());
    }
    const auto sides = find_sides(hole);
    if (!sides) {
        return tl::unexpected(sides.error());
    }
    if (sides->ring) {
        auto ring = fill_ring(hole, options, *sides);
        if (ring) {
            ring->notes.insert(ring->notes.begin(), sides->notes.begin(), sides->notes.end());
        }
        return ring;
    }
    const auto guide = guide_surface(hole, options);
    if (!guide && guide.error().code == ErrorCode::Cancelled) {
        return tl::unexpected(guide.error());
    }
    auto result = fill_star(hole, options, *sides, guide ? &*guide : nullptr);
    if (result) {
        if (!guide) {
            result->notes.push_back("without a guide: " + guide.error().message);
        }
        result->notes.insert(result->notes.begin(), sides->notes.begin(), sides->notes.end());
    }
    return result;
}

}  // namespace suture

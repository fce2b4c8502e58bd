#include "suture/fill/recognise/chain.h"

#include "suture/base/tolerance.h"
#include "suture/fill/recognise/agreement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace suture::recognise {
namespace {

using Eigen::Vector3d;

/// Radii of one ball agree to so many times what either varies by along its sides, at least to this
/// share.
constexpr double kSpreads = 3.0;
constexpr double kLeastSpread = 1e-6;
/// The path is walked in steps of this share of the hole's size, or of the radius.
constexpr double kStep = 1.0 / 48.0;
constexpr double kStepOfRadius = 0.25;
/// Where the pairs change, the path may turn by this.
constexpr double kTurn = radians(1.0);
/// A position in whose own plane across the path a point lies is sought in so many steps, until the
/// tangent changes by less than this and no less than in the step before.
constexpr int kStands = 60;
constexpr double kStill = 1e-7;

/// The side after (before) another one around the hole.
std::size_t beside(const Border& border, std::size_t side, bool after) {
    const int loop = border.sides[side].loop;
    const auto count = border.sides.size();
    std::size_t i = side;
    do {
        i = after ? (i + 1) % count : (i + count - 1) % count;
    } while (border.sides[i].loop != loop);
    return i;
}

bool same_radius(const BallGuess& a, const BallGuess& b) {
    const double slack =
        std::max(kSpreads * std::max(a.spread, b.spread), kLeastSpread) * std::abs(a.radius);
    return std::abs(a.radius - b.radius) <= slack;
}

/// The guess for two sides, in this order.
std::optional<BallGuess> guess_for(const std::vector<BallGuess>& guesses, std::size_t a,
                                   std::size_t b) {
    for (BallGuess guess : guesses) {
        if (guess.sides[0] == b && guess.sides[1] == a) {
            std::swap(guess.sides[0], guess.sides[1]);
            std::swap(guess.at[0], guess.at[1]);
        }
        if (guess.sides[0] == a && guess.sides[1] == b) {
            return guess;
        }
    }
    return std::nullopt;
}

/// The link beyond the end of the first side (ahead), or before its beginning.
std::optional<BallGuess> beyond(const BallGuess& link, bool ahead,
                                const std::vector<BallGuess>& guesses, const Border& border) {
    const auto [a, b] = link.sides;
    // With the hole on the left, the two sides run against each other.
    const std::size_t next_a = beside(border, a, ahead);
    const std::size_t next_b = beside(border, b, !ahead);
    // The side that ends first changes first.
    for (const auto& [one, other] :
         {std::pair(next_a, b), std::pair(a, next_b), std::pair(next_a, next_b)}) {
        const auto found = one == other ? std::nullopt : guess_for(guesses, one, other);
        if (found && same_radius(link, *found)) {
            return found;
        }
    }
    return std::nullopt;
}

/// A link, its ball, where it begins, and where its pair changes.
struct Link {
    BallGuess guess;
    RollingBall ball;
    BallPosition start;
    std::optional<BallPosition> from, to;  ///< joints

    /// Whether a point lies beyond one of the joints.
    [[nodiscard]] bool leaves_out(const Vector3d& point) const {
        return (from && from->tangent.dot(point - from->centre) < 0.0) ||
               (to && to->tangent.dot(point - to->centre) > 0.0);
    }
};

/// The corner at which two links meet.
Vector3d corner_between(const BallGuess& link, const BallGuess& next, const Border& border) {
    for (int k = 0; k < 2; ++k) {
        const std::size_t side = link.sides[k];
        if (side != next.sides[k]) {
            const bool after = beside(border, side, true) == next.sides[k];
            return border.sides[side].ribbon->at(after ? 1.0 : 0.0).point;
        }
    }
    return Vector3d::Zero();
}

/// The position in whose plane a point lies, from one nearby.
std::optional<BallPosition> stand_at(const RollingBall& ball, const Vector3d& point,
                                     BallPosition position) {
    double last = INFINITY;
    for (int k = 0; k < kStands; ++k) {
        auto found = ball.at(point, position);
        if (!found) {
            return std::nullopt;
        }
        const double change = (found->tangent - position.tangent).norm();
        if (change < kStill && change >= last) {
            return found;
        }
        last = change;
        position = *found;
    }
    return std::nullopt;
}

Result<BallPosition> joint_of(const Link& link, const Vector3d& corner, double step) {
    const auto path = walk(link.ball, link.start, step, corner);
    if (!path) {
        return tl::unexpected(path.error());
    }
    const auto nearest = std::min_element(
        path->begin(), path->end(), [&](const BallPosition& x, const BallPosition& y) {
            return (x.centre - corner).squaredNorm() < (y.centre - corner).squaredNorm();
        });
    const auto joint = stand_at(link.ball, corner, *nearest);
    if (!joint) {
        return fail(ErrorCode::Refused, "the rolling ball's path ends before the next side");
    }
    return *joint;
}

Result<void> join(Link& link, Link& next, const Border& border, double step) {
    const Vector3d corner = corner_between(link.guess, next.guess, border);
    const auto to = joint_of(link, corner, step);
    const auto from = joint_of(next, corner, step);
    if (!to || !from) {
        return tl::unexpected(!to ? to.error() : from.error());
    }
    const double leap = (to->centre - from->centre).norm();
    const double limit = largest_gap(border) * border.size;
    const double turn = std::acos(std::clamp(to->tangent.dot(from->tangent), -1.0, 1.0));
    if (leap > limit || turn > kTurn) {
        return fail(ErrorCode::Refused,
                    "the rolling ball leaps by {:.2g}, allowed {:.2g}, and turns by {:.2g} deg, "
                    "allowed {:.2g}, between {} and {}",
                    leap, limit, degrees(turn), degrees(kTurn),
                    name_of(*border.sides[link.guess.sides[0]].ribbon),
                    name_of(*border.sides[next.guess.sides[0]].ribbon));
    }
    link.to = *to;
    next.from = *from;
    return {};
}

Result<std::vector<Link>> links_of(const std::vector<BallGuess>& chain, double radius,
                                   const Border& border) {
    std::vector<Link> links;
    for (const BallGuess& guess : chain) {
        const Ribbon& a = *border.sides[guess.sides[0]].ribbon;
        const Ribbon& b = *border.sides[guess.sides[1]].ribbon;
        const RollingBall ball(*a.support, *b.support, radius);
        const auto start = ball.near(a.support->uv(guess.at[0]), b.support->uv(guess.at[1]));
        if (!start) {
            return fail(ErrorCode::Refused, "no ball of radius {:.6g} touches {} and {}",
                        std::abs(radius), name_of(a), name_of(b));
        }
        links.push_back({guess, ball, *start, {}, {}});
    }
    return links;
}

/// The link whose part of the path is nearest to each point of the border.
std::vector<std::size_t> owners(const std::vector<Link>& links, const Eigen::Matrix3Xd& points) {
    std::vector<std::size_t> result;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        double least = INFINITY;
        std::size_t owner = 0;
        for (std::size_t k = 0; k < links.size(); ++k) {
            for (const auto& p : {std::optional(links[k].start), links[k].from, links[k].to}) {
                const double d = p && !links[k].leaves_out(points.col(i))
                                     ? (p->centre - points.col(i)).norm()
                                     : INFINITY;
                if (d < least) {
                    least = d;
                    owner = k;
                }
            }
        }
        result.push_back(std::isfinite(least) ? owner : links.size());
    }
    return result;
}

/// The path between the joints, or to the end of the border.
Result<PathPart> part_of(const Link& link, const Eigen::Matrix3Xd& cover, double step) {
    auto path = walk(link.ball, link.start, step, cover);
    if (!path) {
        return tl::unexpected(path.error());
    }
    std::erase_if(*path, [&](const BallPosition& p) {
        const double near = 0.1 * step;
        return (link.from && link.from->tangent.dot(p.centre - link.from->centre) < near) ||
               (link.to && link.to->tangent.dot(p.centre - link.to->centre) > -near);
    });
    if (link.from) {
        path->insert(path->begin(), *link.from);
    }
    if (link.to) {
        path->push_back(*link.to);
    }
    return PathPart{link.ball, std::move(*path)};
}

}  // namespace

std::vector<BallGuess> find_chain(const std::vector<BallGuess>& guesses, const Border& border) {
    if (guesses.empty()) {
        return {};
    }
    std::vector<BallGuess> chain = {guesses.front()};
    for (const bool ahead : {true, false}) {
        while (chain.size() < guesses.size()) {
            const auto next = beyond(ahead ? chain.back() : chain.front(), ahead, guesses, border);
            const bool known =
                next && std::any_of(chain.begin(), chain.end(), [&](const BallGuess& link) {
                    return std::is_permutation(link.sides, link.sides + 2, next->sides);
                });
            if (!next || known) {
                break;
            }
            chain.insert(ahead ? chain.end() : chain.begin(), *next);
        }
    }
    return chain;
}

Result<ArcSurface> chain_surface(std::vector<BallGuess> chain, double radius, const Border& border,
                                 double accuracy) {
    const BallGuess& first = chain.front();
    const auto begun = links_of({first}, radius, border);
    if (!begun) {
        return tl::unexpected(begun.error());
    }
    // Along the path.
    const Ribbon& side = *border.sides[first.sides[0]].ribbon;
    if (side.at(first.at[0]).tangent.dot(begun->front().start.tangent) < 0.0) {
        std::reverse(chain.begin(), chain.end());
    }
    auto links = links_of(chain, radius, border);
    if (!links) {
        return tl::unexpected(links.error());
    }
    const double step = std::min(kStep * border.size, kStepOfRadius * std::abs(radius));
    for (std::size_t k = 0; k + 1 < links->size(); ++k) {
        if (auto joined = join((*links)[k], (*links)[k + 1], border, step); !joined) {
            return tl::unexpected(joined.error());
        }
    }
    const Eigen::Matrix3Xd points = with_corners(border);
    const std::vector<std::size_t> owner = owners(*links, points);
    std::vector<PathPart> parts;
    for (std::size_t k = 0; k < links->size(); ++k) {
        std::vector<Eigen::Index> own;
        for (std::size_t i = 0; i < owner.size(); ++i) {
            if (owner[i] == k) {
                own.push_back(static_cast<Eigen::Index>(i));
            }
        }
        const Link& link = (*links)[k];
        Eigen::Matrix3Xd cover(3, static_cast<Eigen::Index>(own.size()) + 2);
        cover.leftCols(static_cast<Eigen::Index>(own.size())) = points(Eigen::all, own);
        cover.rightCols<2>() << link.from.value_or(link.start).centre,
            link.to.value_or(link.start).centre;
        auto part = part_of(link, cover, step);
        if (!part) {
            return tl::unexpected(part.error());
        }
        parts.push_back(std::move(*part));
    }
    return fit_arcs(parts, accuracy);
}

}  // namespace suture::recognise

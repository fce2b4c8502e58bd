#include "suture/fill/manifold/arrangement.h"

#include "suture/base/tolerance.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace suture::manifold {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

/// Points nearer than this, relative to the size, are one.
constexpr double kSame = 1e-9;
/// Where curves touch, their meeting point is known to half as many digits.
constexpr double kSameWhereTouching = 1e-5;
/// Edges shorter than this, relative to the size, are none that a model can hold.
constexpr double kShortest = 1e-6;
/// Tangents that enclose less than this touch.
constexpr double kTouching = 1e-4;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Real roots of sum c_l t^l; double ones once or twice.
std::vector<double> real_roots(VectorXd c) {
    const double largest = c.cwiseAbs().maxCoeff();
    constexpr double kZero = 1e-13;
    Eigen::Index degree = c.size() - 1;
    while (degree > 0 && std::abs(c[degree]) <= kZero * largest) {
        --degree;
    }
    if (degree == 0) {
        return {};
    }
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
    companion.diagonal(-1).setOnes();
    companion.rightCols(1) = -c.head(degree) / c[degree];
    std::vector<double> roots;
    for (const std::complex<double>& root : companion.eigenvalues()) {
        constexpr double kReal = 1e-5;
        if (std::abs(root.imag()) > kReal * (1.0 + std::abs(root.real()))) {
            continue;
        }
        double t = root.real();
        constexpr int kSteps = 3;
        for (int step = 0; step < kSteps; ++step) {
            double value = 0.0;
            double slope = 0.0;
            for (Eigen::Index l = degree; l >= 0; --l) {
                slope = slope * t + value;
                value = value * t + c[l];
            }
            constexpr double kFlat = 1e-6;
            if (std::abs(slope) < kFlat * largest) {
                break;  // a double root is as good as it gets
            }
            t -= value / slope;
        }
        roots.push_back(t);
    }
    return roots;
}

/// The parameters of a at which it meets b.
std::vector<double> meetings(const PlaneCurve& a, const PlaneCurve& b) {
    // On b: axis . p - offset - bend (across . p)^2 = 0.
    const double along[] = {b.axis.dot(a.axis), b.axis.dot(a.across())};
    const double beside[] = {b.across().dot(a.axis), b.across().dot(a.across())};
    VectorXd c = VectorXd::Zero(5);
    c.head(3) << along[0] * a.offset - b.offset, along[1], along[0] * a.bend;
    const double w[] = {beside[0] * a.offset, beside[1], beside[0] * a.bend};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            c[i + j] -= b.bend * w[i] * w[j];
        }
    }
    return real_roots(c);
}

/// Lines that lie on each other become one.
std::vector<PlaneCurve> merged(std::vector<PlaneCurve> curves, double same) {
    std::vector<PlaneCurve> result;
    std::vector<PlaneCurve> lines;
    for (PlaneCurve& curve : curves) {
        if (curve.bend != 0.0) {
            result.push_back(curve);
            continue;
        }
        // One of the two opposite axes.
        if (curve.axis.x() < -same || (std::abs(curve.axis.x()) <= same && curve.axis.y() < 0.0)) {
            curve = {-curve.axis, -curve.offset, 0.0, -curve.to, -curve.from};
        }
        lines.push_back(curve);
    }
    std::sort(lines.begin(), lines.end(),
              [](const PlaneCurve& a, const PlaneCurve& b) { return a.from < b.from; });
    for (bool grew = true; grew;) {
        grew = false;
        std::vector<PlaneCurve> joined;
        for (const PlaneCurve& line : lines) {
            const auto on = std::find_if(joined.begin(), joined.end(), [&](const PlaneCurve& old) {
                return (old.axis - line.axis).norm() < same &&
                       std::abs(old.offset - line.offset) < same && line.from <= old.to + same &&
                       old.from <= line.to + same;
            });
            if (on == joined.end()) {
                joined.push_back(line);
            } else {
                on->from = std::min(on->from, line.from);
                on->to = std::max(on->to, line.to);
                grew = true;
            }
        }
        lines = std::move(joined);
    }
    result.insert(result.end(), lines.begin(), lines.end());
    return result;
}

class Builder {
  public:
    Builder(std::vector<PlaneCurve> curves, double size,
            const std::function<bool(const Vector2d&)>& inside)
        : size_(size), inside_(inside), curves_(merged(std::move(curves), kSame * size)) {}

    Result<Arrangement> run() {
        add_vertices();
        if (auto cut = cut_curves(); !cut) {
            return tl::unexpected(cut.error());
        }
        drop_loose_ends();
        if (auto traced = trace(); !traced) {
            return tl::unexpected(traced.error());
        }
        return std::move(result_);
    }

  private:
    double size_;
    const std::function<bool(const Vector2d&)>& inside_;
    std::vector<PlaneCurve> curves_;
    /// Of each curve the parameters where it is cut, with the vertices there.
    std::vector<std::vector<std::pair<double, int>>> cuts_;
    Arrangement result_;

    int vertex_at(const Vector2d& p, double same) {
        for (std::size_t v = 0; v < result_.vertices.size(); ++v) {
            if ((result_.vertices[v] - p).norm() < same * size_) {
                return static_cast<int>(v);
            }
        }
        result_.vertices.push_back(p);
        return static_cast<int>(result_.vertices.size()) - 1;
    }

    void cut(std::size_t curve, double t, int vertex) {
        for (const auto& [unused, other] : cuts_[curve]) {
            if (other == vertex) {
                return;
            }
        }
        cuts_[curve].emplace_back(t, vertex);
    }

    void add_vertices() {
        cuts_.resize(curves_.size());
        for (std::size_t a = 0; a < curves_.size(); ++a) {
            for (const double t : {curves_[a].from, curves_[a].to}) {
                cut(a, t, vertex_at(curves_[a].at(t), kSame));
            }
        }
        for (std::size_t a = 0; a < curves_.size(); ++a) {
            for (std::size_t b = a + 1; b < curves_.size(); ++b) {
                meet(a, b);
            }
        }
    }

    void meet(std::size_t first, std::size_t second) {
        const PlaneCurve& a = curves_[first];
        const PlaneCurve& b = curves_[second];
        for (const double t : meetings(a, b)) {
            const double slack = kSameWhereTouching * size_;
            const Vector2d p = a.at(t);
            const double u = b.across().dot(p);
            if (t < a.from - slack || t > a.to + slack || u < b.from - slack || u > b.to + slack) {
                continue;
            }
            const Vector2d along = a.tangent(t).normalized();
            const bool touching = std::abs(cross(along, b.tangent(u).normalized())) < kTouching;
            const int vertex = vertex_at(p, touching ? kSameWhereTouching : kSame);
            const Vector2d& at = result_.vertices[static_cast<std::size_t>(vertex)];
            const double same = (touching ? kSameWhereTouching : kSame) * size_;
            const auto reaches = [&](const PlaneCurve& curve) {
                const double s = curve.across().dot(at);
                return s >= curve.from - same && s <= curve.to + same;
            };
            if (reaches(a) && reaches(b)) {
                cut(first, a.across().dot(at), vertex);
                cut(second, b.across().dot(at), vertex);
            }
        }
    }

    Result<void> cut_curves() {
        for (std::size_t c = 0; c < curves_.size(); ++c) {
            std::sort(cuts_[c].begin(), cuts_[c].end());
            for (std::size_t k = 0; k + 1 < cuts_[c].size(); ++k) {
                const auto [from, start] = cuts_[c][k];
                const auto [to, end] = cuts_[c][k + 1];
                PlaneCurve part = curves_[c];
                part.from = from;
                part.to = to;
                if (!inside_(part.at(0.5 * (from + to)))) {
                    continue;
                }
                if (to - from < kShortest * size_) {
                    const Vector2d at = part.at(from);
                    return fail(ErrorCode::Refused,
                                "knot curves meet {:.2g} from each other at ({:.6g}, {:.6g}) of "
                                "the parameters, nearer than {:.2g}: another aperture parts them",
                                to - from, at.x(), at.y(), kShortest * size_);
                }
                result_.edges.push_back({part, start, end});
            }
        }
        return {};
    }

    void drop_loose_ends() {
        for (bool dropped = true; dropped;) {
            std::vector<int> valence(result_.vertices.size(), 0);
            for (const auto& edge : result_.edges) {
                ++valence[static_cast<std::size_t>(edge.from)];
                ++valence[static_cast<std::size_t>(edge.to)];
            }
            dropped = std::erase_if(result_.edges, [&](const Arrangement::Edge& edge) {
                          return valence[static_cast<std::size_t>(edge.from)] == 1 ||
                                 valence[static_cast<std::size_t>(edge.to)] == 1;
                      }) > 0;
        }
        // Vertices that no edge needs any more go, too.
        std::vector<int> number(result_.vertices.size(), -1);
        std::vector<Vector2d> kept;
        for (auto& edge : result_.edges) {
            for (int* end : {&edge.from, &edge.to}) {
                int& renamed = number[static_cast<std::size_t>(*end)];
                if (renamed < 0) {
                    renamed = static_cast<int>(kept.size());
                    kept.push_back(result_.vertices[static_cast<std::size_t>(*end)]);
                }
                *end = renamed;
            }
        }
        result_.vertices = std::move(kept);
    }

    /// A half-edge by its angle where it begins, and by its curvature to the left: curves that
    /// touch part by that.
    struct Leaving {
        double angle = 0.0;
        double curvature = 0.0;
        int half_edge = 0;  ///< 2 edge + backwards
    };

    [[nodiscard]] Leaving leaving(int edge, bool backwards) const {
        const PlaneCurve& curve = result_.edges[static_cast<std::size_t>(edge)].curve;
        const Vector2d forward = curve.tangent(backwards ? curve.to : curve.from);
        const double sign = backwards ? -1.0 : 1.0;
        // Just below pi and just above -pi are the same direction.
        double angle = std::atan2(sign * forward.y(), sign * forward.x());
        angle = angle > kPi - kTouching ? angle - 2.0 * kPi : angle;
        const double turn = cross(forward, 2.0 * curve.bend * curve.axis);
        return {angle, sign * turn / std::pow(forward.norm(), 3), 2 * edge + (backwards ? 1 : 0)};
    }

    /// next[half-edge]: the one that goes on around the face to the left.
    [[nodiscard]] std::vector<int> next_around() const {
        std::vector<std::vector<Leaving>> stars(result_.vertices.size());
        for (std::size_t e = 0; e < result_.edges.size(); ++e) {
            const auto edge = static_cast<int>(e);
            stars[static_cast<std::size_t>(result_.edges[e].from)].push_back(leaving(edge, false));
            stars[static_cast<std::size_t>(result_.edges[e].to)].push_back(leaving(edge, true));
        }
        std::vector<int> next(2 * result_.edges.size(), -1);
        for (std::vector<Leaving>& star : stars) {
            std::sort(star.begin(), star.end(),
                      [](const Leaving& a, const Leaving& b) { return a.angle < b.angle; });
            for (std::size_t from = 0, to = 0; from < star.size(); from = to) {
                while (to < star.size() && star[to].angle - star[from].angle < kTouching) {
                    ++to;
                }
                std::sort(
                    star.begin() + static_cast<std::ptrdiff_t>(from),
                    star.begin() + static_cast<std::ptrdiff_t>(to),
                    [](const Leaving& a, const Leaving& b) { return a.curvature < b.curvature; });
            }
            for (std::size_t k = 0; k < star.size(); ++k) {
                // Arriving by the twin of k, the face to the left goes on by the one before k.
                const std::size_t before = (k + star.size() - 1) % star.size();
                next[static_cast<std::size_t>(star[k].half_edge ^ 1)] = star[before].half_edge;
            }
        }
        return next;
    }

    /// Twice the area, by the middle of each edge and Simpson's rule: exact for parabolas.
    [[nodiscard]] double area_under(const Arrangement::Use& use) const {
        const PlaneCurve& c = result_.edges[static_cast<std::size_t>(use.edge)].curve;
        const auto sweep = [&](double t) { return cross(c.at(t), c.tangent(t)); };
        const double area = (c.to - c.from) / 6.0 *
                            (sweep(c.from) + 4.0 * sweep(0.5 * (c.from + c.to)) + sweep(c.to));
        return use.backwards ? -area : area;
    }

    Result<void> trace() {
        const std::vector<int> next = next_around();
        std::vector<bool> seen(next.size(), false);
        int outer = 0;
        for (std::size_t start = 0; start < next.size(); ++start) {
            if (seen[start]) {
                continue;
            }
            std::vector<Arrangement::Use> loop;
            double area = 0.0;
            for (std::size_t h = start; !seen[h]; h = static_cast<std::size_t>(next[h])) {
                seen[h] = true;
                loop.push_back({static_cast<int>(h / 2), h % 2 == 1});
                area += area_under(loop.back());
            }
            if (area > 0.0) {
                result_.cells.push_back(std::move(loop));
            } else {
                ++outer;
            }
        }
        if (outer != 1) {
            return fail(ErrorCode::Refused, "the knot curves fall into {} parts", outer);
        }
        return {};
    }
};

}  // namespace

Result<Arrangement> arrange(std::vector<PlaneCurve> curves, double size,
                            const std::function<bool(const Vector2d&)>& inside) {
    return Builder(std::move(curves), size, inside).run();
}

}  // namespace suture::manifold

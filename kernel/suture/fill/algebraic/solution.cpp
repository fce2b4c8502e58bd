#include "suture/fill/algebraic/solution.h"

#include "suture/fill/algebraic/corners.h"
#include "suture/fill/algebraic/jets.h"
#include "suture/fill/algebraic/member.h"
#include "suture/fill/algebraic/space.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suture::algebraic {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The band around the guide in which the sheet has to be single, in units of the hole's radius.
constexpr double kBand = 0.06;
/// How often a sector is quartered into bands, and a band for its proof.
constexpr int kQuarterings = 2;
constexpr int kProofDepth = 3;
/// A band is laid around the guide by this many steps along its triangle's sides, where the guide
/// is seen at an angle with at least this sine.
constexpr int kAcrossBand = 4;
constexpr double kGrazing = 0.05;
/// Of the bands in which sampled rays look for a second sheet, in theirs.
constexpr double kWidths[] = {1.0, 2.5, 0.3, 0.1};
/// How far Bernstein coefficients keep away from zero.
constexpr double kMargin = 1e-6;
/// A member this near to the guide is taken; else a higher degree may come nearer.
constexpr double kNearGuide = 0.05;
/// Beyond this the surface has little to do with the hole.
constexpr double kFarFromGuide = 0.5;
/// Degrees above the lowest possible one; inner cells have enough freedom without the last.
constexpr int kMostRaised = 5;

/// Beyond this a column of the space is no solution to any tolerance.
constexpr double kMostMiss = 1e-2;
/// What misses cost, falling: exact identities first. Models whose own edges agree to four or five
/// digits, and neighbours that are no polynomials of the degree, ask for more.
constexpr double kMisses[] = {1e-9, 1e-7, 1e-6, 1e-5, 3e-5, 1e-4, 3e-4};

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Point<double> as_point(const Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

Vector3d direction(const Matrix3d& directions, const Vector3d& b) {
    return directions * b;
}

/// Everything that depends on the partition but not on the degree.
class Division {
  public:
    Division(const Problem& problem, const Partition& partition)
        : problem_(problem), partition_(partition) {
        std::vector<Point<double>> corners;
        for (const UnitCurve& curve : problem.curves) {
            corners.push_back(as_point(curve(0.0)));
        }
        const Point<double> centre = as_point(problem.view.centre);
        const auto points = ray_points(partition, corners, as_point(problem.view.outer));
        for (const Point<double>& p : points) {
            rays_.emplace_back(Vector3d(p[0], p[1], p[2]) - problem.view.centre);
        }
        for (const Interface& i : partition.interfaces) {
            Polynomial<double> plane =
                plane_through(centre, points[static_cast<std::size_t>(i.from)],
                              points[static_cast<std::size_t>(i.to)]);
            const double length = coefficients(plane).tail<3>().norm();
            planes_.push_back((1.0 / length) * plane);
        }
        locate_guide();
        make_bands();
    }

    [[nodiscard]] const std::vector<Vector3d>& rays() const { return rays_; }
    [[nodiscard]] const std::vector<Polynomial<double>>& planes() const { return planes_; }
    [[nodiscard]] const std::vector<GuideSample>& guide() const { return guide_; }
    [[nodiscard]] const std::vector<Band>& bands() const { return bands_; }

  private:
    const Problem& problem_;
    const Partition& partition_;
    std::vector<Vector3d> rays_;
    std::vector<Polynomial<double>> planes_;
    std::vector<GuideSample> guide_;
    std::vector<std::vector<OnRay>> in_sector_;  ///< the guide's points in each sector
    std::vector<Band> bands_;

    /// Beyond the chord between its corners a side's sector goes on to the side itself.
    static double depth_in(const Sector& sector, const Vector3d& b) {
        return sector.side >= 0 ? std::min(b[0], b[1]) : b.minCoeff();
    }

    void locate_guide() {
        in_sector_.resize(partition_.sectors.size());
        for (const GuidePoint& g : problem_.guide) {
            double most = -INFINITY;
            std::size_t found = 0;
            OnRay place;
            for (std::size_t s = 0; s < partition_.sectors.size(); ++s) {
                const Sector& sector = partition_.sectors[s];
                const OnRay at =
                    on_ray(directions_of(sector, rays_), g.point - problem_.view.centre);
                const double depth = at.t > 0.0 ? depth_in(sector, at.b) : -INFINITY;
                if (depth > most) {
                    most = depth;
                    found = s;
                    place = at;
                }
            }
            in_sector_[found].push_back(place);
            guide_.push_back({partition_.sectors[found].cell, g.point, g.normal});
        }
    }

    void make_bands() {
        for (std::size_t s = 0; s < partition_.sectors.size(); ++s) {
            Matrix3d directions = directions_of(partition_.sectors[s], rays_);
            // A side that bulges beyond its chord: the triangle grows away from its apex.
            double beyond = 0.0;
            for (const OnRay& at : in_sector_[s]) {
                beyond = std::max(beyond, -at.b[2]);
            }
            for (const int c : {0, 1}) {
                directions.col(c) += beyond * (directions.col(c) - directions.col(2));
            }
            std::vector<Frustum> parts = {{problem_.view.centre, directions, 0.0, 0.0}};
            for (int n = 0; n < kQuarterings; ++n) {
                std::vector<Frustum> finer;
                for (const Frustum& part : parts) {
                    const auto quarters = quartered(part);
                    finer.insert(finer.end(), quarters.begin(), quarters.end());
                }
                parts = finer;
            }
            for (const Frustum& part : parts) {
                add_band(static_cast<int>(s), part);
            }
        }
    }

    /// Where the ray along d meets the guide, in lengths of d: its tangent plane at the point whose
    /// ray is nearest.
    [[nodiscard]] double on_guide(const Vector3d& d) const {
        double nearest = -INFINITY;
        double t = 0.0;
        for (const GuidePoint& g : problem_.guide) {
            const Vector3d from_centre = g.point - problem_.view.centre;
            const double cosine = from_centre.dot(d) / from_centre.norm();
            const double across = g.normal.dot(d);
            if (cosine > nearest && std::abs(across) > kGrazing * d.norm()) {
                nearest = cosine;
                t = g.normal.dot(from_centre) / across;
            }
        }
        return t;
    }

    /// The frustum of these rays on both sides of the guide. Its triangle stands on the guide, so
    /// that the layers follow it.
    void add_band(int s, Frustum part) {
        for (int c = 0; c < 3; ++c) {
            part.directions.col(c) *= on_guide(part.directions.col(c));
        }
        double low = INFINITY;
        double high = -INFINITY;
        double sum = 0.0;
        int count = 0;
        for (int i = 0; i <= kAcrossBand; ++i) {
            for (int j = 0; i + j <= kAcrossBand; ++j, ++count) {
                const Vector3d b =
                    Vector3d(kAcrossBand - i - j, i, j) / static_cast<double>(kAcrossBand);
                const double t = on_guide(direction(part.directions, b));
                low = std::min(low, t);
                high = std::max(high, t);
                sum += t;
            }
        }
        const double slack = kBand / direction(part.directions, Vector3d::Constant(1.0 / 3)).norm();
        part.t0 = std::max(0.0, low - slack);
        part.t1 = high + slack;
        bands_.push_back({s, part, (sum / count - part.t0) / (part.t1 - part.t0)});
    }
};

class Candidate {
  public:
    Candidate(const Problem& problem, const Partition& partition, const Division& division,
              int degree)
        : problem_(problem), division_(division) {
        solution_.partition = partition;
        solution_.rays = division.rays();
        solution_.degree = degree;
    }

    /// The best member, or why there is none.
    Result<Solution> find(double rank_tolerance, const Progress& progress) {
        if (!problem_.jets.empty()) {
            return find_by_jets();
        }
        const System<double> system =
            make_system(solution_.partition, problem_.sides, division_.planes(),
                        problem_.interface_k, solution_.degree);
        solution_.rows = system.rows;
        solution_.columns = system.columns;
        const Space space = solve(system, rank_tolerance);
        count(space);
        if (solution_.polynomials == 0) {
            return fail(ErrorCode::Refused, "no solution");
        }
        const Member member(space, division_.guide(), {});
        take(space, member.best());
        if (!(solution_.deviation <= kFarFromGuide)) {
            return too_far();
        }
        if (prove_sheet()) {
            return solution_;
        }
        const auto conditioned =
            member.best_under(conditions(), problem_.view.sign, kMargin, progress);
        if (!conditioned) {
            return fail(ErrorCode::Refused, "no member with a provably single sheet");
        }
        take(space, *conditioned);
        solution_.guided_only = false;
        if (!prove_sheet()) {
            return fail(ErrorCode::Refused, "the sheet could not be proven single");
        }
        return solution_;
    }

  private:
    const Problem& problem_;
    const Division& division_;
    Solution solution_;

    void count(const Space& space) {
        solution_.rank = space.rank;
        solution_.dimension = space.dimension;
        solution_.polynomials = static_cast<int>(space.basis.cols());
    }

    [[nodiscard]] tl::unexpected<Error> too_far() const {
        return fail(ErrorCode::Refused, "no member near the hole ({:.2g} off)",
                    solution_.deviation);
    }

    /// Of the members that meet the sides well enough the one nearest to the guide: a miss may
    /// cost as little as the limits at the sides allow.
    Result<Solution> find_by_jets() {
        const JetSpace jets(solution_.partition, problem_.jets, division_.planes(),
                            problem_.interface_k, solution_.degree);
        solution_.rows = jets.rows();
        solution_.columns = jets.columns();
        const Space space = jets.within(kMostMiss);
        count(space);
        std::optional<Solution> best;
        double least_angle = kPi;
        double least_distance = INFINITY;
        for (const double miss : kMisses) {
            if (space.dimension == 0) {
                break;
            }
            GuideWeights weights;
            weights.miss = miss;
            take(space, Member(space, division_.guide(), weights).best());
            least_angle = std::min(least_angle, solution_.side_angle);
            least_distance = std::min(least_distance, solution_.side_distance);
            if (solution_.side_angle <= problem_.at_sides.angular &&
                solution_.side_distance <= problem_.at_sides.linear &&
                (!best || solution_.deviation < best->deviation)) {
                best = solution_;
            }
            if (best && best->deviation <= kNearGuide) {
                break;
            }
        }
        if (!best) {
            return fail(ErrorCode::Refused,
                        "no member nearer to the sides than {:.2g} deg and {:.1g} of the radius",
                        degrees(least_angle), least_distance);
        }
        solution_ = *best;
        if (!(solution_.deviation <= kFarFromGuide)) {
            return too_far();
        }
        // Sufficient conditions are no necessary ones: see_sheet finds most of the rest.
        solution_.proven = prove_sheet();
        if (!solution_.proven && !see_sheet()) {
            return fail(ErrorCode::Refused,
                        "rays meet the sheet more than once, or not at all ({:.2g} off)",
                        solution_.deviation);
        }
        return solution_;
    }

    void take(const Space& space, const VectorXd& x) {
        const VectorXd g = space.basis * x;
        solution_.cells =
            split_cells(std::vector<double>(g.data(), g.data() + g.size()), solution_.degree);
        double sum = 0.0;
        for (const GuideSample& sample : division_.guide()) {
            const ValueAndGradient at =
                evaluate(solution_.cells[static_cast<std::size_t>(sample.cell)], sample.point);
            const double distance = at.value / at.gradient.norm();
            const double angle = angle_between(at.gradient, sample.normal);
            sum += distance * distance + angle * angle;
        }
        solution_.deviation = std::sqrt(sum / static_cast<double>(division_.guide().size()));
        measure_sides();
    }

    void measure_sides() {
        solution_.side_distance = solution_.side_angle = 0.0;
        for (std::size_t i = 0; i < problem_.jets.size(); ++i) {
            for (const SideJet& jet : problem_.jets[i].jets) {
                const ValueAndGradient at = evaluate(solution_.cells[i], jet.point);
                solution_.side_distance =
                    std::max(solution_.side_distance, std::abs(at.value) / at.gradient.norm());
                solution_.side_angle =
                    std::max(solution_.side_angle, angle_between(at.gradient, jet.normal));
            }
        }
    }

    [[nodiscard]] int cell_of(const Band& band) const {
        return solution_.partition.sectors[static_cast<std::size_t>(band.sector)].cell;
    }

    bool prove_sheet() {
        solution_.slope = INFINITY;
        for (const Band& band : division_.bands()) {
            const Proof proof = prove(solution_.cells[static_cast<std::size_t>(cell_of(band))],
                                      band.frustum, problem_.view.sign, 0.0, kProofDepth);
            if (!proof.single) {
                return false;
            }
            solution_.slope = std::min(
                solution_.slope, proof.slope / band.frustum.directions.colwise().norm().maxCoeff());
        }
        return true;
    }

    /// Rays all over the hole meet the sheet once near the guide, and across it; a sheet that
    /// leaves the guide's band may be the only one in a wider one, and one that keeps to the guide
    /// in a narrower one.
    bool see_sheet() {
        for (const double width : kWidths) {
            solution_.seen = width * kBand;
            if (std::all_of(division_.guide().begin(), division_.guide().end(),
                            [&](const GuideSample& s) { return meets_once(s, solution_.seen); })) {
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] bool meets_once(const GuideSample& sample, double slack) const {
        constexpr int kSteps = 16;
        const auto& g = solution_.cells[static_cast<std::size_t>(sample.cell)];
        const Vector3d ray = (sample.point - problem_.view.centre).normalized();
        bool above = false;
        for (int n = 0; n <= kSteps; ++n) {
            const double t = slack * (2.0 * n / kSteps - 1.0);
            const double value = problem_.view.sign * evaluate(g, sample.point + t * ray).value;
            if (n == 0 ? value >= 0.0 : above && value <= 0.0) {
                return false;
            }
            above = value > 0.0;
        }
        return above;
    }

    [[nodiscard]] std::vector<SheetCondition> conditions() const {
        std::vector<SheetCondition> result;
        for (const Band& band : division_.bands()) {
            const int split =
                std::clamp(static_cast<int>(std::lround(band.middle * solution_.degree)), 1,
                           std::max(1, solution_.degree - 1));
            result.push_back({cell_of(band), band.frustum, split});
        }
        return result;
    }
};

}  // namespace

OnRay on_ray(const Matrix3d& directions, const Vector3d& from_centre) {
    const Vector3d raw = directions.partialPivLu().solve(from_centre);
    const double t = raw.sum();
    return {raw / t, t};
}

Matrix3d directions_of(const Sector& sector, const std::vector<Vector3d>& rays) {
    Matrix3d directions;
    for (int c = 0; c < 3; ++c) {
        directions.col(c) =
            rays[static_cast<std::size_t>(sector.rays[static_cast<std::size_t>(c)])];
    }
    return directions;
}

Result<Solution> find_solution(const Problem& problem, const Search& search,
                               const Progress& progress) {
    if (const auto agreeing = expect_agreeing_corners(problem); !agreeing) {
        return tl::unexpected(agreeing.error());
    }
    int lowest = problem.interface_k + 1;
    for (const Side<double>& side : problem.sides) {
        lowest = std::max({lowest, side.f.degree, side.k + 1});
    }
    for (const SideJets& side : problem.jets) {
        lowest = std::max(lowest, side.k + 1);
    }
    const int n = static_cast<int>(problem.curves.size());
    const Partition partitions[] = {umbrella(n), with_inner_cells(n)};
    const Division divisions[] = {Division(problem, partitions[0]),
                                  Division(problem, partitions[1])};
    std::optional<Solution> best;
    std::vector<std::string> tried;
    const int from = search.degree.value_or(lowest);
    const int to = search.degree.value_or(lowest + kMostRaised);
    for (int degree = std::max(lowest, from); degree <= to; ++degree) {
        for (const bool inner : {false, true}) {
            const bool dear = inner && degree >= lowest + kMostRaised && !search.inner_cells;
            if (dear || search.inner_cells.value_or(inner) != inner) {
                continue;
            }
            if (progress.cancelled()) {
                return fail(ErrorCode::Cancelled, "stopped while filling");
            }
            const auto p = static_cast<std::size_t>(inner);
            const std::string name =
                fmt::format("degree {} in {} cells", degree, partitions[p].cells);
            progress(static_cast<double>(degree - from) / (to - from + 1.0), name);
            const auto found = Candidate(problem, partitions[p], divisions[p], degree)
                                   .find(search.rank_tolerance, progress);
            if (!found) {
                tried.push_back(fmt::format("{}: {}", name, found.error().message));
                continue;
            }
            if (!best || found->deviation < best->deviation) {
                if (best) {
                    tried.push_back(fmt::format("degree {} in {} cells: {:.2g} off the guide",
                                                best->degree, best->partition.cells,
                                                best->deviation));
                }
                best = *found;
            } else {
                tried.push_back(fmt::format("{}: {:.2g} off the guide", name, found->deviation));
            }
            if (best->deviation <= kNearGuide) {
                best->tried = tried;
                return *best;
            }
        }
    }
    if (!best) {
        return fail(ErrorCode::Refused, "no piecewise polynomial of degree {} to {} joins: {}",
                    std::max(lowest, from), to, fmt::join(tried, "; "));
    }
    best->tried = tried;
    return *best;
}

}  // namespace suture::algebraic

#include "suture/candidates/twins.h"

#include "suture/candidates/loop_points.h"
#include "suture/candidates/to_surface.h"
#include "suture/occ/convert.h"
#include "suture/occ/model_surface.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <cmath>
#include <memory>

namespace suture {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Outlines whose lengths differ by more than this share, or whose points by more than this share
/// of the hole's diameter, are not congruent.
constexpr double kLength = 1e-3;
constexpr double kCongruent = 3e-4;

/// Points around an outline.
constexpr int kPoints = 48;

/// The best twins that are offered.
constexpr std::size_t kMost = 4;

/// Entries of a rotation this near to 0 and 1 are meant to be.
constexpr double kPlain = 1e-6;

/// Rotations nearer than this are one.
constexpr double kSame = 1e-3;

/// x = R y + t, and how far it misses.
struct Motion {
    Matrix3d R = Matrix3d::Identity();
    Vector3d t = Vector3d::Zero();
    double miss = INFINITY;
};

Motion with_rotation(const Matrix3Xd& x, const Matrix3Xd& y, const Matrix3d& R) {
    Motion motion;
    motion.R = R;
    motion.t = x.rowwise().mean() - R * y.rowwise().mean();
    motion.miss = (x - ((R * y).colwise() + motion.t)).colwise().norm().maxCoeff();
    return motion;
}

/// The best rotation of y onto x, or the best reflection.
Motion align(const Matrix3Xd& x, const Matrix3Xd& y, bool mirrored) {
    const Vector3d mean_x = x.rowwise().mean();
    const Vector3d mean_y = y.rowwise().mean();
    const Matrix3d H = (y.colwise() - mean_y) * (x.colwise() - mean_x).transpose();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Matrix3d U = svd.matrixU();
    const Matrix3d V = svd.matrixV();
    const double handed = (V * U.transpose()).determinant() > 0.0 ? 1.0 : -1.0;
    const Vector3d sign(1.0, 1.0, mirrored ? -handed : handed);
    return with_rotation(x, y, V * sign.asDiagonal() * U.transpose());
}

/// Axes that are swapped and turned around exactly, where that fits as well.
Motion plain(const Motion& motion, const Matrix3Xd& x, const Matrix3Xd& y) {
    const Matrix3d round = motion.R.array().round();
    if ((round - motion.R).cwiseAbs().maxCoeff() > kPlain) {
        return motion;
    }
    const Motion exact = with_rotation(x, y, round);
    return exact.miss <= 1.5 * motion.miss + 1e-9 * (1.0 + x.cwiseAbs().maxCoeff()) ? exact
                                                                                    : motion;
}

std::vector<TopoDS_Edge> outline_of(const TopoDS_Face& face) {
    std::vector<TopoDS_Edge> edges;
    const TopoDS_Wire wire = BRepTools::OuterWire(face);
    if (wire.IsNull()) {
        return edges;
    }
    for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next()) {
        const TopoDS_Edge edge = it.Current();
        if (BRep_Tool::IsClosed(edge, face)) {
            return {};  // a seam: the outline is no simple loop
        }
        double first = 0.0;
        double last = 0.0;
        if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::Curve(edge, first, last).IsNull()) {
            edges.push_back(edge);
        }
    }
    return edges;
}

/// How far points lie from their middle: the same for congruent ones.
Eigen::RowVectorXd radii_of(const Matrix3Xd& points) {
    return (points.colwise() - points.rowwise().mean()).colwise().norm();
}

/// All motions of an outline onto the hole's that fit: a planar one has a turn and a mirror image.
/// One corner of the hole has to be a corner of the other outline.
std::vector<Motion> motions(const std::vector<Matrix3Xd>& hole, const LoopPoints& twin,
                            double limit) {
    std::vector<Motion> found;
    for (const double start : twin.corners()) {
        for (const bool backwards : {false, true}) {
            const Matrix3Xd y = twin.points(start, kPoints, backwards);
            const Eigen::RowVectorXd radii = radii_of(y);
            for (const Matrix3Xd& x : hole) {
                if ((radii_of(x) - radii).cwiseAbs().maxCoeff() > limit) {
                    continue;  // a motion would miss by as much
                }
                for (const bool mirrored : {false, true}) {
                    const Motion motion = align(x, y, mirrored);
                    const bool known =
                        std::any_of(found.begin(), found.end(), [&](const Motion& other) {
                            return (other.R - motion.R).norm() < kSame &&
                                   (other.t - motion.t).norm() < limit;
                        });
                    if (motion.miss <= limit && !known) {
                        found.push_back(plain(motion, x, y));
                    }
                }
            }
        }
    }
    return found;
}

Eigen::Isometry3d isometry(const Motion& motion) {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = motion.R;
    result.translation() = motion.t;
    return result;
}

gp_Trsf to_occ(const Motion& motion) {
    gp_Trsf result;
    const Matrix3d& R = motion.R;
    const Vector3d& t = motion.t;
    result.SetValues(R(0, 0), R(0, 1), R(0, 2), t[0], R(1, 0), R(1, 1), R(1, 2), t[1], R(2, 0),
                     R(2, 1), R(2, 2), t[2]);
    return result;
}

struct Twin {
    Motion motion;
    TopoDS_Face face;
};

}  // namespace

std::vector<Candidate> find_twins(const std::vector<TopoDS_Face>& faces,
                                  const occ::Numbering& numbering,
                                  const std::vector<BoundaryLoop>& loops, const Hole& hole) {
    // The first loop is the outer one. Where the islands lie, on which side, is seen on the
    // surface.
    std::vector<TopoDS_Edge> sides;
    for (const BoundaryEdge& edge : loops.front().edges) {
        sides.push_back(edge.edge);
    }
    const LoopPoints own(sides);
    std::vector<Matrix3Xd> points;
    for (const double start : own.corners()) {
        points.push_back(own.points(start, kPoints, /*backwards=*/false));
    }
    std::vector<Twin> twins;
    for (const TopoDS_Face& face : faces) {
        const std::vector<TopoDS_Edge> outline = outline_of(face);
        if (outline.empty()) {
            continue;
        }
        const LoopPoints other(outline);
        if (std::abs(other.length() - own.length()) > kLength * own.length()) {
            continue;
        }
        for (const Motion& motion : motions(points, other, kCongruent * hole.diameter)) {
            twins.push_back({motion, face});
        }
    }
    std::stable_sort(twins.begin(), twins.end(),
                     [](const Twin& a, const Twin& b) { return a.motion.miss < b.motion.miss; });
    std::vector<Candidate> candidates;
    for (const Twin& twin : twins) {
        if (candidates.size() == kMost) {
            break;
        }
        const occ::Handle<Geom_Surface> moved = occ::cast<Geom_Surface>(
            BRep_Tool::Surface(twin.face)->Transformed(to_occ(twin.motion)));
        const auto surface = to_surface(moved, hole);
        if (!surface) {
            continue;
        }
        const bool mirrored = twin.motion.R.determinant() < 0.0;
        double noise = 0.0;
        for (const TopoDS_Edge& edge : occ::edges_of(twin.face)) {
            noise = std::max(noise, BRep_Tool::Tolerance(edge));
        }
        candidates.push_back(
            {*surface, "twin",
             fmt::format("{} of face {}", mirrored ? "mirrored twin" : "twin",
                         numbering.of(twin.face)),
             std::min(1.5 * noise, kCongruent * hole.diameter) + 2.0 * twin.motion.miss, 1.0,
             TwinSource{numbering.of(twin.face), isometry(twin.motion)},
             std::make_shared<const ModelSurface>(ModelSurface{moved})});
    }
    return candidates;
}

}  // namespace suture

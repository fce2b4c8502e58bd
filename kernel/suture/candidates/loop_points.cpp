#include "suture/candidates/loop_points.h"

#include "suture/occ/convert.h"

#include <BRepAdaptor_Curve.hxx>

#include <algorithm>
#include <array>
#include <cmath>

namespace suture {
namespace {

/// Intervals of an edge over which its length is integrated, with the points of Gauss's rule of
/// order 10.
constexpr int kIntervals = 16;
constexpr std::array<double, 5> kGauss = {-0.9061798459386640, -0.5384693101056831, 0.0,
                                          0.5384693101056831, 0.9061798459386640};
constexpr std::array<double, 5> kWeights = {0.2369268850561891, 0.4786286704993665,
                                            0.5688888888888889, 0.4786286704993665,
                                            0.2369268850561891};
constexpr int kNewton = 8;

double speed(const BRepAdaptor_Curve& curve, double t) {
    gp_Pnt p;
    gp_Vec d;
    curve.D1(t, p, d);
    return d.Magnitude();
}

double length_between(const BRepAdaptor_Curve& curve, double a, double b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < kGauss.size(); ++k) {
        sum += kWeights[k] * speed(curve, 0.5 * (a + b) + 0.5 * (b - a) * kGauss[k]);
    }
    return 0.5 * std::abs(b - a) * sum;
}

}  // namespace

LoopPoints::LoopPoints(const std::vector<TopoDS_Edge>& edges) : starts_{0.0} {
    for (const TopoDS_Edge& edge : edges) {
        const BRepAdaptor_Curve curve(edge);
        const bool backwards = edge.Orientation() == TopAbs_REVERSED;
        const double from = backwards ? curve.LastParameter() : curve.FirstParameter();
        const double to = backwards ? curve.FirstParameter() : curve.LastParameter();
        Piece piece{edge, {from}, {0.0}};
        for (int k = 1; k <= kIntervals; ++k) {
            const double a = piece.parameters.back();
            const double b = from + (to - from) * k / kIntervals;
            piece.lengths.push_back(piece.lengths.back() + length_between(curve, a, b));
            piece.parameters.push_back(b);
        }
        starts_.push_back(starts_.back() + piece.lengths.back());
        pieces_.push_back(std::move(piece));
    }
}

std::vector<double> LoopPoints::corners() const {
    return {starts_.begin(), starts_.end() - 1};
}

Eigen::Vector3d LoopPoints::at(double length) const {
    length -= std::floor(length / starts_.back()) * starts_.back();
    const auto it = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, length);
    const auto k = static_cast<std::size_t>(it - starts_.begin()) - 1;
    const Piece& piece = pieces_[k];
    const BRepAdaptor_Curve curve(piece.edge);
    const double target = length - starts_[k];
    const auto found = std::upper_bound(piece.lengths.begin() + 1, piece.lengths.end() - 1, target);
    const auto i = static_cast<std::size_t>(found - piece.lengths.begin()) - 1;
    const double a = piece.parameters[i];
    const double b = piece.parameters[i + 1];
    double t = a;
    for (int step = 0; step < kNewton; ++step) {
        const double miss = target - piece.lengths[i] - length_between(curve, a, t);
        const double rate = speed(curve, t);
        if (!(rate > 0.0)) {
            break;
        }
        const double way = miss / rate * (b > a ? 1.0 : -1.0);
        t = std::clamp(t + way, std::min(a, b), std::max(a, b));
    }
    return occ::from_occ(curve.Value(t));
}

Eigen::Matrix3Xd LoopPoints::points(double start, int count, bool backwards) const {
    Eigen::Matrix3Xd result(3, count);
    for (int k = 0; k < count; ++k) {
        const double way = length() * k / count;
        result.col(k) = at(backwards ? start - way : start + way);
    }
    return result;
}

}  // namespace suture

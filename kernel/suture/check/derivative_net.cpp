#include "suture/check/derivative_net.h"

#include <Eigen/Geometry>

#include <TColStd_Array1OfReal.hxx>

#include <algorithm>
#include <cmath>

namespace suture {

namespace {

/// First and last pole that act between two parameters.
std::array<int, 2> acting(const std::vector<double>& knots, int degree, double low, double high) {
    const int last_span = static_cast<int>(knots.size()) - degree - 2;
    const auto span = [&](auto found) {
        return std::clamp(static_cast<int>(found - knots.begin()) - 1, degree, last_span);
    };
    const int from = span(std::upper_bound(knots.begin(), knots.end(), low));
    const int to = span(std::lower_bound(knots.begin(), knots.end(), high));
    return {from - degree, std::max(from, to)};
}

}  // namespace

bool DerivativeNet::covers(const ParameterBox& box) const {
    const auto end = [&](std::size_t k, bool high) {
        const auto p = static_cast<std::size_t>(degrees.at(k));
        return knots.at(k)[high ? knots.at(k).size() - p - 1 : p];
    };
    return ParameterBox{{end(0, false), end(1, false)}, {end(0, true), end(1, true)}}.holds(box);
}

Eigen::AlignedBox3d DerivativeNet::hull(const ParameterBox& box) const {
    const auto [u0, u1] = acting(knots[0], degrees[0], box.low[0], box.high[0]);
    const auto [v0, v1] = acting(knots[1], degrees[1], box.low[1], box.high[1]);
    Eigen::AlignedBox3d result;
    for (int i = u0; i <= u1; ++i) {
        for (int j = v0; j <= v1; ++j) {
            result.extend(poles[static_cast<std::size_t>(i * poles_v + j)]);
        }
    }
    return result;
}

bool DerivativeNet::is_monotone(const ParameterBox& box) const {
    if (by_u.empty() || by_v.empty() || !covers(box)) {
        return false;
    }
    const auto [u0, u1] = acting(knots[0], degrees[0], box.low[0], box.high[0]);
    const auto [v0, v1] = acting(knots[1], degrees[1], box.low[1], box.high[1]);
    std::vector<Eigen::Vector3d> along_u;
    std::vector<Eigen::Vector3d> along_v;
    for (int i = u0; i <= u1; ++i) {
        for (int j = v0; j <= v1; ++j) {
            if (i < u1) {
                along_u.push_back(by_u[static_cast<std::size_t>(i * poles_v + j)]);
            }
            if (j < v1) {
                along_v.push_back(by_v[static_cast<std::size_t>(i * (poles_v - 1) + j)]);
            }
        }
    }
    return suture::is_monotone(along_u, along_v);
}

bool is_monotone(const std::vector<Eigen::Vector3d>& by_u,
                 const std::vector<Eigen::Vector3d>& by_v) {
    const auto mean = [](const std::vector<Eigen::Vector3d>& vectors) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& v : vectors) {
            sum += v;
        }
        return Eigen::Vector3d(sum / static_cast<double>(vectors.size()));
    };
    const Eigen::Vector3d u = mean(by_u);
    const Eigen::Vector3d v = mean(by_v);
    const double determinant = u.cross(v).squaredNorm();
    if (!(determinant > 1e-12 * u.squaredNorm() * v.squaredNorm())) {
        return false;
    }
    // The dual basis: a.u = b.v = 1, a.v = b.u = 0; scaled so that both directions count alike.
    const double stretch = u.norm() / v.norm();
    const Eigen::Vector3d a = (v.squaredNorm() * u - u.dot(v) * v) / determinant;
    const Eigen::Vector3d b = (u.squaredNorm() * v - u.dot(v) * u) / determinant;
    double least_u = 1.0;
    double least_v = 1.0;
    double most_u = 0.0;
    double most_v = 0.0;
    for (const Eigen::Vector3d& d : by_u) {
        least_u = std::min(least_u, a.dot(d));
        most_u = std::max(most_u, std::abs(b.dot(d)) / stretch);
    }
    for (const Eigen::Vector3d& d : by_v) {
        least_v = std::min(least_v, b.dot(d));
        most_v = std::max(most_v, std::abs(a.dot(d)) * stretch);
    }
    const double mixed = 0.5 * (most_u + most_v);
    return least_u > 0.0 && least_v > 0.0 && least_u * least_v > mixed * mixed;
}

DerivativeNet make_derivative_net(const occ::Handle<Geom_BSplineSurface>& given,
                                  const gp_Trsf& location) {
    occ::Handle<Geom_BSplineSurface> opened = given;
    if (given->IsUPeriodic() || given->IsVPeriodic()) {
        opened = occ::cast<Geom_BSplineSurface>(given->Copy());
        opened->SetUNotPeriodic();
        opened->SetVNotPeriodic();
    }
    const Geom_BSplineSurface& surface = *opened;
    DerivativeNet net;
    net.degrees = {surface.UDegree(), surface.VDegree()};
    net.poles_v = surface.NbVPoles();
    const int poles_u = surface.NbUPoles();
    const TColStd_Array1OfReal& u = surface.UKnotSequence();
    const TColStd_Array1OfReal& v = surface.VKnotSequence();
    net.knots = {std::vector<double>(u.begin(), u.end()), std::vector<double>(v.begin(), v.end())};
    for (int i = 1; i <= poles_u; ++i) {
        for (int j = 1; j <= net.poles_v; ++j) {
            const gp_Pnt pole = surface.Pole(i, j).Transformed(location);
            net.poles.emplace_back(pole.X(), pole.Y(), pole.Z());
        }
    }
    if (surface.IsURational() || surface.IsVRational()) {
        return net;
    }
    // The derivative's pole between poles i and i + 1 is degree (P - P) / (t - t).
    const auto factor = [&](std::size_t k, int i) {
        const auto p = static_cast<std::size_t>(net.degrees.at(k));
        const auto at = static_cast<std::size_t>(i);
        const double width = net.knots.at(k)[at + p + 1] - net.knots.at(k)[at + 1];
        return width > 0.0 ? net.degrees.at(k) / width : 0.0;
    };
    for (int i = 0; i < poles_u; ++i) {
        for (int j = 0; j < net.poles_v; ++j) {
            const auto here = static_cast<std::size_t>(i * net.poles_v + j);
            if (i + 1 < poles_u) {
                const auto next = here + static_cast<std::size_t>(net.poles_v);
                net.by_u.emplace_back(factor(0, i) * (net.poles[next] - net.poles[here]));
            }
            if (j + 1 < net.poles_v) {
                net.by_v.emplace_back(factor(1, j) * (net.poles[here + 1] - net.poles[here]));
            }
        }
    }
    return net;
}

}  // namespace suture

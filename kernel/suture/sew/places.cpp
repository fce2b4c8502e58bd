#include "suture/sew/places.h"

#include <algorithm>
#include <numeric>

namespace suture {

int Places::add(const Eigen::Vector3d& point, const TopoDS_Vertex& vertex, double accuracy) {
    const int number = count();
    points_.push_back(point);
    vertices_.push_back(vertex);
    accuracies_.push_back(accuracy);
    parent_.push_back(number);
    return number;
}

int Places::of(int point) const {
    while (parent_[point] != point) {
        parent_[point] = parent_[parent_[point]];
        point = parent_[point];
    }
    return point;
}

void Places::unite(int a, int b) {
    const int one = of(a);
    const int other = of(b);
    parent_[std::max(one, other)] = std::min(one, other);
}

void Places::unite(std::vector<Link> links, const std::vector<std::pair<int, int>>& short_edges) {
    std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
        return a.distance != b.distance ? a.distance < b.distance
                                        : std::pair(a.a, a.b) < std::pair(b.a, b.b);
    });
    // per place: the far ends of the short edges that begin there
    std::vector<std::vector<int>> across(points_.size());
    for (const auto& [a, b] : short_edges) {
        across[of(a)].push_back(b);
        across[of(b)].push_back(a);
    }
    for (const Link& link : links) {
        int a = of(link.a);
        int b = of(link.b);
        if (a == b) {
            continue;
        }
        if (across[a].size() > across[b].size()) {
            std::swap(a, b);
        }
        if (std::any_of(across[a].begin(), across[a].end(),
                        [&](int far) { return of(far) == b; })) {
            continue;
        }
        unite(a, b);
        const int both = of(a);
        const int gone = both == a ? b : a;
        across[both].insert(across[both].end(), across[gone].begin(), across[gone].end());
    }
}

std::vector<Places::Link> Places::near(double limit) const {
    std::vector<int> order(points_.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<Link> links;
    if (points_.empty()) {
        return links;
    }
    // Along the longest side of all points few of them lie within the limit of each other.
    Eigen::Vector3d low = points_.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& p : points_) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    // A skew direction tells points of a grid apart that agree in a coordinate.
    const Eigen::Vector3d direction =
        ((high - low).cwiseAbs() + Eigen::Vector3d(1e-3, 0.31, 0.73) * (high - low).norm())
            .normalized();
    const auto along = [&](int i) { return direction.dot(points_[i]); };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return along(a) < along(b); });
    const double widest = *std::max_element(accuracies_.begin(), accuracies_.end());
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            if (along(order[k]) - along(order[i]) >
                limit + kAccuracy * (accuracies_[order[i]] + widest)) {
                break;
            }
            const double distance = (points_[order[k]] - points_[order[i]]).norm();
            if (distance <= reach(order[i], order[k], limit)) {
                links.push_back({order[i], order[k], distance});
            }
        }
    }
    return links;
}

}  // namespace suture

#include "suture/fill/tube/unknowns.h"

#include "suture/base/contract.h"

#include <vector>

namespace suture::tube {
namespace {

using Eigen::Vector3d;

/// Collects the rows of the map.
class Builder {
  public:
    Builder(const Net& net, const FairingTask& task)
        : net_(net), task_(task), fixed_(Eigen::VectorXd::Zero(3 * net.points.cols())) {
        SUTURE_EXPECTS(static_cast<int>(task.closing.directions.size()) == net.columns());
        SUTURE_EXPECTS(!task.magnitudes ||
                       static_cast<int>(task.magnitudes->size()) == net.columns());
        mean_.assign(static_cast<std::size_t>(net.columns()), nullptr);
        for (const Ring::Double& corner : net.ring.doubles()) {
            mean_[static_cast<std::size_t>(corner.column)] = &corner;
        }
    }

    void run(Unknowns& result) {
        for (int j = 0; j < net_.columns(); ++j) {
            const bool mean = mean_[static_cast<std::size_t>(j)] != nullptr;
            if (!task_.magnitudes && !mean) {
                tangents_.push_back(count_++);
            } else {
                tangents_.push_back(-1);
            }
        }
        const int free_rows = task_.free_rows ? net_.rows() - 4 : 0;
        for (int j = 0; j < net_.columns(); ++j) {
            rows_.push_back(count_);
            count_ += mean_[static_cast<std::size_t>(j)] != nullptr ? 0 : 3 * free_rows;
        }
        if (task_.moving) {
            pole_ = count_;
            count_ += 3;
        }
        for (int j = 0; j < net_.columns(); ++j) {
            for (int i = 0; i < net_.rows(); ++i) {
                add(i, j, i, j, 1.0);
            }
        }
        result.map.resize(3 * net_.points.cols(), count_);
        result.map.setFromTriplets(entries_.begin(), entries_.end());
        result.fixed = std::move(fixed_);
        result.pole = pole_;
    }

  private:
    const Net& net_;
    const FairingTask& task_;
    Eigen::VectorXd fixed_;
    std::vector<const Ring::Double*> mean_;
    std::vector<Eigen::Triplet<double>> entries_;
    std::vector<int> tangents_;  ///< of each column
    std::vector<int> rows_;      ///< of each column's row 2
    int count_ = 0;
    int pole_ = -1;

    /// Adds share times what point (row, column) is made of to the point (to_row, to_column).
    void add(int to_row, int to_column, int row, int column, double share) {
        const int target = 3 * net_.index(to_row, to_column);
        const int last_free = net_.rows() - 3;
        const Ring::Double* mean = mean_[static_cast<std::size_t>(net_.ring.wrapped(column))];
        if (row > last_free || (row >= 2 && !task_.free_rows)) {
            fixed_.segment<3>(target) += share * net_.point(row, column);
        } else if (row >= 1 && mean != nullptr) {
            add(to_row, to_column, row, column - 1, share * mean->before);
            add(to_row, to_column, row, column + 1, share * (1.0 - mean->before));
        } else if (row <= 1) {
            add_pole(target, share);
            if (row == 1) {
                add_tangent(target, net_.ring.wrapped(column), share * net_.first_step() / 3.0);
            }
        } else {
            const int first = rows_[static_cast<std::size_t>(net_.ring.wrapped(column))];
            for (int c = 0; c < 3; ++c) {
                entries_.emplace_back(target + c, first + 3 * (row - 2) + c, share);
            }
        }
    }

    void add_pole(int target, double share) {
        if (pole_ < 0) {
            fixed_.segment<3>(target) += share * task_.closing.pole;
            return;
        }
        for (int c = 0; c < 3; ++c) {
            entries_.emplace_back(target + c, pole_ + c, share);
        }
    }

    void add_tangent(int target, int column, double share) {
        const auto j = static_cast<std::size_t>(column);
        const Vector3d& direction = task_.closing.directions[j];
        if (tangents_[j] < 0) {
            fixed_.segment<3>(target) += share * (*task_.magnitudes)[j] * direction;
            return;
        }
        for (int c = 0; c < 3; ++c) {
            entries_.emplace_back(target + c, tangents_[j], share * direction[c]);
        }
    }
};

}  // namespace

Unknowns::Unknowns(const Net& net, const FairingTask& task) {
    Builder(net, task).run(*this);
}

Eigen::Matrix3Xd Unknowns::points(const Eigen::VectorXd& x) const {
    const Eigen::VectorXd all = map * x + fixed;
    return Eigen::Map<const Eigen::Matrix3Xd>(all.data(), 3, all.size() / 3);
}

}  // namespace suture::tube

#pragma once

#include <Eigen/Core>

#include <vector>

namespace suture::mvs {

/// A symmetric matrix of blocks x blocks square blocks that vanishes beyond `width` blocks off the
/// diagonal: what a tensor-product spline of degree `width` couples. Only blocks on and below the
/// diagonal are kept, and of those on it only the lower triangle counts.
class BlockBand {
  public:
    BlockBand(int blocks, int size, int width);

    [[nodiscard]] int blocks() const { return static_cast<int>(columns_.size()); }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int rows() const { return blocks() * size_; }

    /// Block column j: its block i (j <= i <= j + width) starts at row (i - j) * size.
    [[nodiscard]] Eigen::MatrixXd& column(int j) { return columns_[static_cast<std::size_t>(j)]; }
    [[nodiscard]] const Eigen::MatrixXd& column(int j) const {
        return columns_[static_cast<std::size_t>(j)];
    }

    /// Adds factor * other to each of the components that a row of `other` stands for: other has
    /// blocks a whole number of times smaller, and nothing in them beyond its width.
    void add_per_component(const BlockBand& other, double factor);

    /// Input    a column a vector.
    [[nodiscard]] Eigen::MatrixXd times(const Eigen::MatrixXd& x) const;

    /// Replaces the matrix by its Cholesky factor. False where it is not positive definite.
    [[nodiscard]] bool factorise();

    /// The multiplications that factorise() takes.
    [[nodiscard]] static double work(int blocks, int size, int width);

    /// Solves with the factor.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  private:
    [[nodiscard]] int reach(int j) const;  // block rows in block column j

    std::vector<Eigen::MatrixXd> columns_;
    int size_;
    int width_;
};

}  // namespace suture::mvs

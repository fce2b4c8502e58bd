#pragma once

#include <TopoDS_Face.hxx>

#include <array>
#include <vector>

namespace suture {

/// A box of a surface's parameters.
struct ParameterBox {
    std::array<double, 2> low = {0.0, 0.0}, high = {0.0, 0.0};

    [[nodiscard]] double middle(std::size_t k) const { return 0.5 * (low.at(k) + high.at(k)); }
    [[nodiscard]] double size(std::size_t k) const { return high.at(k) - low.at(k); }
    [[nodiscard]] bool meets(const ParameterBox& other) const;
    /// But for rounding.
    [[nodiscard]] bool holds(const ParameterBox& other) const;
};

/// The part of its surface's parameters that a face covers: what lies within its loops.
///
/// The loops are polylines through points of the pcurves, each piece with the distance that its
/// curve was seen to keep from it.
class FaceDomain {
  public:
    explicit FaceDomain(const TopoDS_Face& face);

    /// The smallest box around the loops; the surface's own bounds where there is none.
    [[nodiscard]] const ParameterBox& box() const { return box_; }

    /// The loops close in the parameters. If not, nothing is known to lie outside.
    [[nodiscard]] bool closed() const { return closed_; }

    /// Area within the loops in the parameters' units, negative if they run clockwise: the face
    /// then is what lies around them.
    [[nodiscard]] double signed_area() const { return area_; }

    enum class Part { Inside, Outside, Border };
    /// A box that no loop passes lies inside or outside as a whole.
    ///
    /// Input   near: the pieces of the loops that may pass the box (see all_pieces).
    /// Result  `near` keeps those that do: enough for any box within this one.
    [[nodiscard]] Part classify(const ParameterBox& box, std::vector<int>& near) const;
    [[nodiscard]] std::vector<int> all_pieces() const;

    /// Inside the loops; of a point as near to a loop as its polyline is, either answer may come.
    [[nodiscard]] bool contains(double u, double v) const;

    /// The same point, moved by the surface's periods into the box, where it has any.
    [[nodiscard]] std::array<double, 2> in_period(double u, double v) const;

  private:
    /// A piece of a loop, with the face to its left, and how far the curve may be from it.
    struct Piece {
        std::array<double, 2> from, to;
        double deviation = 0.0;
    };
    void add_loop(std::vector<std::vector<Piece>> edges);
    void set_bounds(const TopoDS_Face& face);

    std::vector<Piece> pieces_;
    ParameterBox box_;
    std::array<double, 2> periods_ = {0.0, 0.0};  ///< 0: none
    double area_ = 0.0;
    bool closed_ = true;
};

}  // namespace suture

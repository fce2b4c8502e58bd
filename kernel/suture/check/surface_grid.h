#pragma once

#include <GeomAdaptor_Surface.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

#include <vector>

namespace suture {

/// Points of a bounded surface on a grid, from which to look for its nearest point to another one:
/// OCCT's own search (GeomAPI_ProjectPointOnSurf) takes ten milliseconds for each.
class SurfaceGrid {
  public:
    explicit SurfaceGrid(const GeomAdaptor_Surface& surface);

    /// A point of the grid that is nearer than all around it.
    struct Minimum {
        gp_Pnt2d uv;
        double distance = 0.0;
        double at_least = 0.0;  ///< the surface is hardly nearer between it and those around it
    };
    /// The nearest few of these points, the nearest first.
    [[nodiscard]] std::vector<Minimum> minima(const gp_Pnt& from) const;

    /// From there on downhill, by halving steps to a thousandth of the grid's width.
    ///
    /// Input  the surface of which the grid was made.
    [[nodiscard]] gp_Pnt2d downhill(const GeomAdaptor_Surface& surface, const gp_Pnt& from,
                                    const gp_Pnt2d& start) const;

  private:
    std::vector<double> u_, v_;
    std::vector<gp_Pnt> points_;  ///< with u fastest
};

}  // namespace suture

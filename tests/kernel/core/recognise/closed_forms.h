#pragma once

#include "support/windows.h"
#include "suture/model/ribbon.h"
#include "suture/model/surface.h"

#include <cmath>
#include <variant>
#include <vector>

/// One window in each closed form.
namespace suture::closed_forms {

using windows::Window;

struct Truth {
    Surface surface;
    Window window;
};

inline std::vector<Truth> truths(double scale, bool reversed) {
    const Frame frame = windows::tilted(scale);
    const auto window = [&](double u, double v, double ru, double rv, bool length_v, int sides) {
        Window w;
        w.centre = {u, length_v ? scale * v : v};
        w.radius = {ru, length_v ? scale * rv : rv};
        w.sides = sides;
        w.reversed = reversed;
        return w;
    };
    Window flat = window(0.2, 0.1, 0.6, 0.35, true, 4);
    flat.centre.x() *= scale;
    flat.radius.x() *= scale;
    return {{Plane{frame}, flat},
            {Sphere{frame, 3.0 * scale}, window(0.3, 0.4, 0.5, 0.4, false, 3)},
            {Cylinder{frame, 2.0 * scale}, window(1.0, 0.1, 0.6, 0.35, true, 5)},
            {Cone{frame, 1.5 * scale, 0.4}, window(2.0, 0.1, 0.7, 0.35, true, 4)},
            {Torus{frame, 5.0 * scale, 1.25 * scale}, window(1.0, 0.2, 0.3, 0.9, false, 6)}};
}

/// Without what would give the surface away.
inline Hole without_supports(Hole hole) {
    for (RibbonLoop& loop : hole.loops) {
        for (Ribbon& ribbon : loop.ribbons) {
            ribbon.support.reset();
        }
    }
    return hole;
}

inline std::vector<double> sizes(const Surface& surface) {
    if (const auto* s = std::get_if<Sphere>(&surface)) {
        return {s->radius};
    }
    if (const auto* s = std::get_if<Cylinder>(&surface)) {
        return {s->radius};
    }
    if (const auto* s = std::get_if<Cone>(&surface)) {
        return {std::abs(s->half_angle)};
    }
    if (const auto* s = std::get_if<Torus>(&surface)) {
        return {s->major, s->minor};
    }
    return {};
}

}  // namespace suture::closed_forms

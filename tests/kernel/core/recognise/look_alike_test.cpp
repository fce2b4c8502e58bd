#include "support/ribbon_zoo.h"
#include "suture/fill/recognise.h"

#include <gtest/gtest.h>

#include <cmath>

// Holes that only look like something: pieces of surfaces that are none of the kinds, so small or
// so nearly one of them that it fits them to 1e-4 to 1e-7 of their diameter.
namespace suture {
namespace {

using zoo::circle;
using zoo::Jet;
using zoo::Point;
using zoo::polygon;
using zoo::star;

struct LookAlike {
    std::string name;
    Hole hole;
};

Jet operator*(double a, const Jet& b) {
    return Jet(a) * b;
}

/// A cylinder of elliptic section.
zoo::Surface elliptic(double ratio) {
    return [ratio](const Jet& u, const Jet& v) { return Point{cos(u), ratio * sin(u), v}; };
}

/// A ball that is a little too long.
zoo::Surface ellipsoid(double ratio) {
    return [ratio](const Jet& u, const Jet& v) {
        return Point{cos(u) * cos(v), sin(u) * cos(v), ratio * sin(v)};
    };
}

/// A ring around the z axis whose section is an ellipse.
zoo::Surface ring(double ratio) {
    return [ratio](const Jet& u, const Jet& v) {
        const Jet rho = Jet(3.0) + cos(v);
        return Point{rho * cos(u), rho * sin(u), ratio * sin(v)};
    };
}

/// What a ball envelops whose radius grows along its way.
zoo::Surface growing(double slope) {
    return [slope](const Jet& u, const Jet& v) {
        const Jet r = Jet(1.0) + slope * v * v;
        return Point{r * cos(u), r * sin(u), v};
    };
}

zoo::Surface paraboloid() {
    return zoo::graph([](const Jet& u, const Jet& v) { return Jet(-0.5) * (u * u + 0.6 * v * v); });
}

zoo::Surface parabolic_cylinder() {
    return [](const Jet& u, const Jet& v) { return Point{u, v, -0.5 * u * u}; };
}

zoo::Surface catenoid() {
    return [](const Jet& u, const Jet& v) {
        const double e = std::exp(v.value);
        const Jet cosh = zoo::chain(v, 0.5 * (e + 1 / e), 0.5 * (e - 1 / e), 0.5 * (e + 1 / e));
        return Point{cosh * cos(u), cosh * sin(u), v};
    };
}

zoo::Surface helicoid() {
    return [](const Jet& u, const Jet& v) { return Point{v * cos(u), v * sin(u), 0.4 * u}; };
}

/// A strip between two generators of a cylinder, as far on one side of u as on the other.
std::vector<zoo::Curve> strip(double u, double half, double v) {
    return polygon({{u - half, -v}, {u + half, -v}, {u + half, v}, {u - half, v}});
}

std::vector<LookAlike> look_alikes() {
    std::vector<LookAlike> all;
    const auto add = [&](const std::string& name, const zoo::Surface& surface,
                         const std::vector<zoo::Curve>& curves) {
        all.push_back({name, zoo::window(surface, curves)});
    };
    for (const double size : {0.3, 0.1, 0.05, 0.02}) {
        add(fmt::format("elliptic cylinder, {}", size), elliptic(0.93),
            circle({0.5, 0.2}, size, 4));
        add(fmt::format("paraboloid, {}", size), paraboloid(), circle({0.1, 0.2}, size, 4));
        add(fmt::format("catenoid, {}", size), catenoid(), star({0.3, 0.4}, size, 0.2, 3, 3));
        add(fmt::format("helicoid, {}", size), helicoid(), circle({0.3, 0.8}, size, 5));
        add(fmt::format("growing ball, {}", size), growing(0.1), circle({0.3, 0.3}, size, 4));
    }
    for (const double ratio : {0.99, 0.999, 0.9999}) {
        add(fmt::format("elliptic cylinder of ratio {}", ratio), elliptic(ratio),
            circle({0.5, 0.2}, 0.5, 4));
        add(fmt::format("ellipsoid of ratio {}", ratio), ellipsoid(ratio),
            circle({0.5, 0.3}, 0.5, 3));
        add(fmt::format("ring of ratio {}", ratio), ring(ratio), circle({0.5, 0.7}, 0.4, 4));
    }
    // Two sides lie exactly on a circular cylinder, and are tangent to it.
    for (const double half : {0.2, 0.1, 0.05}) {
        add(fmt::format("strip of an elliptic cylinder, {}", half), elliptic(0.8),
            strip(0.0, half, 0.5));
        add(fmt::format("strip of a parabolic cylinder, {}", half), parabolic_cylinder(),
            strip(0.0, half, 0.5));
    }
    for (const double height : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        add(fmt::format("waves of height {}", height), zoo::wavy(height, 2.0),
            circle({0.4, 0.1}, 0.5, 4));
        add(fmt::format("saddle of height {}", height), zoo::saddle(height),
            circle({0.1, 0.1}, 0.5, 3));
    }
    return all;
}

TEST(LookAlikes, AreNotRecognised) {
    const std::vector<LookAlike> all = look_alikes();
    EXPECT_GE(all.size(), 40U);
    for (const LookAlike& one : all) {
        const auto fill = fill_recognise(one.hole, {});
        EXPECT_FALSE(fill) << one.name << ": " << fill->notes.front();
        if (!fill) {
            EXPECT_NE(fill.error().message.find("no surface is recognised"), std::string::npos);
        }
    }
}

// A model that is inexact itself does not tell them from the kinds, and is taken at its word.
TEST(LookAlikes, AreRecognisedWithinTheNoiseOfTheModel) {
    const Hole hole = zoo::window(elliptic(0.9999), circle({0.5, 0.2}, 0.5, 4));
    FillOptions options;
    options.noise = 1e-4 * hole.diameter;
    Recognised found;
    options.recognised = [&](const Recognised& what) { found = what; };
    const auto fill = fill_recognise(hole, options);
    ASSERT_TRUE(fill) << fill.error().message;
    EXPECT_EQ(found.kind, "cylinder");
    EXPECT_NEAR(found.parameters.front().second, 1.0, 1e-3);
}

}  // namespace
}  // namespace suture

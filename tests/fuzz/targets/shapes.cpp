// Steps of the flow on made shapes: patches of a few poles in a coarse grid, so that they touch,
// fold, degenerate and lie on each other, sewn where they meet; and the judge on any figures.
#include "suture/check/clashes.h"
#include "suture/check/continuity.h"
#include "suture/check/folds.h"
#include "suture/check/profile.h"
#include "suture/detect/find_loops.h"
#include "suture/judge/judge_fill.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"
#include "suture/sew/sew_shape.h"

#include "fuzz/targets/target.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>

#include <array>
#include <cmath>
#include <limits>

namespace suture::fuzz {

namespace {

/// Patches of degree 1 to 3 whose poles lie in a grid of 5 x 5 x 5 points, or near it.
TopoDS_Shape shape_of(Bytes& bytes) {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    const int faces = bytes.from(1, 5);
    for (int face = 0; face < faces; ++face) {
        const int p = bytes.from(1, 3);
        const int q = bytes.from(1, 3);
        const bool rough = bytes.from(0, 3) == 0;
        TColgp_Array2OfPnt poles(1, p + 1, 1, q + 1);
        for (int i = 1; i <= p + 1; ++i) {
            for (int j = 1; j <= q + 1; ++j) {
                const auto coordinate = [&](int from_grid) {
                    return from_grid + bytes.from(-1, 1) + (rough ? 1e-3 * bytes.unit() : 0.0);
                };
                const double x = coordinate(i);
                const double y = coordinate(j);
                poles.SetValue(i, j, {x, y, coordinate(0)});
            }
        }
        // Where OCCT makes no face of it no file holds it.
        const auto made = occ::guarded("making a face", [&] {
            return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), Precision::Confusion())
                .Face();
        });
        if (made) {
            builder.Add(all, *made);
        }
    }
    const auto sewn = sew_shape(all, 0.0);
    return sewn ? sewn->shape : TopoDS_Shape(all);
}

void loops(std::string_view data) {
    Bytes bytes(data);
    const TopoDS_Shape shape = shape_of(bytes);
    const occ::Numbering numbering(shape);
    const auto found = find_loops(shape, numbering);
    if (!found && found.error().message.empty()) {
        broken("an error says something");
    }
}

void faces(std::string_view data) {
    Bytes bytes(data);
    const TopoDS_Shape shape = shape_of(bytes);
    const occ::Numbering numbering(shape);
    std::vector<int> numbers;
    for (int face = 1; face <= numbering.faces.Extent(); ++face) {
        numbers.push_back(face);
    }
    if (numbers.empty()) {
        return;
    }
    const auto report = measure_continuity(shape, Profile{}, {}, Progress{});
    for (const EdgeContinuity& edge : report ? report->edges : std::vector<EdgeContinuity>{}) {
        if (edge.samples > 0 &&
            !(edge.max_gap >= 0.0 && edge.max_angle >= 0.0 && edge.max_angle <= 3.1415927)) {
            broken("a gap is a length and an angle lies in [0, 180] degrees");
        }
    }
    const auto folds = find_folds(shape, numbers, Progress{});
    if (folds && folds->size() != numbers.size()) {
        broken("one verdict a face");
    }
    (void)find_clashes(shape, numbers, 1e-3, 1e-2, Progress{});
}

/// Any number that a double can be.
double figure(Bytes& bytes) {
    constexpr std::array kWild = {0.0,
                                  -1.0,
                                  1e-300,
                                  1e300,
                                  std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};
    const int kind = bytes.from(0, 15);
    return kind < 6 ? kWild.at(static_cast<std::size_t>(kind)) : std::pow(10.0, 6.0 * bytes.unit());
}

void judge(std::string_view data) {
    Bytes bytes(data);
    AskedFill asked;
    asked.diameter = 1.0 + bytes.byte();
    FillMeasures measures;
    bool unknown = false;
    const int sides = bytes.from(1, 4);
    for (int i = 0; i < sides; ++i) {
        AskedSide side;
        side.edge = i + 1;
        side.continuity = bytes.from(0, 1) == 0 ? Continuity::G0 : Continuity::G1;
        asked.sides.push_back(side);
        EdgeContinuity edge;
        edge.edge = i + 1;
        edge.faces = {1, 2};
        edge.samples = bytes.from(0, 9);
        edge.max_gap = figure(bytes);
        edge.max_angle = figure(bytes);
        unknown = unknown || edge.samples == 0 || std::isnan(edge.max_gap) ||
                  (side.continuity == Continuity::G1 && std::isnan(edge.max_angle));
        measures.sides.push_back(edge);
    }
    measures.area = {figure(bytes), figure(bytes), 1};
    measures.through = figure(bytes);
    const Judgement verdict = judge_fill(asked, measures);
    for (const Finding& finding : verdict.findings) {
        if (to_text(finding).empty()) {
            broken("a finding says something");
        }
    }
    if (unknown && verdict.within()) {
        broken("what is not known is not good");
    }
}

}  // namespace

std::vector<Target> shape_targets() {
    // All grid points themselves; a fold; two that meet.
    const std::string flat(120, '\1');
    std::string other = flat;
    for (std::size_t i = 0; i < other.size(); ++i) {
        other[i] = static_cast<char>(7 * i + i * i / 5);
    }
    return {{"loops", loops, {flat, other}},
            {"faces", faces, {flat, other}},
            {"judge", judge, {flat, other}}};
}

}  // namespace suture::fuzz

/// Processor time of recognising lost faces: every face of a rounded box in a model of 520 faces, a
/// fillet of growing radius in one of 504 that holds 125 twins of it, and the holes of STEP files.
///     suture_recognise_speed [OPEN.step...]
#include "suture/candidates/model_candidates.h"
#include "suture/detect/find_loops.h"
#include "suture/fill/recognise.h"
#include "suture/ribbon/extract.h"
#include "suture/ribbon/noise.h"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace suture;

/// The promise, in milliseconds: in the median of all holes, and for one with all its twins.
constexpr double kMedian = 20.0;
constexpr double kMost = 300.0;

TopoDS_Shape rounded_box() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30.0, 25.0, 20.0).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (const TopoDS_Edge& edge : occ::edges_of(box)) {
        fillet.Add(3.0, edge);
    }
    return fillet.Shape();
}

/// A box with two edges rounded by a radius that grows along them.
TopoDS_Shape growing_fillets() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30.0, 25.0, 20.0).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (const TopoDS_Edge& edge : occ::edges_of(box)) {
        const BRepAdaptor_Curve curve(edge);
        const gp_Pnt p = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
        if (std::abs(p.Z() - 20.0) < 1e-6 && std::abs(p.Y() - 12.5) < 1e-6) {
            fillet.Add(2.0, 4.0, edge);
        }
    }
    return fillet.Shape();
}

/// So many copies of a body, turned about here and there; the first one lacks a face.
TopoDS_Compound copies(const TopoDS_Shape& body, int count, int lost) {
    const BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    TopoDS_Compound open;
    builder.MakeCompound(open);
    const auto faces = occ::faces_of(body);
    for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
        if (i != lost) {
            builder.Add(open, faces[static_cast<std::size_t>(i)]);
        }
    }
    builder.Add(all, open);
    for (int i = 1; i < count; ++i) {
        gp_Trsf turn;
        turn.SetRotation(gp_Ax1(gp_Pnt(15, 12, 10), gp_Dir(1, 0.2 * i, -0.5)), 0.37 * i);
        gp_Trsf move;
        move.SetTranslation(gp_Vec(60.0 * (i % 8), 60.0 * (i / 8), 0.0));
        builder.Add(all, BRepBuilderAPI_Transform(body, move * turn, /*Copy=*/true).Shape());
    }
    return all;
}

double now() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Milliseconds of each hole of a model.
std::vector<double> time_holes(const std::string& name, const TopoDS_Shape& shape) {
    std::vector<double> times;
    const occ::Numbering numbering(shape);
    const auto loops = find_loops(shape, numbering);
    if (!loops) {
        return times;
    }
    for (const BoundaryLoop& loop : *loops) {
        const std::vector<BoundaryLoop> one = {loop};
        const auto hole = extract_hole(one);
        if (loop.kind != LoopKind::Hole || !hole) {
            continue;
        }
        double searching = 0.0;
        const double start = now();
        FillOptions options;
        options.noise = measure_noise(one, *hole);
        options.candidates = [&] {
            const double from = now();
            auto found = find_candidates(shape, numbering, one, *hole, Scope::Model);
            searching = now() - from;
            return found.value_or(std::vector<Candidate>());
        };
        std::string what = "nothing";
        options.recognised = [&](const Recognised& found) {
            what = found.kind + ", " + found.from;
        };
        const auto fill = fill_recognise(*hole, options);
        times.push_back(now() - start);
        fmt::print("{:32} {:4} faces, {:2} sides: {:6.1f} ms, {:6.1f} of them in the model: {}\n",
                   name, occ::faces_of(shape).size(), hole->loops.front().ribbons.size(),
                   times.back(), searching, what);
    }
    return times;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    std::vector<double> all;
    const auto add = [&](const std::vector<double>& times) {
        all.insert(all.end(), times.begin(), times.end());
    };
    const TopoDS_Shape box = rounded_box();
    for (int face = 0; face < static_cast<int>(occ::faces_of(box).size()); ++face) {
        add(time_holes(fmt::format("rounded box, face {}", face + 1), copies(box, 20, face)));
    }
    const TopoDS_Shape growing = growing_fillets();
    const auto faces = occ::faces_of(growing);
    const auto freeform = std::find_if(faces.begin(), faces.end(), [](const TopoDS_Face& face) {
        return BRepAdaptor_Surface(face).GetType() == GeomAbs_BSplineSurface;
    });
    const auto twins = time_holes("growing fillet",
                                  copies(growing, 63, static_cast<int>(freeform - faces.begin())));
    add(twins);
    for (int i = 1; i < argc; ++i) {
        STEPControl_Reader reader;
        if (reader.ReadFile(argv[i]) != IFSelect_RetDone || reader.TransferRoots() == 0) {
            fmt::print(stderr, "{} cannot be read\n", argv[i]);
            return 2;
        }
        const std::string path = argv[i];
        add(time_holes(path.substr(path.rfind('/') + 1), reader.OneShape()));
    }
    const double most = all.empty() ? 0.0 : *std::max_element(all.begin(), all.end());
    fmt::print(
        "{} holes: {:.1f} ms in the median (at most {:.0f}), {:.1f} at most; with all twins "
        "{:.1f} (at most {:.0f})\n",
        all.size(), median(all), kMedian, most, median(twins), kMost);
    return median(all) <= kMedian && median(twins) <= kMost ? 0 : 1;
}

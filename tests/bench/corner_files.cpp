/// The corners of suture_corners as models: open shells of fillets and the planes between them, in
/// STEP files. By corner_files.py.
///     corner_files FOLDER
#include "bench/corner_list.h"
#include <fmt/format.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace {

using suture::bench::kSetBack;
using Strip = suture::zoo::FilletCorner::Strip;

constexpr double kFar = 8.0;  // where the model ends, from the corner
constexpr double kCurveTolerance = 1e-9;
constexpr double kSewingTolerance = 1e-6;

gp_Pnt point(const Eigen::Vector3d& p) {
    return {p.x(), p.y(), p.z()};
}
gp_Dir direction(const Eigen::Vector3d& d) {
    return {d.x(), d.y(), d.z()};
}

/// The fillet from its near border, straight in its parameters, to its far end.
TopoDS_Face fillet_face(const Strip& strip, double from, double to) {
    gp_Ax3 axes(point(strip.axis), direction(strip.frame.col(2)), direction(strip.frame.col(0)));
    if (strip.frame.determinant() < 0.0) {
        axes.YReverse();
    }
    const Handle(Geom_Surface) surface = new Geom_CylindricalSurface(axes, strip.radius);
    const double far = kFar * strip.outwards;
    const std::array<gp_Pnt2d, 4> corners{gp_Pnt2d(0.0, from), gp_Pnt2d(strip.angle, to),
                                          gp_Pnt2d(strip.angle, far), gp_Pnt2d(0.0, far)};
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(
            GCE2d_MakeSegment(corners[k], corners[(k + 1) % corners.size()]).Value(), surface);
        BRepLib::BuildCurve3d(edge, kCurveTolerance);
        wire.Add(edge);
    }
    return BRepBuilderAPI_MakeFace(surface, wire.Wire());
}

/// The plane between two fillets, from its near corners to its far ones.
TopoDS_Face plane_face(const Strip& strip, const Strip& next, bool tight) {
    BRepBuilderAPI_MakePolygon polygon;
    if (tight) {
        polygon.Add(point(strip.meeting));
    } else {
        polygon.Add(point(next.first + kSetBack * next.direction));
        polygon.Add(point(strip.last + kSetBack * strip.direction));
    }
    polygon.Add(point(strip.last + kFar * strip.direction));
    polygon.Add(point(next.first + kFar * next.direction));
    polygon.Close();
    return BRepBuilderAPI_MakeFace(polygon.Wire(), Standard_True);
}

TopoDS_Shape model_of(const suture::bench::Corner& corner) {
    const bool tight = corner.tight;
    const std::vector<Strip> strips = corner.fillets().strips();
    BRepBuilderAPI_Sewing sewing(kSewingTolerance);
    for (std::size_t i = 0; i < strips.size(); ++i) {
        const Strip& strip = strips[i];
        const double back = kSetBack * strip.outwards;
        sewing.Add(fillet_face(strip, tight ? strip.from : back, tight ? strip.to : back));
        sewing.Add(plane_face(strip, strips[(i + 1) % strips.size()], tight));
    }
    sewing.Perform();
    return sewing.SewedShape();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: suture_corner_files FOLDER\n");
        return 1;
    }
    Message::DefaultMessenger()->ChangePrinters().Clear();
    for (const suture::bench::Corner& corner : suture::bench::corners()) {
        std::string name = corner.name();
        std::erase(name, ',');
        std::ranges::replace(name, ' ', '_');
        const std::string file = fmt::format("{}/{}.step", argv[1], name);
        STEPControl_Writer writer;
        if (writer.Transfer(model_of(corner), STEPControl_AsIs) != IFSelect_RetDone ||
            writer.Write(file.c_str()) != IFSelect_RetDone) {
            fmt::print(stderr, "{} cannot be written\n", file);
            return 2;
        }
    }
}

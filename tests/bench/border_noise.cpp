#include "bench/border_noise.h"

#include "bench/face_distance.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

namespace suture::bench {
namespace {

constexpr int kSamples = 48;

/// An edge of the open model belongs to the hole if its middle is this near to the lost face, as a
/// share of that one's size.
constexpr double kNear = 1e-3;

gp_Pnt middle(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    return curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
}

double size_of(const TopoDS_Face& face) {
    Bnd_Box box;
    BRepBndLib::Add(face, box);
    return std::sqrt(box.SquareExtent());
}

}  // namespace

double noise_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0.0;
    double last = 0.0;
    const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    const BRepAdaptor_Curve curve(edge);
    double noise = 0.0;
    for (int k = 0; k <= kSamples; ++k) {
        const double t = first + (last - first) * k / kSamples;
        const gp_Pnt p = curve.Value(t);
        double nearest = INFINITY;
        if (!pcurve.IsNull()) {
            const gp_Pnt2d uv = pcurve->Value(t);
            nearest = surface->Value(uv.X(), uv.Y()).Distance(p);
        }
        const GeomAPI_ProjectPointOnSurf foot(p, surface);
        if (foot.NbPoints() > 0) {
            nearest = std::min(nearest, foot.LowerDistance());
        }
        noise = std::max(noise, nearest);
    }
    return noise;
}

double border_noise(const TopoDS_Shape& open, const TopoDS_Face& lost) {
    double noise = 0.0;
    for (TopExp_Explorer at(lost, TopAbs_EDGE); at.More(); at.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(at.Current());
        if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, lost)) {
            noise = std::max(noise, noise_of(edge, lost));
        }
    }
    TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
    TopExp::MapShapesAndAncestors(open, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
    FaceDistance distance(lost);
    const double near = kNear * size_of(lost);
    for (int i = 1; i <= faces_of_edge.Extent(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(faces_of_edge.FindKey(i));
        if (faces_of_edge(i).Extent() == 1 && !BRep_Tool::Degenerated(edge) &&
            distance(middle(edge)) < near) {
            noise = std::max(noise, noise_of(edge, TopoDS::Face(faces_of_edge(i).First())));
        }
    }
    return noise;
}

}  // namespace suture::bench

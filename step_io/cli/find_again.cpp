#include "cli/find_again.h"

#include "suture/occ/convert.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <numeric>

namespace suture::cli {
namespace {

/// A shape is found again if its place and size agree this well, relative to its own size. Files
/// have 15 digits; the rest is what the reader mends.
constexpr double kSame = 1e-3;

void add_vertices(const TopoDS_Shape& shape, Signature& signature) {
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
    for (int i = 1; i <= vertices.Extent(); ++i) {
        const auto point = occ::from_occ(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))));
        signature.low = signature.low.cwiseMin(point);
        signature.high = signature.high.cwiseMax(point);
    }
}

void add_properties(const TopoDS_Shape& shape, Signature& signature) {
    GProp_GProps properties;
    if (shape.ShapeType() == TopAbs_FACE) {
        BRepGProp::SurfaceProperties(shape, properties);
        signature.extent = std::sqrt(std::abs(properties.Mass()));
    } else {
        BRepGProp::LinearProperties(shape, properties);
        signature.extent = properties.Mass();
    }
    signature.centroid = occ::from_occ(properties.CentreOfMass());
}

double difference(const Signature& a, const Signature& b) {
    return (a.centroid - b.centroid).norm() + std::abs(a.extent - b.extent);
}

bool same_vertices(const Signature& a, const Signature& b) {
    return (a.low - b.low).norm() + (a.high - b.high).norm() <= kSame * a.extent;
}

}  // namespace

Signature signature_of(const TopoDS_Shape& shape) {
    Signature signature;
    add_vertices(shape, signature);
    add_properties(shape, signature);
    return signature;
}

ShapeFinder::ShapeFinder(const TopTools_IndexedMapOfShape& shapes) : shapes_(shapes) {
    for (int i = 1; i <= shapes.Extent(); ++i) {
        add_vertices(shapes(i), signatures_.emplace_back());
    }
}

int ShapeFinder::find(const Signature& wanted) {
    std::vector<int> all(signatures_.size());
    std::iota(all.begin(), all.end(), 1);
    return find(wanted, all);
}

int ShapeFinder::find(const Signature& wanted, std::span<const int> among) {
    const int near = nearest(wanted, among, /*same_vertices_only=*/true);
    // Of a closed face or edge the reader may have moved the vertices.
    return near > 0 ? near : nearest(wanted, among, /*same_vertices_only=*/false);
}

int ShapeFinder::nearest(const Signature& wanted, std::span<const int> among,
                         bool same_vertices_only) {
    int best = 0;
    double smallest = kSame * wanted.extent;
    for (const int i : among) {
        Signature& signature = signatures_[static_cast<std::size_t>(i - 1)];
        if (same_vertices_only && !same_vertices(wanted, signature)) {
            continue;
        }
        if (signature.extent == 0.0) {
            add_properties(shapes_(i), signature);
        }
        const double distance = difference(wanted, signature);
        if (distance <= smallest) {
            smallest = distance;
            best = i;
        }
    }
    return best;
}

}  // namespace suture::cli

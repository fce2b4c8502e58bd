// Judges a filled model from outside: finds the new faces in the written file and measures how far
// they are from the face that was taken out, and how exact the file is around it. OCCT alone;
// shares no code with what it judges.
//     suture_referee OPEN.step OUT.step [TRUTH.brep]    prints one JSON object

#include "bench/border_noise.h"
#include "bench/face_distance.h"
#include "bench/fairness.h"
#include <nlohmann/json.hpp>

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <stdexcept>

namespace {

using suture::bench::FaceDistance;
using suture::bench::points_of;
using Json = nlohmann::json;

/// How much area (relative) and centroid (of the face's size) of an untouched face may differ after
/// it was written and read once more: 15 digits, and areas integrated anew.
constexpr double kSame = 1e-6;

/// And a face is still the same one, though OCCT's reader, which mends what lies within the
/// accuracy that a file states, has moved its border: measured up to 2e-5.
constexpr double kAlike = 1e-3;

TopoDS_Shape read_step(const char* file) {
    STEPControl_Reader reader;
    if (reader.ReadFile(file) != IFSelect_RetDone || reader.TransferRoots() == 0) {
        throw std::runtime_error(std::string(file) + " cannot be read");
    }
    return reader.OneShape();
}

TopoDS_Shape read_brep(const char* file) {
    TopoDS_Shape shape;
    if (!BRepTools::Read(shape, file, BRep_Builder())) {
        throw std::runtime_error(std::string(file) + " cannot be read");
    }
    return shape;
}

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, TopAbs_FACE, map);
    std::vector<TopoDS_Face> faces;
    for (int i = 1; i <= map.Extent(); ++i) {
        faces.push_back(TopoDS::Face(map(i)));
    }
    return faces;
}

/// What a face is known by.
struct Mark {
    GeomAbs_SurfaceType type = GeomAbs_OtherSurface;
    double area = 0.0;
    gp_Pnt centroid;
};

Mark mark_of(const TopoDS_Face& face) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    return {BRepAdaptor_Surface(face, false).GetType(), std::abs(properties.Mass()),
            properties.CentreOfMass()};
}

bool same(const Mark& a, const Mark& b, double tolerance) {
    const double size = std::sqrt(std::max(a.area, b.area));
    return a.type == b.type && std::abs(a.area - b.area) <= tolerance * size * size &&
           a.centroid.Distance(b.centroid) <= tolerance * size;
}

/// A face with what it is known by.
struct Known {
    TopoDS_Face face;
    Mark mark;
};

std::vector<Known> known(const TopoDS_Shape& shape) {
    std::vector<Known> result;
    for (const TopoDS_Face& face : faces_of(shape)) {
        result.push_back({face, mark_of(face)});
    }
    return result;
}

/// Takes out of both lists the faces that have a counterpart in the other; returns how many.
std::size_t cancel(std::vector<Known>& before, std::vector<Known>& after, double tolerance) {
    const std::size_t count = after.size();
    std::erase_if(after, [&](const Known& face) {
        const auto found = std::find_if(before.begin(), before.end(), [&](const Known& other) {
            return same(face.mark, other.mark, tolerance);
        });
        const bool paired = found != before.end();
        if (paired) {
            before.erase(found);
        }
        return paired;
    });
    return count - after.size();
}

/// The faces of `filled` without a counterpart in `open`, how many have one that is but alike, and
/// how many of `open` have none.
struct Comparison {
    std::vector<TopoDS_Face> added;
    std::size_t changed = 0;
    std::size_t lost = 0;
};

Comparison compare(const TopoDS_Shape& open, const TopoDS_Shape& filled) {
    std::vector<Known> before = known(open);
    std::vector<Known> after = known(filled);
    cancel(before, after, kSame);
    Comparison result;
    result.changed = cancel(before, after, kAlike);
    result.lost = before.size();
    for (const Known& face : after) {
        result.added.push_back(face.face);
    }
    return result;
}

std::size_t free_edges_of(const TopoDS_Shape& shape) {
    TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
    std::size_t count = 0;
    for (int i = 1; i <= faces_of_edge.Extent(); ++i) {
        // A seam is listed twice with the same face.
        count += faces_of_edge(i).Extent() == 1 &&
                         !BRep_Tool::Degenerated(TopoDS::Edge(faces_of_edge.FindKey(i)))
                     ? 1
                     : 0;
    }
    return count;
}

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
    int count = 0;
    for (TopExp_Explorer at(shape, type); at.More(); at.Next()) {
        ++count;
    }
    return count;
}

/// Largest distance of the points from the nearest of the faces; none without points.
std::optional<double> largest_distance(const std::vector<gp_Pnt>& points,
                                       std::vector<FaceDistance>& faces) {
    std::optional<double> largest;
    for (const gp_Pnt& point : points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (FaceDistance& face : faces) {
            nearest = std::min(nearest, face(point));
        }
        largest = std::max(largest.value_or(0.0), nearest);
    }
    return largest;
}

std::optional<double> one_way(const std::vector<TopoDS_Face>& from,
                              const std::vector<TopoDS_Face>& to) {
    std::vector<gp_Pnt> points;
    for (const TopoDS_Face& face : from) {
        const std::vector<gp_Pnt> more = points_of(face);
        points.insert(points.end(), more.begin(), more.end());
    }
    std::vector<FaceDistance> faces;
    for (const TopoDS_Face& face : to) {
        faces.emplace_back(face);
    }
    return to.empty() ? std::nullopt : largest_distance(points, faces);
}

Json json_of(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json();
}

/// Of all faces together.
Json fairness_json(const std::vector<TopoDS_Face>& faces) {
    double variation = 0.0;
    double bending = 0.0;
    int sign_changes = 0;
    for (const TopoDS_Face& face : faces) {
        const suture::bench::Fairness fairness = suture::bench::fairness_of(face);
        variation += fairness.variation;
        bending += fairness.bending;
        sign_changes += fairness.sign_changes;
    }
    return {{"variation", variation}, {"bending", bending}, {"sign_changes", sign_changes}};
}

Json judge(const char* open_file, const char* out_file, const char* truth_file) {
    const TopoDS_Shape out = read_step(out_file);
    const TopoDS_Shape open = read_step(open_file);
    const Comparison comparison = compare(open, out);
    Json result{{"new_faces", comparison.added.size()},
                {"changed_faces", comparison.changed},
                {"lost_faces", comparison.lost},
                {"solids", count_of(out, TopAbs_SOLID)},
                {"free_edges", free_edges_of(out)},
                {"valid", static_cast<bool>(BRepCheck_Analyzer(out).IsValid())},
                {"fairness", fairness_json(comparison.added)}};
    if (truth_file != nullptr) {
        const std::vector<TopoDS_Face> truth = faces_of(read_brep(truth_file));
        result["truth_fairness"] = fairness_json(truth);
        result["truth_to_new"] = json_of(one_way(truth, comparison.added));
        double noise = 0.0;
        for (const TopoDS_Face& face : truth) {
            noise = std::max(noise, suture::bench::border_noise(open, face));
        }
        result["border_noise"] = noise;
        result["new_to_truth"] = json_of(one_way(comparison.added, truth));
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3 && argc != 4) {
        std::cerr << "usage: suture_referee OPEN.step OUT.step [TRUTH.brep]\n";
        return 1;
    }
    Message::DefaultMessenger()->ChangePrinters().Clear();
    try {
        std::cout << judge(argv[1], argv[2], argc == 4 ? argv[3] : nullptr).dump() << '\n';
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
    return 0;
}

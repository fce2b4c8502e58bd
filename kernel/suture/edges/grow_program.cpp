// OCCT's removal of features and its merging of faces, the only code that calls them: a program,
// because they can crash or hang.
#include "suture/edges/close_window.h"
#include "suture/edges/grow_request.h"
#include "suture/occ/isolate.h"
#include "suture/occ/topology.h"

#include <BRepAlgoAPI_Defeaturing.hxx>
#include <BRepTools_ReShape.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace suture {
namespace {

Result<std::string> grow(const GrowMessage& request) {
    const occ::Numbering before(request.shape);
    BRepAlgoAPI_Defeaturing removal;
    removal.SetShape(request.shape);
    for (const auto& [face, none] : request.faces) {
        removal.AddFaceToRemove(before.faces(face));
    }
    removal.SetToFillHistory(Standard_True);
    removal.Build();
    if (removal.HasErrors() || !removal.IsDone() || removal.Shape().IsNull()) {
        return fail(ErrorCode::Refused, "OCCT finds no way to let the neighbours meet");
    }
    GrowMessage answer;
    answer.shape = removal.Shape();
    const occ::Numbering after(answer.shape);
    for (const auto& [face, none] : request.faces) {
        if (!removal.IsDeleted(before.faces(face)) || after.faces.Contains(before.faces(face))) {
            return fail(ErrorCode::Refused, "OCCT leaves one of the faces where it is");
        }
    }
    for (int face = 1; face <= before.faces.Extent(); ++face) {
        const TopTools_ListOfShape& images = removal.Modified(before.faces(face));
        const TopoDS_Shape& image = images.IsEmpty() ? before.faces(face) : images.First();
        if (const int number = after.faces.FindIndex(image); number > 0) {
            answer.faces.emplace_back(face, number);
        }
    }
    return packed(answer);
}

/// Makes new faces one with neighbours on the same surface.
class Merger {
  public:
    explicit Merger(const GrowMessage& request) : before_(request.shape), shape_(request.shape) {
        for (int face = 1; face <= before_.faces.Extent(); ++face) {
            images_[face] = before_.faces(face);
        }
        for (const auto& [face, none] : request.faces) {
            new_faces_.push_back(face);
        }
    }

    /// OCCT leaves windows of surfaces that close in themselves as they are.
    void close_windows() {
        TopTools_IndexedDataMapOfShapeListOfShape users;
        TopExp::MapShapesAndAncestors(shape_, TopAbs_EDGE, TopAbs_FACE, users);
        BRepTools_ReShape changes;
        std::map<int, TopoDS_Face> closed;  // by the number of the face around
        for (const int inside : new_faces_) {
            const int around = only_neighbour(inside, users);
            if (around == 0 || std::ranges::count(new_faces_, around) > 0) {
                continue;
            }
            const auto known = closed.find(around);
            const TopoDS_Face now =
                known == closed.end() ? TopoDS::Face(before_.faces(around)) : known->second;
            if (auto whole = close_window(now, TopoDS::Face(before_.faces(inside)))) {
                closed[around] = *whole;
                into_[inside] = around;
                changes.Remove(before_.faces(inside));
            }
        }
        for (const auto& [around, whole] : closed) {
            changes.Replace(before_.faces(around), whole);
            images_[around] = whole;
        }
        if (!closed.empty()) {
            shape_ = changes.Apply(shape_);
        }
    }

    /// What is left to OCCT.
    Result<void> unify() {
        if (into_.size() == new_faces_.size()) {
            return {};
        }
        ShapeUpgrade_UnifySameDomain unifier(shape_, /*UnifyEdges=*/Standard_True,
                                             /*UnifyFaces=*/Standard_True,
                                             /*ConcatBSplines=*/Standard_False);
        unifier.KeepShapes(all_but_new());
        unifier.Build();
        if (unifier.Shape().IsNull()) {
            return fail(ErrorCode::Refused, "OCCT's merging of faces gave nothing");
        }
        shape_ = unifier.Shape();
        const auto history = unifier.History();
        for (auto& [face, image] : images_) {
            const TopTools_ListOfShape& merged = history->Modified(image);
            image = merged.IsEmpty() ? image : merged.First();
        }
        return {};
    }

    [[nodiscard]] std::string answer(GrowTask task) const {
        GrowMessage answer{task, shape_, {}};
        const occ::Numbering after(shape_);
        for (const auto& [face, image] : images_) {
            const auto into = into_.find(face);
            const TopoDS_Shape& now = into == into_.end() ? image : images_.at(into->second);
            if (const int number = after.faces.FindIndex(now); number > 0) {
                answer.faces.emplace_back(face, number);
            }
        }
        return packed(answer);
    }

  private:
    /// The one face with which a face shares all of its edges; 0 if there is none.
    [[nodiscard]] int only_neighbour(int face,
                                     const TopTools_IndexedDataMapOfShapeListOfShape& users) const {
        std::set<int> neighbours;
        for (const TopoDS_Edge& edge : occ::edges_of(before_.faces(face))) {
            const TopTools_ListOfShape& of_edge = users.FindFromKey(edge);
            if (of_edge.Extent() != 2) {
                return 0;
            }
            for (const TopoDS_Shape& user : of_edge) {
                neighbours.insert(before_.faces.FindIndex(user));
            }
        }
        neighbours.erase(face);
        return neighbours.size() == 1 ? *neighbours.begin() : 0;
    }

    /// All edges and vertices of the shape but those of the new faces that are left.
    [[nodiscard]] TopTools_MapOfShape all_but_new() const {
        TopTools_IndexedMapOfShape theirs;
        for (const int face : new_faces_) {
            if (!into_.contains(face)) {
                TopExp::MapShapes(before_.faces(face), TopAbs_EDGE, theirs);
                TopExp::MapShapes(before_.faces(face), TopAbs_VERTEX, theirs);
            }
        }
        TopTools_MapOfShape others;
        for (const TopAbs_ShapeEnum kind : {TopAbs_EDGE, TopAbs_VERTEX}) {
            for (TopExp_Explorer it(shape_, kind); it.More(); it.Next()) {
                if (!theirs.Contains(it.Current())) {
                    others.Add(it.Current());
                }
            }
        }
        return others;
    }

    occ::Numbering before_;
    TopoDS_Shape shape_;
    std::vector<int> new_faces_;
    std::map<int, TopoDS_Shape> images_;  ///< of each face of the shape, what it has become
    std::map<int, int> into_;             ///< new face -> the one whose window it has closed
};

Result<std::string> merge(const GrowMessage& request) {
    Merger merger(request);
    merger.close_windows();
    return merger.unify().map([&] { return merger.answer(request.task); });
}

}  // namespace
}  // namespace suture

int main() {
    return suture::occ::serve("changing faces", [](const std::string& bytes) {
        const suture::GrowMessage request = suture::unpacked_grow_message(bytes);
        return request.task == suture::GrowTask::Merge ? suture::merge(request)
                                                       : suture::grow(request);
    });
}

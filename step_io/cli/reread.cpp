#include "cli/reread.h"

#include "files/step_faces.h"
#include "suture/occ/topology.h"

#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>

namespace suture::cli {
namespace {

TopTools_IndexedMapOfShape new_faces_and_neighbours(const FillOutcome& outcome) {
    TopTools_IndexedDataMapOfShapeListOfShape faces_of_edges;
    TopExp::MapShapesAndAncestors(outcome.shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edges);
    TopTools_IndexedMapOfShape result;
    for (const TopoDS_Face& face : outcome.new_faces) {
        for (const TopoDS_Edge& edge : occ::edges_of(face)) {
            const TopTools_ListOfShape* faces = faces_of_edges.Seek(edge);
            for (const TopoDS_Shape& met : faces ? *faces : TopTools_ListOfShape()) {
                result.Add(met);
            }
        }
    }
    return result;
}

std::size_t count_faces(const io::ModelFile& model) {
    std::size_t count = 0;
    for (const io::Part& part : model.parts()) {
        count += occ::faces_of(part.shape).size();
    }
    return count;
}

}  // namespace

RereadFaces::RereadFaces(const std::vector<FilledPart>& parts) {
    for (const FilledPart& part : parts) {
        const TopTools_IndexedMapOfShape faces = new_faces_and_neighbours(part.outcome);
        for (int i = 1; i <= faces.Extent(); ++i) {
            faces_.push_back(TopoDS::Face(faces(i)));
        }
        if (!faces.IsEmpty()) {
            groups_.push_back({static_cast<std::size_t>(faces.Extent()), part.before->placement});
        }
    }
}

Result<TopoDS_Shape> RereadFaces::read(const std::filesystem::path& file,
                                       const std::vector<io::StepId>& entities,
                                       const io::ModelFile& model) const {
    if (entities.size() != faces_.size() || std::ranges::count(entities, io::StepId{0}) > 0) {
        return fail(ErrorCode::Internal, "where the new faces stand in {} is not known",
                    file.string());
    }
    std::vector<std::vector<io::StepId>> numbers;
    auto next = entities.begin();
    for (const Group& group : groups_) {
        const auto end = next + static_cast<std::ptrdiff_t>(group.size);
        numbers.emplace_back(next, end);
        next = end;
    }
    return io::read_step_faces(file, numbers, count_faces(model))
        .map([&](const std::vector<TopoDS_Shape>& shapes) -> TopoDS_Shape {
            const BRep_Builder builder;
            TopoDS_Compound all;
            builder.MakeCompound(all);
            for (std::size_t i = 0; i < shapes.size(); ++i) {
                builder.Add(all, shapes[i].Moved(groups_[i].placement));
            }
            return all;
        });
}

}  // namespace suture::cli

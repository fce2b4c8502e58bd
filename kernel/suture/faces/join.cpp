#include "suture/faces/join.h"

#include "suture/faces/voids.h"
#include "suture/occ/children.h"
#include "suture/occ/guard.h"

#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <map>
#include <set>

namespace suture {
namespace {

/// A shell, or a face that belongs to none: what a new face can be added to.
struct Carrier {
    TopoDS_Shape shape;
    int leader = 0;  ///< the carrier that this one is merged into; itself if none
    int group = 0;   ///< the same for loose faces that hang together by edges: one shell's worth
    std::vector<TopoDS_Face> added;  ///< at leaders: the new faces
};

class Joiner {
  public:
    Joiner(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces) {
        for (TopExp_Explorer it(shape, TopAbs_SHELL); it.More(); it.Next()) {
            add_carrier(it.Current());
        }
        for (TopExp_Explorer it(shape, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next()) {
            add_carrier(it.Current());
            group_with_neighbours(it.Current());
        }
        for (const TopoDS_Face& face : faces) {
            attach(face);
        }
    }

    /// The shape with every carrier in its new form, and with the shells of faces that stand on
    /// none.
    [[nodiscard]] TopoDS_Shape rebuilt_whole(const TopoDS_Shape& shape) const {
        TopoDS_Shape whole = rebuilt(shape);
        std::vector<TopoDS_Shape> alone;
        for (const int number : standalone_) {
            if (const TopoDS_Shape made = rebuilt_carrier(number); !made.IsNull()) {
                alone.push_back(as_solid(made));
            }
        }
        if (alone.empty()) {
            return whole;
        }
        TopoDS_Compound all;
        BRep_Builder().MakeCompound(all);
        if (!whole.IsNull() && whole.ShapeType() == TopAbs_COMPOUND) {
            for (TopoDS_Iterator it(whole); it.More(); it.Next()) {
                add(all, it.Value());
            }
        } else if (!whole.IsNull()) {
            add(all, whole);
        }
        for (const TopoDS_Shape& shell : alone) {
            add(all, shell);
        }
        return all;
    }

    /// The shape with every carrier in its new form; null if nothing is left of it.
    [[nodiscard]] TopoDS_Shape rebuilt(const TopoDS_Shape& shape) const {
        if (const int* number = carrier_of_.Seek(shape)) {
            return rebuilt_carrier(*number);
        }
        if (shape.ShapeType() > TopAbs_SHELL) {
            return bounds_new_face(shape) ? TopoDS_Shape() : shape;
        }
        auto children = occ::changed_children(
            shape, [this](const TopoDS_Shape& child) { return rebuilt(child); });
        if (!children) {
            return shape;
        }
        if (children->empty()) {
            return {};  // all of it was merged into another body
        }
        TopoDS_Shape copy = shape.EmptyCopied();
        if (shape.ShapeType() == TopAbs_COMPOUND) {
            children = take_in_voids(std::move(*children));
        }
        for (const TopoDS_Shape& child : *children) {
            add(copy, shape.ShapeType() == TopAbs_SOLID ? child : as_solid(child));
        }
        return copy.ShapeType() == TopAbs_SOLID ? outward(TopoDS::Solid(copy)) : copy;
    }

    /// A closed shell as a solid; anything else as it is.
    [[nodiscard]] static TopoDS_Shape as_solid(const TopoDS_Shape& shape) {
        if (shape.IsNull() || shape.ShapeType() != TopAbs_SHELL || !BRep_Tool::IsClosed(shape)) {
            return shape;
        }
        TopoDS_Solid solid;
        BRep_Builder().MakeSolid(solid);
        add(solid, shape);
        return outward(solid);
    }

  private:
    static void add(TopoDS_Shape& parent, const TopoDS_Shape& child) {
        BRep_Builder().Add(parent, child);
    }

    /// The solid with its outside outside: only for one closed shell, since the shells of voids
    /// face the other way.
    static TopoDS_Shape outward(TopoDS_Solid solid) {
        int shells = 0;
        bool closed = true;
        for (TopoDS_Iterator it(solid); it.More(); it.Next()) {
            ++shells;
            closed = closed && BRep_Tool::IsClosed(it.Value());
        }
        if (shells == 1 && closed) {
            BRepLib::OrientClosedSolid(solid);
        }
        return solid;
    }

    void add_carrier(const TopoDS_Shape& shape) {
        if (carrier_of_.IsBound(shape)) {
            return;  // the same shell in the same place twice
        }
        const int number = static_cast<int>(carriers_.size());
        carriers_.push_back({shape, number, number, {}});
        carrier_of_.Bind(shape, number);
        count_edges(shape, number);
    }

    void count_edges(const TopoDS_Shape& shape, int carrier) {
        for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
            const auto index = static_cast<std::size_t>(edges_.Add(it.Current()) - 1);
            uses_.resize(std::max(uses_.size(), index + 1));
            ++uses_[index][carrier];
        }
    }

    /// The carriers that use an edge once: a face is missing there. Other shells can have the edge
    /// as well, with both faces.
    [[nodiscard]] std::vector<int> open_at(const TopoDS_Shape& edge) const {
        std::vector<int> open;
        if (const int index = edges_.FindIndex(edge); index > 0) {
            for (const auto& [carrier, uses] : uses_[static_cast<std::size_t>(index - 1)]) {
                if (uses % 2 == 1) {
                    open.push_back(carrier);
                }
            }
        }
        return open;
    }

    /// Loose faces that share edges are filled as the shell that they would be.
    void group_with_neighbours(const TopoDS_Shape& loose) {
        const int number = carrier_of_.Find(loose);
        for (TopExp_Explorer it(loose, TopAbs_EDGE); it.More(); it.Next()) {
            const int* known = loose_edges_.Seek(it.Current());
            if (known == nullptr) {
                loose_edges_.Bind(it.Current(), number);
                continue;
            }
            const int group = carrier(*known).group;
            const int merged = carrier(number).group;
            if (group != merged) {
                for (Carrier& other : carriers_) {
                    other.group = other.group == merged ? group : other.group;
                }
            }
        }
    }

    Carrier& carrier(int number) { return carriers_[static_cast<std::size_t>(number)]; }

    void attach(const TopoDS_Face& face) {
        std::set<int> leaders;
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
            for (const int number : open_at(it.Current())) {
                for (const Carrier& other : carriers_) {
                    if (other.group == carrier(number).group) {
                        leaders.insert(other.leader);
                    }
                }
            }
        }
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
            new_edges_.Add(it.Current());
        }
        if (leaders.empty()) {  // it stands on curves alone
            standalone_.push_back(static_cast<int>(carriers_.size()));
            add_carrier(face);
            return;
        }
        const int leader = *leaders.begin();
        for (Carrier& other : carriers_) {
            if (other.leader != leader && leaders.contains(other.leader)) {
                auto& target = carrier(leader).added;
                target.insert(target.end(), other.added.begin(), other.added.end());
                other.added.clear();
                other.leader = leader;
            }
        }
        carrier(leader).added.push_back(face);
        count_edges(face, leader);  // for a further new face that meets this one
    }

    [[nodiscard]] TopoDS_Shape rebuilt_carrier(int number) const {
        const Carrier& self = carriers_[static_cast<std::size_t>(number)];
        if (self.leader != number) {
            return {};  // merged into another one
        }
        if (self.added.empty()) {
            return self.shape;
        }
        TopoDS_Shape shell;
        if (self.shape.ShapeType() == TopAbs_SHELL) {
            shell = self.shape.EmptyCopied();
        } else {
            TopoDS_Shell made;
            BRep_Builder().MakeShell(made);
            shell = made;
        }
        std::vector<TopoDS_Shape> sheets;
        for (const Carrier& member : carriers_) {
            if (member.leader == number) {
                sheets.push_back(member.shape);
            }
        }
        if (sheets.size() > 1) {
            face_alike(self.added, sheets);
        }
        for (const TopoDS_Shape& sheet : sheets) {
            for (TopExp_Explorer it(sheet, TopAbs_FACE); it.More(); it.Next()) {
                add(shell, it.Current());
            }
        }
        for (const TopoDS_Face& face : self.added) {
            add(shell, face);
        }
        shell.Closed(BRep_Tool::IsClosed(shell));
        return shell;
    }

    /// Whether a loose curve is a border of new faces now, and nothing else any more.
    [[nodiscard]] bool bounds_new_face(const TopoDS_Shape& curve) const {
        if (curve.ShapeType() != TopAbs_EDGE && curve.ShapeType() != TopAbs_WIRE) {
            return false;
        }
        for (TopExp_Explorer it(curve, TopAbs_EDGE); it.More(); it.Next()) {
            if (!new_edges_.Contains(it.Current())) {
                return false;
            }
        }
        return true;
    }

    /// Turns over the sheets that face the other way than the new faces which join them.
    static void face_alike(const std::vector<TopoDS_Face>& added,
                           std::vector<TopoDS_Shape>& sheets) {
        std::vector<TopoDS_Shape> queue(added.begin(), added.end());
        std::vector<bool> reached(sheets.size(), false);
        for (std::size_t k = 0; k < queue.size(); ++k) {
            for (std::size_t i = 0; i < sheets.size(); ++i) {
                const int sense = reached[i] ? 0 : common_sense(queue[k], sheets[i]);
                if (sense != 0) {
                    reached[i] = true;
                    if (sense > 0) {
                        sheets[i].Reverse();
                    }
                    queue.push_back(sheets[i]);
                }
            }
        }
    }

    /// Above zero if two shapes use most of the edges that they share in one direction, below if
    /// against each other, as neighbours do; zero if they share none.
    static int common_sense(const TopoDS_Shape& one, const TopoDS_Shape& two) {
        TopTools_IndexedMapOfShape edges;
        for (TopExp_Explorer it(one, TopAbs_EDGE); it.More(); it.Next()) {
            edges.Add(it.Current());
        }
        int sense = 0;
        for (TopExp_Explorer it(two, TopAbs_EDGE); it.More(); it.Next()) {
            if (const int index = edges.FindIndex(it.Current()); index > 0) {
                sense += edges(index).Orientation() == it.Current().Orientation() ? 1 : -1;
            }
        }
        return sense;
    }

    std::vector<Carrier> carriers_;
    std::vector<int> standalone_;  ///< carriers that are new faces themselves
    TopTools_IndexedMapOfShape new_edges_;
    TopTools_DataMapOfShapeInteger carrier_of_;
    TopTools_IndexedMapOfShape edges_;
    std::vector<std::map<int, int>> uses_;  // per edge: how often each carrier has it
    TopTools_DataMapOfShapeInteger loose_edges_;
};

}  // namespace

Result<TopoDS_Shape> join(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces) {
    return occ::guarded("sewing the new faces in", [&]() -> TopoDS_Shape {
        const Joiner joiner(shape, faces);
        return Joiner::as_solid(joiner.rebuilt_whole(shape));
    });
}

}  // namespace suture

#include "files/step_faces.h"

#include "files/file_bytes.h"
#include "files/static_scope.h"
#include "suture/occ/guard.h"
#include "suture/occ/topology.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <XSControl_WorkSession.hxx>

#include <sstream>
#include <unordered_map>

namespace suture::io {

namespace {

constexpr std::string_view kFace = "ADVANCED_FACE";

/// Where every statement of the DATA section stands and what it refers to.
class Statements {
  public:
    explicit Statements(std::string_view text) : text_(text) { StepScanner(text, *this).scan(); }
    [[nodiscard]] bool has_data() const { return data_ > 0; }

    void defines(StepId id, std::size_t at) {
        index_.emplace(id, statements_.size());
        statements_.push_back({id, at, at, references_.size()});
        last_ = std::max(last_, id);
    }
    void refers(StepId id) { references_.push_back(id); }
    void ends(std::size_t at) {
        if (data_ == 0 && data_begins_) {
            data_ = at;
        } else if (!statements_.empty() && statements_.back().end == statements_.back().begin) {
            statements_.back().end = at;
        }
    }
    bool keyword(std::string_view word) {
        data_begins_ = data_begins_ || word == "DATA";
        return !(word == "ENDSEC" && data_begins_);
    }

    [[nodiscard]] std::size_t size() const { return statements_.size(); }
    [[nodiscard]] StepId last() const { return last_; }
    [[nodiscard]] StepId id(std::size_t statement) const { return statements_[statement].id; }
    /// Everything up to the first statement.
    [[nodiscard]] std::string_view head() const { return text_.substr(0, data_); }
    [[nodiscard]] std::string_view of(std::size_t statement) const {
        const Statement& s = statements_[statement];
        return text_.substr(s.begin, s.end - s.begin);
    }
    /// Whether a statement reads #id=TYPE(...).
    [[nodiscard]] bool is(std::string_view type, std::size_t statement) const {
        const std::string_view whole = of(statement);
        const std::size_t name = whole.find_first_not_of(" \r\n\t", whole.find('=') + 1);
        return name != whole.npos && whole.substr(name).starts_with(type);
    }
    [[nodiscard]] std::size_t count(std::string_view type) const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < size(); ++i) {
            count += is(type, i) ? 1 : 0;
        }
        return count;
    }
    [[nodiscard]] const std::size_t* find(StepId id) const {
        const auto found = index_.find(id);
        return found == index_.end() ? nullptr : &found->second;
    }

    /// Marks a statement and all that it needs. Result: 0, or an entity that is not there.
    [[nodiscard]] StepId mark(std::size_t statement, std::vector<bool>& needed) const {
        std::vector<std::size_t> open{statement};
        while (!open.empty()) {
            const std::size_t next = open.back();
            open.pop_back();
            if (needed[next]) {
                continue;
            }
            needed[next] = true;
            const std::size_t end = next + 1 < statements_.size() ? statements_[next + 1].references
                                                                  : references_.size();
            for (std::size_t k = statements_[next].references; k < end; ++k) {
                const std::size_t* referred = find(references_[k]);
                if (referred == nullptr) {
                    return references_[k];
                }
                open.push_back(*referred);
            }
        }
        return 0;
    }

  private:
    struct Statement {
        StepId id;
        std::size_t begin, end, references;  ///< offsets in the text, first of the references
    };
    std::string_view text_;
    std::size_t data_ = 0;  ///< where the statements begin
    bool data_begins_ = false;
    StepId last_ = 0;
    std::vector<Statement> statements_;
    std::vector<StepId> references_;
    std::unordered_map<StepId, std::size_t> index_;
};

// Some are added, and readers take signed numbers.
constexpr StepId kHighestEntity = 2'000'000'000;

tl::unexpected<Error> refers_to_nothing(StepId missing) {
    return fail(ErrorCode::Unreadable, "entity #{} is referred to and missing", missing);
}

std::string list_of(const std::vector<StepId>& ids) {
    return fmt::format("#{}", fmt::join(ids, ",#"));
}

}  // namespace

Result<std::string> extract_step_faces(std::string_view text,
                                       const std::vector<std::vector<StepId>>& groups,
                                       std::size_t all_faces) {
    const Statements statements(text);
    if (!statements.has_data()) {
        return fail(ErrorCode::Unreadable, "the file has no DATA section");
    }
    if (statements.last() > kHighestEntity) {
        return fail(ErrorCode::Unreadable, "entity #{}: the highest number allowed is {}",
                    statements.last(), kHighestEntity);
    }
    if (const std::size_t faces = statements.count(kFace); faces != all_faces) {
        return fail(ErrorCode::Unreadable, "the file has {} faces, the model {}", faces, all_faces);
    }
    std::vector<bool> needed(statements.size(), false);
    for (const std::vector<StepId>& group : groups) {
        for (const StepId id : group) {
            const std::size_t* found = statements.find(id);
            if (found == nullptr || !statements.is(kFace, *found)) {
                return fail(ErrorCode::Unreadable, "entity #{} is no face", id);
            }
            if (const StepId missing = statements.mark(*found, needed); missing != 0) {
                return refers_to_nothing(missing);
            }
        }
    }
    // Units and accuracy: all representations in a file of ours have the same.
    StepId context = 0;
    StepId next = statements.last() + 1;
    for (std::size_t i = 0; i < statements.size() && context == 0; ++i) {
        const std::string_view statement = statements.of(i);
        if (statement.find("GLOBAL_UNIT_ASSIGNED_CONTEXT") != std::string_view::npos) {
            context = statements.id(i);
            if (const StepId missing = statements.mark(i, needed); missing != 0) {
                return refers_to_nothing(missing);
            }
        }
    }
    if (context == 0) {
        return fail(ErrorCode::Unreadable, "the file states no units");
    }
    std::string result(statements.head());
    result += '\n';
    for (std::size_t i = 0; i < statements.size(); ++i) {
        if (needed[i]) {
            result += statements.of(i);
            result += '\n';
        }
    }
    for (const std::vector<StepId>& group : groups) {
        result += fmt::format(
            "#{}=OPEN_SHELL('',({}));\n"
            "#{}=SHELL_BASED_SURFACE_MODEL('',(#{}));\n"
            "#{}=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#{}),#{});\n",
            next, list_of(group), next + 1, next, next + 2, next + 1, context);
        next += 3;
    }
    result += "ENDSEC;\nEND-ISO-10303-21;\n";
    return result;
}

Result<std::vector<TopoDS_Shape>> read_step_faces(const std::filesystem::path& file,
                                                  const std::vector<std::vector<StepId>>& groups,
                                                  std::size_t all_faces) {
    const Result<std::string> text = read_bytes(file).and_then(
        [&](const std::string& bytes) { return extract_step_faces(bytes, groups, all_faces); });
    if (!text) {
        return tl::unexpected(text.error());
    }
    return occ::guarded("reading", [&]() -> Result<std::vector<TopoDS_Shape>> {
        StaticScope scope;
        scope.set("xstep.cascade.unit", "MM");
        STEPControl_Reader reader;
        std::istringstream stream(*text);
        if (reader.ReadStream(file.c_str(), stream) != IFSelect_RetDone) {
            return fail(ErrorCode::Unreadable, "{} is damaged: OCCT cannot read its faces{}{}",
                        file.string(), scope.complaint().empty() ? "" : ": ", scope.complaint());
        }
        std::vector<TopoDS_Shape> shapes;
        const auto model = reader.WS()->Model();
        for (int i = 1; i <= model->NbEntities(); ++i) {
            if (model->Value(i)->IsKind(STANDARD_TYPE(StepShape_ShapeRepresentation))) {
                reader.ClearShapes();
                const bool done = reader.TransferEntity(model->Value(i));
                shapes.push_back(done ? reader.OneShape() : TopoDS_Shape());
            }
        }
        SUTURE_EXPECTS(shapes.size() == groups.size());
        for (std::size_t i = 0; i < groups.size(); ++i) {
            const std::size_t faces = shapes[i].IsNull() ? 0 : occ::faces_of(shapes[i]).size();
            if (faces != groups[i].size()) {
                return fail(ErrorCode::Unreadable, "OCCT reads {} of {} faces again from {}", faces,
                            groups[i].size(), file.string());
            }
        }
        return shapes;
    });
}

}  // namespace suture::io

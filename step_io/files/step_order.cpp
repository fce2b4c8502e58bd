#include "files/step_order.h"

#include "suture/occ/handle.h"

#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TCollection_HAsciiString.hxx>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

namespace suture::io {

namespace {

constexpr std::string_view kLook = "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION";

/// The statements of the DATA section by their numbers, and what they refer to.
class Statements {
  public:
    explicit Statements(std::string_view text) : text_(text) { StepScanner(text, *this).scan(); }

    void defines(StepId id, std::size_t at) {
        statements_.resize(std::max<std::size_t>(statements_.size(), id + 1));
        current_ = id;
        statements_[id].begin = at;
    }
    void refers(StepId id) { statements_[current_].needs.push_back(id); }
    void ends(std::size_t at) {
        if (current_ > 0 && statements_[current_].end == 0) {
            statements_[current_].end = at;
        }
    }
    bool keyword(std::string_view word) { return current_ == 0 || word != "ENDSEC"; }

    [[nodiscard]] StepId count() const {
        return statements_.empty() ? 0 : static_cast<StepId>(statements_.size() - 1);
    }
    [[nodiscard]] const std::vector<StepId>& needs(StepId id) const {
        return statements_[id].needs;
    }
    [[nodiscard]] std::string_view of(StepId id) const {
        return text_.substr(statements_[id].begin, statements_[id].end - statements_[id].begin);
    }
    [[nodiscard]] bool is_look(StepId id) const {
        const std::string_view whole = of(id);
        const std::size_t name = whole.find_first_not_of(" \n", whole.find('=') + 1);
        return name != whole.npos && whole.substr(name).starts_with(kLook);
    }
    [[nodiscard]] std::string_view head() const { return text_.substr(0, statements_[1].begin); }
    [[nodiscard]] std::string_view tail() const { return text_.substr(statements_[count()].end); }

  private:
    struct Statement {
        std::size_t begin = 0, end = 0;
        std::vector<StepId> needs;
    };
    std::string_view text_;
    StepId current_ = 0;
    std::vector<Statement> statements_;
};

/// Appends an entity and all that it needs and that has not been seen, each before what it needs.
void walk(const Statements& statements, StepId start, std::vector<bool>& seen,
          std::vector<StepId>& order) {
    std::vector<StepId> open{start};
    while (!open.empty()) {
        const StepId id = open.back();
        open.pop_back();
        if (seen[id]) {
            continue;
        }
        seen[id] = true;
        order.push_back(id);
        const std::vector<StepId>& needs = statements.needs(id);
        open.insert(open.end(), needs.rbegin(), needs.rend());
    }
}

/// A statement with other numbers.
void append(std::string_view statement, const std::vector<StepId>& numbers, std::string& text) {
    for (std::size_t at = 0; at < statement.size();) {
        if (statement[at] == '\'') {
            const std::size_t end =
                std::min(statement.find('\'', at + 1), statement.size() - 1) + 1;
            text += statement.substr(at, end - at);
            at = end;
        } else if (statement[at] == '#') {
            StepId id = 0;
            for (++at; at < statement.size() && statement[at] >= '0' && statement[at] <= '9';
                 ++at) {
                id = 10 * id + static_cast<StepId>(statement[at] - '0');
            }
            text += '#';
            text += std::to_string(numbers[id]);
        } else {
            text += statement[at++];
        }
    }
}

/// What a look says: its entities, numbered on from the last of those that are not looks'.
std::string content(const Statements& statements, StepId look, std::vector<bool> seen,
                    std::vector<StepId> numbers, StepId next) {
    std::vector<StepId> own;
    walk(statements, look, seen, own);
    for (const StepId id : own) {
        numbers[id] = next++;
    }
    std::string text;
    for (const StepId id : own) {
        append(statements.of(id), numbers, text);
    }
    return text;
}

}  // namespace

void count_instances(const StepData_StepModel& entities) {
    int count = 0;
    for (int i = 1; i <= entities.NbEntities(); ++i) {
        const auto instance = occ::cast<StepRepr_NextAssemblyUsageOccurrence>(entities.Value(i));
        if (!instance.IsNull()) {
            const std::string id = std::to_string(++count);
            instance->SetId(occ::make<TCollection_HAsciiString>(id.c_str()));
        }
    }
}

NumberedText in_fixed_order(std::string text) {
    const Statements statements(text);
    const StepId count = statements.count();
    NumberedText result;
    result.numbers.resize(count + 1);
    std::iota(result.numbers.begin(), result.numbers.end(), StepId{0});
    std::vector<StepId> looks;
    std::vector<bool> needed(count + 1, false);
    for (StepId id = 1; id <= count; ++id) {
        if (statements.is_look(id)) {
            looks.push_back(id);
        }
        for (const StepId other : statements.needs(id)) {
            needed[other] = true;
        }
    }
    if (looks.size() < 2) {
        result.text = std::move(text);
        return result;
    }
    std::vector<bool> seen(count + 1, false);
    std::vector<StepId> order;
    for (StepId id = 1; id <= count; ++id) {
        if (!needed[id] && !statements.is_look(id)) {
            walk(statements, id, seen, order);
        }
    }
    std::ranges::sort(order);  // all but the colours stays as it is
    StepId next = 1;
    for (const StepId id : order) {
        result.numbers[id] = next++;
    }
    std::vector<std::pair<std::string, StepId>> sorted;
    for (const StepId look : looks) {
        sorted.emplace_back(content(statements, look, seen, result.numbers, next), look);
    }
    std::ranges::sort(sorted);
    const std::size_t first = order.size();
    for (const auto& [said, look] : sorted) {
        walk(statements, look, seen, order);
    }
    for (std::size_t i = first; i < order.size(); ++i) {
        result.numbers[order[i]] = next++;
    }
    result.text.reserve(text.size() + text.size() / 16);
    result.text = statements.head();
    for (const StepId id : order) {
        append(statements.of(id), result.numbers, result.text);
        result.text += '\n';
    }
    result.text.pop_back();
    result.text += statements.tail();
    return result;
}

}  // namespace suture::io

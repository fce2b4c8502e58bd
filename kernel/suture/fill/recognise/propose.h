#pragma once

#include "suture/fill/extend/trimmed.h"
#include "suture/fill/fill.h"
#include "suture/fill/recognise/agreement.h"
#include "suture/fill/recognise/border.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace suture::recognise {

/// A surface on which the hole may lie, and how well it does.
struct Proposal {
    Surface surface;        ///< in model units
    extend::Locate locate;  ///< of a B-spline
    Agreement agreement;
    Recognised what;
    std::vector<std::string> facts;
    double fit_error = 0.0;                             ///< of a ball's envelope
    std::string kind = {};                              ///< of a candidate of the model
    std::shared_ptr<const ModelSurface> original = {};  ///< as Patch::original
};

/// The kind of a candidate that is some face's own surface.
inline constexpr std::string_view kSameSurface = "same surface";

/// Gaps up to this, as a share of the diameter, do not tell one surface from another.
[[nodiscard]] double alike(const Border& border);

/// Why surfaces were not believed: "sphere: ...; torus: ...".
class Refusals {
  public:
    void add(const std::string& what, const std::string& why);
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// The closed forms that are believed, the simplest kind first.
///
/// Two rims are first of all those of a bore: a cylinder, whose sides may be sharp. Where neither
/// that nor the normals tell a form, the cone between them is one.
///
/// Input    by_normals: whether the neighbours' normals are looked at.
[[nodiscard]] std::vector<Proposal> propose_forms(const Border& border, bool by_normals,
                                                  Refusals& refusals);

/// The envelopes of rolling balls that are believed.
[[nodiscard]] std::vector<Proposal> propose_balls(const Border& border, Refusals& refusals);

/// What of the model's candidates is believed.
[[nodiscard]] std::vector<Proposal> propose_candidates(const Border& border,
                                                       const FillOptions& options,
                                                       Refusals& refusals);

}  // namespace suture::recognise

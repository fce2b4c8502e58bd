#pragma once

#include "files/document.h"

#include <Quantity_ColorRGBA.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>

#include <array>
#include <optional>
#include <string>

namespace suture::io {

inline constexpr std::array kColourTypes{XCAFDoc_ColorGen, XCAFDoc_ColorSurf, XCAFDoc_ColorCurv};

/// What a file says of a shape besides its geometry.
struct Look {
    std::string name;
    std::array<std::optional<Quantity_ColorRGBA>, kColourTypes.size()> colours;
    occ::Handle<TColStd_HSequenceOfExtendedString> layers;

    [[nodiscard]] bool empty() const;
};

/// Reads and sets the looks of a document's labels.
class Looks {
  public:
    explicit Looks(const Document& document);

    /// What stands at `label`, over what is inherited.
    [[nodiscard]] Look of(const TDF_Label& label, Look inherited) const;

    void set(const TDF_Label& label, const Look& look) const;

  private:
    occ::Handle<XCAFDoc_ColorTool> colours_;
    occ::Handle<XCAFDoc_LayerTool> layers_;
};

}  // namespace suture::io

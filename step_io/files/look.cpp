#include "files/look.h"

#include <algorithm>

namespace suture::io {

bool Look::empty() const {
    return name.empty() && layers.IsNull() &&
           std::ranges::none_of(colours, [](const auto& colour) { return colour.has_value(); });
}

Looks::Looks(const Document& document)
    : colours_(colours_of(document)), layers_(layers_of(document)) {}

Look Looks::of(const TDF_Label& label, Look inherited) const {
    if (std::string name = name_of(label); !name.empty()) {
        inherited.name = std::move(name);
    }
    for (std::size_t i = 0; i < kColourTypes.size(); ++i) {
        Quantity_ColorRGBA colour;
        if (colours_->GetColor(label, kColourTypes[i], colour)) {
            inherited.colours[i] = colour;
        }
    }
    occ::Handle<TColStd_HSequenceOfExtendedString> layers;
    if (layers_->GetLayers(label, layers) && !layers->IsEmpty()) {
        inherited.layers = layers;
    }
    return inherited;
}

void Looks::set(const TDF_Label& label, const Look& look) const {
    if (!look.name.empty()) {
        set_name(label, look.name);
    }
    for (std::size_t i = 0; i < kColourTypes.size(); ++i) {
        if (look.colours[i]) {
            colours_->SetColor(label, *look.colours[i], kColourTypes[i]);
        }
    }
    if (!look.layers.IsNull()) {
        for (const TCollection_ExtendedString& layer : *look.layers) {
            layers_->SetLayer(label, layer);
        }
    }
}

}  // namespace suture::io

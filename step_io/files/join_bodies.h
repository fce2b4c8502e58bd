#pragma once

#include "files/document.h"

#include <string>

namespace suture::io {

/// OCCT reads a product of several bodies, a solid and a loose sheet say, as an assembly of parts
/// that the file knows nothing of, and would write it as such. This makes one part of each again:
/// a compound of bodies, whose colours and layers become those of the bodies.
void join_bodies(const Document& document);

/// Gives every root and every part that has no name one made from `name`.
void name_parts(const Document& document, const std::string& name);

}  // namespace suture::io

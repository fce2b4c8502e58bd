#pragma once

#include "cli/command.h"

#include <string>
#include <string_view>
#include <vector>

namespace suture::cli {

/// A report as one self-contained HTML page: the verdict and every section's whole table. Names
/// from files are escaped.
///
/// Input  scene: what report::make_scene gives; then the page also shows the model in 3D, and the
///        edges in a table of its own instead of in that of their section.
[[nodiscard]] std::string html_report(const Command& command, const Outcome& outcome,
                                      std::string_view scene = {});

/// One of the pictures of a gallery, and the page that it opens.
struct GalleryItem {
    std::string group;  ///< those that stand together
    std::string name;   ///< within the group
    std::string caption;
    bool good = false;
    std::string scene;  ///< empty: no picture, the caption says why
};

/// The same with pictures, which the page draws itself; each opens its scene in the same page.
[[nodiscard]] std::string gallery_report(const Command& command, const Outcome& outcome,
                                         const std::vector<GalleryItem>& items);

}  // namespace suture::cli

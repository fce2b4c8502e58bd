#pragma once

#include "suture/base/progress.h"
#include "suture/base/result.h"

#include <chrono>
#include <filesystem>
#include <string>

namespace suture::report {

/// What a picture shows; the words are those of the page's address (docs/report.md).
struct PictureWish {
    std::string view = "iso";        ///< iso, front, ..., worst, edge12, or a direction x,y,z
    std::string shading = "shaded";  ///< shaded, zebra, curvature
    bool edges = true;
    bool before = false;  ///< of a fill: the model as it was
    int width = 1600, height = 1000;
};

/// The browser that takes pictures: the program that SUTURE_BROWSER names, else the first of
/// chromium, chromium-browser, google-chrome in PATH.
///
/// Refuses  (Usage) if there is none.
[[nodiscard]] Result<std::filesystem::path> find_browser();

/// Opens a page of make_scene's in a headless browser, and writes what it shows as a PNG file.
///
/// Refuses  (Usage) if there is no browser; (Internal) if it fails or takes longer than the limit;
///          a cancelled run.
[[nodiscard]] Result<void> take_picture(const std::string& page, const PictureWish& wish,
                                        const std::filesystem::path& png,
                                        std::chrono::seconds limit, const Progress& progress);

}  // namespace suture::report

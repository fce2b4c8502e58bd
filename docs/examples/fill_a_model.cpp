// SPDX-License-Identifier: LGPL-2.1-or-later
// fill_a_model IN OUT.step: fills every hole of a model by the library, and says how it went.
//
//   find_package(Suture REQUIRED)
//   target_link_libraries(fill_a_model PRIVATE suture::io)
#include <suture/suture.h>

#include <cstdlib>
#include <iostream>

namespace {

int fail(const suture::Error& error) {
    std::cerr << error.message << '\n';
    return EXIT_FAILURE;
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) {
        std::cerr << "usage: fill_a_model IN OUT.step\n";
        return EXIT_FAILURE;
    }
    auto model = suture::io::read_model(words[1], {});
    if (!model) {
        return fail(model.error());
    }
    for (const suture::io::Part& part : model->parts()) {
        const suture::occ::Numbering numbering(part.shape);
        const auto loops = suture::find_loops(part.shape, numbering);
        if (!loops) {
            return fail(loops.error());
        }
        if (loops->empty()) {
            continue;
        }
        auto filled = suture::fill_holes(part.shape, numbering, {});
        if (!filled) {
            return fail(filled.error());
        }
        for (const suture::HoleReport& hole : filled->holes) {
            std::cout << "hole " << hole.ids.front() << ": " << hole.method_used << ", gap "
                      << hole.max_gap << " mm, angle " << hole.max_angle << " rad\n";
        }
        model->replace(part, filled->shape, {});
        model->adopt_looks(part, filled->new_faces);
    }
    const auto report = suture::measure_continuity(model->shape(), suture::Profile(), {}, {});
    if (!report) {
        return fail(report.error());
    }
    std::cout << report->free_edges.size() << " free edges\n";
    const auto written = suture::io::write_model(*model, words[2], suture::io::Format::Step, {});
    return written ? EXIT_SUCCESS : fail(written.error());
}

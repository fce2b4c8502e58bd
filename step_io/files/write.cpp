#include "files/write.h"

#include "files/atomic_file.h"
#include "files/brep.h"
#include "files/write_iges.h"
#include "files/write_step.h"
#include "suture/occ/guard.h"

namespace suture::io {

namespace {

Result<void> write_mesh(const Mesh& mesh, const std::string& name, Format format,
                        std::ostream& stream) {
    switch (format) {
        case Format::Off:
            return write_off(mesh, stream);
        case Format::Obj:
            return write_obj(mesh, name, stream);
        case Format::ThreeMf:
            return write_3mf(mesh, name, stream);
        default:
            return write_stl(mesh, stream);
    }
}

Result<void> write_content(const ModelFile& model, const std::string& name, Format format,
                           const MeshOptions& options, std::ostream& stream) {
    switch (format) {
        case Format::Iges:
            return write_iges(model, name, stream);
        case Format::BrepText:
            return write_brep_text(model.shape(), stream);
        case Format::BrepBinary:
            return write_brep_binary(model.shape(), stream);
        case Format::BrepFreecad:
            return write_brep_freecad(model.shape(), stream);
        default:
            return make_mesh(model.shape(), options).and_then([&](const Mesh& mesh) {
                return write_mesh(mesh, name, format, stream);
            });
    }
}

}  // namespace

Result<std::vector<StepId>> write_model(const ModelFile& model, const std::filesystem::path& file,
                                        Format format, const MeshOptions& mesh,
                                        std::span<const TopoDS_Face> traced) {
    const std::string name = file.stem().string();
    std::vector<StepId> numbers;
    const Result<void> done = write_atomically(file, [&](std::ostream& stream) {
        return occ::guarded("writing " + file.string(), [&]() -> Result<void> {
            if (format == Format::Step) {
                return write_step(model, name, traced, stream).map([&](std::vector<StepId>&& ids) {
                    numbers = std::move(ids);
                });
            }
            return write_content(model, name, format, mesh, stream);
        });
    });
    return done.map([&] { return std::move(numbers); });
}

}  // namespace suture::io

#include "files/write.h"

#include "files/atomic_file.h"
#include "files/brep.h"
#include "files/read.h"
#include "files/write_iges.h"
#include "files/write_step.h"
#include "suture/occ/guard.h"

namespace suture::io {

namespace {

Result<void> write_mesh_content(const Mesh& mesh, const std::string& name, Format format,
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
                return write_mesh_content(mesh, name, format, stream);
            });
    }
}

}  // namespace

Result<ModelFile> read_again(const std::filesystem::path& written,
                             const std::filesystem::path& file, const Progress& progress) {
    Result<ModelFile> model = read_model(written, progress);
    if (model || model.error().code == ErrorCode::Cancelled) {
        return model;
    }
    std::string reason = model.error().message;
    for (std::size_t at = 0; (at = reason.find(written.string(), at)) != reason.npos;) {
        reason.replace(at, written.string().size(), "the new file");
    }
    return fail(ErrorCode::Internal, "{} is not written: {}", file.string(), reason);
}

Result<std::vector<StepId>> write_model(const ModelFile& model, const std::filesystem::path& file,
                                        Format format, const MeshOptions& mesh,
                                        std::span<const TopoDS_Face> traced, const Verify& verify) {
    const std::string name = file.stem().string();
    std::vector<StepId> numbers;
    const auto content = [&](std::ostream& stream) {
        return occ::guarded("writing " + file.string(), [&]() -> Result<void> {
            if (format == Format::Step) {
                return write_step(model, name, traced, stream).map([&](std::vector<StepId>&& ids) {
                    numbers = std::move(ids);
                });
            }
            return write_content(model, name, format, mesh, stream);
        });
    };
    const auto look = [&](const std::filesystem::path& written) -> Result<void> {
        if (verify) {
            return verify(written, numbers);
        }
        return is_mesh(format) ? Result<void>()
                               : read_again(written, file, {}).map([](const ModelFile&) {});
    };
    const Result<void> done = write_atomically(file, content, look);
    return done.map([&] { return std::move(numbers); });
}

Result<void> write_mesh(const Mesh& mesh, const std::filesystem::path& file, Format format) {
    return write_atomically(file, [&](std::ostream& stream) {
        return occ::guarded("writing " + file.string(), [&] {
            return write_mesh_content(mesh, file.stem().string(), format, stream);
        });
    });
}

}  // namespace suture::io

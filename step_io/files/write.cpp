#include "files/write.h"

#include "files/atomic_file.h"
#include "files/brep.h"
#include "files/gltf.h"
#include "files/mesh_tree.h"
#include "files/read.h"
#include "files/write_iges.h"
#include "files/write_step.h"
#include "suture/occ/guard.h"

#include <algorithm>

namespace suture::io {

namespace {

/// The whole model as one mesh.
Result<MeshFacts> write_one_mesh(const ModelFile& model, Format format, const MeshOptions& options,
                                 std::ostream& stream) {
    return make_mesh(model.shape(), options).and_then([&](const Mesh& mesh) {
        const Result<void> written =
            format == Format::Off ? write_off(mesh, stream) : write_stl(mesh, stream);
        return written.map([&] { return mesh.facts; });
    });
}

/// With the tree of its parts, their names and colours.
Result<MeshFacts> write_mesh_tree(const MeshTree& tree, const std::filesystem::path& file,
                                  Format format, std::ostream& stream) {
    if (format == Format::ThreeMf) {
        return write_3mf(tree, stream).map([&] { return facts_of(tree); });
    }
    // Materials have a file of their own beside an OBJ file.
    const std::filesystem::path materials = std::filesystem::path(file).replace_extension(".mtl");
    Result<void> written;
    if (!tree.colours.empty()) {
        written =
            write_atomically(materials, [&](std::ostream& out) { return write_mtl(tree, out); });
    }
    return written
        .and_then([&] {
            return write_obj(tree, tree.colours.empty() ? "" : materials.filename().string(),
                             stream);
        })
        .map([&] { return facts_of(tree); });
}

Result<MeshFacts> write_mesh_content(const ModelFile& model, const std::filesystem::path& file,
                                     Format format, const MeshOptions& options,
                                     std::ostream& stream) {
    if (format == Format::Stl || format == Format::Off) {
        return write_one_mesh(model, format, options, stream);
    }
    if (format == Format::Gltf) {
        return make_mesh(model.shape(), options).and_then([&](const Mesh& mesh) {
            return write_gltf(model, {mesh.facts.deflection, options.angular_deflection}, stream)
                .map([&] { return mesh.facts; });
        });
    }
    return make_mesh_tree(model, options).and_then([&](const MeshTree& tree) {
        return write_mesh_tree(tree, file, format, stream);
    });
}

/// A mesh of nothing is none.
Result<MeshFacts> expect_triangles(MeshFacts&& facts) {
    if (facts.triangles > 0) {
        return std::move(facts);
    }
    return facts.left_out.empty()
               ? fail(ErrorCode::WriteFailed,
                      "the model has no face, of which a mesh could be made")
               : fail(ErrorCode::WriteFailed, "no face of the model can be meshed: {}",
                      text_of(facts.left_out.front()));
}

/// Of those who are not told, nothing may be missing.
Result<void> expect_all_faces(const MeshFacts& facts) {
    const auto missing = std::ranges::find_if(facts.left_out, &UnmeshedFace::area);
    return missing == facts.left_out.end()
               ? Result<void>()
               : fail(ErrorCode::WriteFailed,
                      "{}; write STEP: `suture convert` makes a mesh of it without that face",
                      text_of(*missing));
}

Result<void> write_content(const ModelFile& model, const std::filesystem::path& file, Format format,
                           const MeshOptions& options, std::ostream& stream) {
    switch (format) {
        case Format::Iges:
            return write_iges(model, file.stem().string(), stream);
        case Format::BrepText:
            return write_brep_text(model.shape(), stream);
        case Format::BrepBinary:
            return write_brep_binary(model.shape(), stream);
        case Format::BrepFreecad:
            return write_brep_freecad(model.shape(), stream);
        default:
            return write_mesh_content(model, file, format, options, stream)
                .and_then(expect_triangles)
                .and_then(expect_all_faces);
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
            return write_content(model, file, format, mesh, stream);
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

Result<MeshFacts> write_mesh(const ModelFile& model, const std::filesystem::path& file,
                             Format format, const MeshOptions& options) {
    MeshFacts facts;
    const Result<void> done = write_atomically(file, [&](std::ostream& stream) {
        return occ::guarded("writing " + file.string(), [&]() -> Result<void> {
            return write_mesh_content(model, file, format, options, stream)
                .and_then(expect_triangles)
                .map([&](MeshFacts&& told) { facts = std::move(told); });
        });
    });
    return done.map([&] { return facts; });
}

}  // namespace suture::io

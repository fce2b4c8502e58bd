#include "files/gltf.h"

#include "files/document.h"
#include "files/gltf_module.h"
#include "suture/platform/on_demand.h"

#include <stdlib.h>

#include <BRepTools.hxx>

#include <filesystem>
#include <fstream>
#include <system_error>
#include <tuple>

namespace suture::io {

namespace {

namespace fs = std::filesystem;

/// Triangles in a model's own shapes, as long as this lives.
class Triangulated {
  public:
    Triangulated(TopoDS_Shape shape, const MeshOptions& options) : shape_(std::move(shape)) {
        // make_mesh has told of faces that have none.
        std::ignore = triangulate(shape_, options.deflection, options.angular_deflection);
    }
    ~Triangulated() { BRepTools::Clean(shape_); }
    Triangulated(const Triangulated&) = delete;
    Triangulated& operator=(const Triangulated&) = delete;

  private:
    TopoDS_Shape shape_;
};

/// OCCT writes to a name only, and other files beside it meanwhile.
class GltfFolder {
  public:
    GltfFolder() {
        std::string name = (fs::temp_directory_path() / "suture-gltf-XXXXXX").string();
        if (mkdtemp(name.data()) != nullptr) {
            path_ = name;
        }
    }
    ~GltfFolder() {
        std::error_code ignored;
        if (!path_.empty()) {
            fs::remove_all(path_, ignored);
        }
    }
    GltfFolder(const GltfFolder&) = delete;
    GltfFolder& operator=(const GltfFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

}  // namespace

Result<void> write_gltf(const ModelFile& model, const MeshOptions& options, std::ostream& stream) {
    const GltfFolder folder;
    const fs::path file = folder.path() / "model.glb";
    const Triangulated meshed(model.shape(), options);
    WriteGltf* const write =
        *static_cast<WriteGltf* const*>(symbol_on_demand("suture_gltf.so", "suture_write_gltf"));
    if (folder.path().empty() || !write(model.document, file.c_str())) {
        return fail(ErrorCode::WriteFailed, "glTF cannot be written to the temporary files in {}",
                    fs::temp_directory_path().string());
    }
    stream << std::ifstream(file, std::ios::binary).rdbuf();
    return {};
}

}  // namespace suture::io

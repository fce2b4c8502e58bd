#include "files/gltf_module.h"

#include <Message_ProgressRange.hxx>
#include <RWGltf_CafWriter.hxx>
#include <TColStd_IndexedDataMapOfStringString.hxx>

namespace suture::io {

namespace {

bool write_gltf(const Document& document, const char* file) {
    constexpr double kMillimetre = 1e-3;
    RWGltf_CafWriter writer(file, /*theIsBinary=*/true);
    writer.ChangeCoordinateSystemConverter().SetInputLengthUnit(kMillimetre);
    writer.ChangeCoordinateSystemConverter().SetInputCoordinateSystem(RWMesh_CoordinateSystem_Zup);
    writer.SetNodeNameFormat(RWMesh_NameFormat_InstanceOrProduct);
    writer.SetMeshNameFormat(RWMesh_NameFormat_Product);
    TColStd_IndexedDataMapOfStringString facts;
    facts.Add("Generator", "Suture " SUTURE_VERSION);
    return writer.Perform(document, facts, Message_ProgressRange());
}

}  // namespace

}  // namespace suture::io

extern "C" {
/// What write_gltf in files/gltf.h looks for.
extern suture::io::WriteGltf* const suture_write_gltf;
suture::io::WriteGltf* const suture_write_gltf = suture::io::write_gltf;
}

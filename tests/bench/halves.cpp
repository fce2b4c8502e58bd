// How much of a model's volume is lost or doubled by cutting it in two, relative to all of it: the
// common part with half of space, and what is left. OCCT's default integration is off by up to
// 2e-4 on trimmed spheres; this one is adaptive.
//     halves IN.step

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>

#include <cmath>
#include <iostream>

namespace {

double volume(const TopoDS_Shape& shape) {
    constexpr double kAccuracy = 1e-9;
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties, kAccuracy, /*OnlyClosed=*/Standard_False);
    return properties.Mass();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: halves IN.step\n";
        return 1;
    }
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Reader reader;
    if (reader.ReadFile(argv[1]) != IFSelect_RetDone || reader.TransferRoots() == 0) {
        std::cerr << argv[1] << " cannot be read\n";
        return 2;
    }
    const TopoDS_Shape shape = reader.OneShape();
    Bnd_Box box;
    BRepBndLib::Add(shape, box);
    const gp_Pnt low = box.CornerMin();
    const gp_Pnt high = box.CornerMax();
    const double size = low.Distance(high);
    // Off the middle: models are symmetrical, and edges lie there.
    constexpr double kPart = 0.4871;
    const gp_Pnt corner = low.Translated(gp_Vec(-size, -size, -size));
    const TopoDS_Shape half =
        BRepPrimAPI_MakeBox(corner, size + kPart * (high.X() - low.X()), 3 * size, 3 * size)
            .Shape();
    const double whole = volume(shape);
    const double parts = volume(BRepAlgoAPI_Common(shape, half).Shape()) +
                         volume(BRepAlgoAPI_Cut(shape, half).Shape());
    std::cout << std::abs(parts - whole) / std::abs(whole) << '\n';
    return 0;
}

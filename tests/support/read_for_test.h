#pragma once

#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

#include <string>

namespace suture::test {

/// The shape of a STEP or IGES file as OCCT's plain readers give it, null where they fail.
inline TopoDS_Shape read_for_test(const std::string& path) {
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    const auto read = [&path](auto&& reader) {
        TopoDS_Shape shape;
        if (reader.ReadFile(path.c_str()) == IFSelect_RetDone) {
            reader.TransferRoots();
            shape = reader.OneShape();
        }
        return shape;
    };
    const bool iges = path.ends_with(".igs") || path.ends_with(".iges");
    return iges ? read(IGESControl_Reader()) : read(STEPControl_Reader());
}

}  // namespace suture::test

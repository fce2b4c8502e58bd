// The bare OCCT program that `suture fill` is weighed against: one reading and one writing of a
// STEP file, nothing else.
//     bare_read_write IN.step OUT.step

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>

#include <iostream>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: bare_read_write IN.step OUT.step\n";
        return 1;
    }
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Reader reader;
    if (reader.ReadFile(argv[1]) != IFSelect_RetDone || reader.TransferRoots() == 0) {
        std::cerr << argv[1] << " cannot be read\n";
        return 2;
    }
    STEPControl_Writer writer;
    if (writer.Transfer(reader.OneShape(), STEPControl_AsIs) != IFSelect_RetDone ||
        writer.Write(argv[2]) != IFSelect_RetDone) {
        std::cerr << argv[2] << " cannot be written\n";
        return 2;
    }
    return 0;
}

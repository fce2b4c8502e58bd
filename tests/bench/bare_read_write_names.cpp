// The same reading and writing with all that a STEP file says beside its shapes: names, colours,
// layers and the assembly tree, as `suture fill` keeps them.
//     bare_read_write_names IN.step OUT.step

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>

#include <iostream>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: bare_read_write_names IN.step OUT.step\n";
        return 1;
    }
    Message::DefaultMessenger()->ChangePrinters().Clear();
    opencascade::handle<TDocStd_Document> document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    STEPCAFControl_Reader reader;
    if (reader.ReadFile(argv[1]) != IFSelect_RetDone || !reader.Transfer(document)) {
        std::cerr << argv[1] << " cannot be read\n";
        return 2;
    }
    STEPCAFControl_Writer writer;
    if (!writer.Transfer(document, STEPControl_AsIs) || writer.Write(argv[2]) != IFSelect_RetDone) {
        std::cerr << argv[2] << " cannot be written\n";
        return 2;
    }
    return 0;
}

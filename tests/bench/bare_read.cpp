// The bare OCCT program that `suture check` is weighed against: one reading of a STEP or IGES file,
// nothing else.
//     bare_read IN

#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>

#include <iostream>
#include <string>

namespace {

template <class Reader>
int read(const char* file) {
    Reader reader;
    if (reader.ReadFile(file) != IFSelect_RetDone || reader.TransferRoots() == 0 ||
        reader.OneShape().IsNull()) {
        std::cerr << file << " cannot be read\n";
        return 2;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: bare_read IN\n";
        return 1;
    }
    Message::DefaultMessenger()->ChangePrinters().Clear();
    const std::string file = argv[1];
    const bool iges = file.find(".igs") != file.npos || file.find(".iges") != file.npos;
    return iges ? read<IGESControl_Reader>(argv[1]) : read<STEPControl_Reader>(argv[1]);
}

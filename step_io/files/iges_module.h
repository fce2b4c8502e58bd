#pragma once

#include "files/document.h"

#include <Message_ProgressRange.hxx>

#include <ostream>
#include <string>

namespace suture::io {

/// What a file's global section says.
struct IgesGlobals {
    double unit = 1.0;        ///< in millimetres
    double resolution = 0.0;  ///< in that unit
    std::string author, company;
};

enum class IgesOutcome { Done, FileFailed, TransferFailed };

/// All that calls OCCT's IGES libraries. It is a module of its own, loaded only by runs that read
/// or write IGES, and knows nothing of the rest of Suture.
struct IgesModule {
    /// Makes the parameters "write.iges...".
    void (*make_parameters)();
    IgesOutcome (*read)(const char* file, const Document& document, IgesGlobals& globals,
                        const Message_ProgressRange& progress);
    /// Input    time: of the writing, as IGES has it.
    IgesOutcome (*write)(const Document& document, const char* time, std::ostream& stream);
};

/// The module, loaded at the first call, its parameters made. Throws std::runtime_error without it.
const IgesModule& iges_module();

}  // namespace suture::io

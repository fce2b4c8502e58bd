#pragma once

#include <fmt/format.h>
#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace suture {

/// Why something could not be done. The command line turns each into its exit code.
enum class ErrorCode {
    Usage,        ///< the caller asked for something that makes no sense: a negative tolerance
    Unreadable,   ///< the input file is missing, damaged, or of no known type
    NothingToDo,  ///< the model has no hole
    Refused,      ///< a method cannot treat this hole; the message names the side and the reason
    WriteFailed,  ///< the output could not be written; the old file is intact
    Cancelled,    ///< the user stopped the run
    Internal,     ///< a library failed where it should not have: OCCT threw, crashed, or hung
};

/// An expected failure: one sentence that names the file, the edge, the face, the number and the
/// limit, so that the reader can act on it.
struct Error {
    ErrorCode code = ErrorCode::Internal;
    std::string message;
};

/// A value, or the reason why there is none.
template <class T>
using Result = tl::expected<T, Error>;

/// An Error ready to be returned from a function whose result is a Result.
template <class... Args>
[[nodiscard]] tl::unexpected<Error> fail(ErrorCode code, fmt::format_string<Args...> text,
                                         Args&&... args) {
    return tl::unexpected(Error{code, fmt::format(text, std::forward<Args>(args)...)});
}

}  // namespace suture

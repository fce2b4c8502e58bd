#pragma once

#include "suture/base/result.h"

namespace suture::cli {

// What the program's exit code says. Ended by SIGINT or SIGTERM: 130 or 143, as shells have it.
inline constexpr int kDone = 0;
inline constexpr int kUsage = 1;           ///< the command line makes no sense; nothing was touched
inline constexpr int kUnreadable = 2;      ///< the input file cannot be read
inline constexpr int kNothingToDo = 3;     ///< the model has no hole to fill
inline constexpr int kOutOfTolerance = 4;  ///< done, but something is out of tolerance or refused
inline constexpr int kInternal = 5;        ///< a failure inside, or the output cannot be written
inline constexpr int kInterrupted = 130;

/// The exit code of a run that an error ended.
[[nodiscard]] constexpr int exit_code(ErrorCode code) {
    switch (code) {
        case ErrorCode::Usage:
            return kUsage;
        case ErrorCode::Unreadable:
            return kUnreadable;
        case ErrorCode::NothingToDo:
            return kNothingToDo;
        case ErrorCode::Refused:
            return kOutOfTolerance;
        case ErrorCode::Cancelled:
            return kInterrupted;
        case ErrorCode::WriteFailed:
        case ErrorCode::Internal:
            break;
    }
    return kInternal;
}

/// "usage", "unreadable", ...: the error's code in JSON documents.
[[nodiscard]] constexpr std::string_view to_string(ErrorCode code) {
    switch (code) {
        case ErrorCode::Usage:
            return "usage";
        case ErrorCode::Unreadable:
            return "unreadable";
        case ErrorCode::NothingToDo:
            return "nothing_to_do";
        case ErrorCode::Refused:
            return "refused";
        case ErrorCode::WriteFailed:
            return "write_failed";
        case ErrorCode::Cancelled:
            return "cancelled";
        case ErrorCode::Internal:
            break;
    }
    return "internal";
}

}  // namespace suture::cli

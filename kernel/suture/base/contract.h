#pragma once

#include <fmt/format.h>

#include <stdexcept>

namespace suture {

/// A broken promise between two pieces of our own code: always a bug, never the user's doing.
class ContractViolation : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

}  // namespace suture

/// Checked in release builds too: a stop with a message is better than silently wrong geometry.
#define SUTURE_EXPECTS(condition)                                                   \
    do {                                                                            \
        if (!(condition)) {                                                         \
            throw ::suture::ContractViolation(                                      \
                fmt::format("{}:{}: expected {}", __FILE__, __LINE__, #condition)); \
        }                                                                           \
    } while (false)

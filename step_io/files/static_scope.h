#pragma once

#include "suture/occ/handle.h"

#include <Interface_Static.hxx>
#include <Message_Printer.hxx>
#include <Message_SequenceOfPrinters.hxx>

#include <mutex>
#include <streambuf>
#include <string>
#include <variant>
#include <vector>

namespace suture::io {

/// OCCT's global state in one place. While a scope lives, this thread alone reads or writes files
/// with OCCT, OCCT prints nothing (its messages and what it sends to std::cout are dropped, but for
/// the first complaint), and parameters may be set; at its end everything is as it was before.
class StaticScope {
  public:
    StaticScope();
    ~StaticScope();
    StaticScope(const StaticScope&) = delete;
    StaticScope& operator=(const StaticScope&) = delete;

    /// One of OCCT's Interface_Static parameters, "write.step.unit" say. A name or a value that
    /// OCCT does not know is a ContractViolation.
    void set(const char* name, int value);
    void set(const char* name, double value);
    void set(const char* name, const char* value);

    /// OCCT's first message of failure since the scope began, or nothing.
    [[nodiscard]] const std::string& complaint() const { return *complaint_; }

  private:
    struct Saved {
        occ::Handle<Interface_Static> parameter;
        std::variant<int, double, std::string> value;
    };
    struct Silence : std::streambuf {
        int overflow(int character) override { return traits_type::not_eof(character); }
    };
    void save(const char* name);

    std::unique_lock<std::mutex> lock_;
    std::vector<Saved> saved_;
    Message_SequenceOfPrinters printers_;
    Silence silence_;
    std::streambuf* cout_buffer_;
    bool auto_naming_;
    std::shared_ptr<std::string> complaint_;
};

}  // namespace suture::io

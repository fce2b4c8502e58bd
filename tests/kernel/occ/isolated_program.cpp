// What isolate_test.cpp starts: does what it is asked for.
#include "suture/occ/isolate.h"

#include <Standard_DomainError.hxx>

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

namespace {

using suture::Result;

Result<std::string> act(const std::string& request) {
    using namespace std::chrono_literals;
    if (request == "crash") {
        std::signal(SIGSEGV, SIG_DFL);
        std::raise(SIGSEGV);
    }
    if (request == "hang") {
        std::this_thread::sleep_for(300s);
    }
    if (request == "refuse") {
        return suture::fail(suture::ErrorCode::Refused, "edge 7");
    }
    if (request == "throw") {
        throw Standard_DomainError("far");
    }
    std::cout << "what OCCT prints is no answer\n";
    return request;
}

}  // namespace

int main() {
    return suture::occ::serve("filling", act);
}

#pragma once

#include <string>

namespace suture {

/// A symbol of a shared library that is loaded when it is first asked for, and stays loaded: what
/// few runs need costs the others nothing. The loader takes 30 ms for OpenBLAS, IGES, OCCT's
/// filling and libzip, as long as all the rest of filling a small file.
///
/// Input    the library's file name: the system's, or a module of ours, which the program finds by
///          its run path (cmake/suture_target.cmake).
/// Refuses  by std::runtime_error a library that is not there, or has no such symbol: the
///          installation is broken.
[[nodiscard]] void* symbol_on_demand(const char* library, const char* symbol);

/// The function `name` of a library, in the same way.
template <class Function>
[[nodiscard]] Function* function_on_demand(const char* library, const char* name) {
    return reinterpret_cast<Function*>(symbol_on_demand(library, name));
}

/// Where a program of ours stands that does its work in a process of its own: on the run path too.
///
/// Refuses  by std::runtime_error one that is not there.
[[nodiscard]] std::string program_on_demand(const char* name);

}  // namespace suture

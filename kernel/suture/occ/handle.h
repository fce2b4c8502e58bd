#pragma once

#include <Standard_Handle.hxx>

#include <utility>

namespace suture::occ {

template <class T>
using Handle = opencascade::handle<T>;

/// A new OCCT object behind its handle: the word `new` is written here only.
template <class T, class... Args>
[[nodiscard]] Handle<T> make(Args&&... args) {
    return Handle<T>(new T(std::forward<Args>(args)...));
}

template <class T, class U>
[[nodiscard]] Handle<T> cast(const Handle<U>& handle) {
    return Handle<T>::DownCast(handle);
}

}  // namespace suture::occ

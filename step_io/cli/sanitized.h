#pragma once

namespace suture::cli {

/// Whether a limit of memory can be kept: the shadow of AddressSanitizer and ThreadSanitizer takes
/// terabytes of addresses.
inline constexpr bool kMemoryHasALimit =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    false;
#elif defined(__has_feature)  // clang's way to say so
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    false;
#else
    true;
#endif
#else
    true;
#endif

}  // namespace suture::cli

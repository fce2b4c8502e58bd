#pragma once

namespace suture {

/// Whether AddressSanitizer or ThreadSanitizer is built in. Their shadow takes terabytes of
/// addresses, so that no limit of memory can be kept, and they read of their own process in /proc.
inline constexpr bool kSanitized =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    true;
#elif defined(__has_feature)  // clang's way to say so
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    true;
#else
    false;
#endif
#else
    false;
#endif

}  // namespace suture

// Is this program compiled with AddressSanitizer? GCC and clang tell it in ways of their own.
#pragma once

namespace alphascope::testing {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kAddressSanitizer = true;
#elif defined(__has_feature)
inline constexpr bool kAddressSanitizer = __has_feature(address_sanitizer);
#else
inline constexpr bool kAddressSanitizer = false;
#endif

// A sanitizer takes some ten times as long, and looks for other faults than wrong results.
constexpr int unless_sanitized(int count, int fewer) {
  return kAddressSanitizer ? fewer : count;
}

}  // namespace alphascope::testing

// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether this program is compiled with AddressSanitizer. GCC and clang define it
// differently.
#pragma once

namespace alphascope::testing {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kAddressSanitizer = true;
#elif defined(__has_feature)
inline constexpr bool kAddressSanitizer = __has_feature(address_sanitizer);
#else
inline constexpr bool kAddressSanitizer = false;
#endif

// Returns `fewer` under a sanitizer, else `count`. A sanitizer takes about ten times as long, and
// does not look for wrong results.
constexpr int unless_sanitized(int count, int fewer) {
  return kAddressSanitizer ? fewer : count;
}

}  // namespace alphascope::testing

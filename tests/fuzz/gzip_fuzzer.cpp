// SPDX-License-Identifier: GPL-3.0-or-later
// Takes any bytes as gzip data. The result is a text within the limit, or a ReadError.
#include "core/text_files/gzip.hpp"
#include "tests/fuzz/check_molecule.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  constexpr std::uint64_t kLimit = std::uint64_t{1} << 14;  // bytes; small, for many runs
  const std::string_view packed(reinterpret_cast<const char*>(data), size);
  try {
    const alphascope::TextBuffer text = alphascope::unpack_gzip("fuzz.gz", packed, kLimit, {});
    alphascope::fuzz::require(text.size() <= kLimit);
    // Reads every byte.
    std::size_t sum = 0;
    for (const char c : text.view()) sum += static_cast<unsigned char>(c);
    alphascope::fuzz::require(sum <= 255 * text.size());
  } catch (const alphascope::ReadError& error) {
    alphascope::fuzz::require(!error.reason().empty() && !error.remedy().empty());
  }
  return 0;
}

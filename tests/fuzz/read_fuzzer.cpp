// Any bytes as a file of one format: a molecule that keeps its promises, or a ReadError.
#include "core/read/readers.hpp"
#include "tests/fuzz/check_molecule.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  alphascope::fuzz::check_reading([&] {
    return alphascope::ALPHASCOPE_FUZZ_READER({"fuzz", text, {}});
  });
  return 0;
}

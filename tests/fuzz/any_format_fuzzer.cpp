// Any bytes as a file whose name ends with one of our extensions, chosen by the first byte: the
// format must be told and its reader keep its promises, or a ReadError say what the file looks
// like.
#include "core/read/readers.hpp"
#include "core/read/sniff_format.hpp"
#include "tests/fuzz/check_molecule.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr const char* kNames[] = {"a",      "a.pdb", "a.cif",    "a.pqr",  "a.xyz",
                                    "a.xyzr", "a.crd", "a.ent.gz", "a.pdbqt"};
  const std::filesystem::path name = kNames[data[0] % 9];
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  alphascope::fuzz::check_reading([&] {
    return alphascope::read_format(alphascope::sniff_format(name, text), {name, text, {}});
  });
  return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Takes any bytes as a file. The first byte chooses one of our endings. Either the format is
// recognised and its reader keeps its promises, or a ReadError says what the file looks like.
#include <string>
#include <vector>

#include "core/geometry/lattice_alpha.hpp"
#include "core/read/read_molecule.hpp"
#include "tests/fuzz/check_molecule.hpp"

namespace {

std::vector<std::string> make_names() {
  std::vector<std::string> names{"a", "a.ent.gz"};
  for (const alphascope::FileFormat& format : alphascope::file_formats()) {
    for (const std::string_view ending : format.endings) names.push_back("a" + std::string(ending));
  }
  return names;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const std::vector<std::string> names = make_names();
  if (size == 0) return 0;
  const std::filesystem::path name = names[data[0] % names.size()];
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  alphascope::fuzz::check_reading([&] {
    return alphascope::read_format(alphascope::recognise_format(name, text), {name, text, {}});
  });
  return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Takes any bytes as a file of one format. The molecule keeps its promises, or there is a
// ReadError.
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/read/file_format.hpp"
#include "tests/fuzz/check_molecule.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const alphascope::FileFormat* const format =
      alphascope::format_from_id(ALPHASCOPE_FUZZ_FORMAT);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  alphascope::fuzz::check_reading([&] { return format->read({"fuzz", text, {}}); });
  return 0;
}

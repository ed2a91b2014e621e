// SPDX-License-Identifier: GPL-3.0-or-later
// Takes any bytes as a session file. The session is the same after writing and reading it, or there
// is a ReadError.
#include <cstdlib>

#include "core/document/session/session_file.hpp"
#include "core/files/read_error.hpp"
#include "core/geometry/lattice_alpha.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const alphascope::ReadSession read = alphascope::parse_session("S.json", text);
    const std::string written = alphascope::session_text(read.session);
    const alphascope::ReadSession again = alphascope::parse_session("S.json", written);
    if (alphascope::session_text(again.session) != written || !again.notes.empty()) std::abort();
  } catch (const alphascope::ReadError&) {
  }
  return 0;
}

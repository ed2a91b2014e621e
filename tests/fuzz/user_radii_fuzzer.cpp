// SPDX-License-Identifier: GPL-3.0-or-later
// Takes any bytes as a user's table of radii. Radii are above 0 and at most 60 Å, or there is a
// ReadError.
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/read/user_radii.hpp"
#include "tests/fuzz/check_molecule.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using alphascope::fuzz::require;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto sound = [](std::int32_t microangstrom) {
    return microangstrom > 0 && microangstrom <= 60'000'000;
  };
  try {
    const alphascope::UserRadii radii = alphascope::parse_user_radii("fuzz.txt", text);
    require(!radii.by_atom.empty() || !radii.by_element.empty());
    for (const auto& [name, radius] : radii.by_atom) require(!name.empty() && sound(radius));
    for (const auto& [element, radius] : radii.by_element) require(sound(radius));
  } catch (const alphascope::ReadError& error) {
    require(!error.reason().empty() && !error.remedy().empty());
  }
  return 0;
}

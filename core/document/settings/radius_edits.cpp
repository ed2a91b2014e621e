// SPDX-License-Identifier: GPL-3.0-or-later
// Sets, removes and finds radii that the user types for groups of atoms.
#include "core/document/settings/radius_edits.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/commands/number_input.hpp"

namespace alphascope {

bool set_radius(RadiusEdits& edits, const AtomGroup& atoms, double angstrom) {
  if (!(angstrom >= kBallRadiusRule.least && angstrom <= kBallRadiusRule.most)) return false;
  const auto microangstrom = static_cast<std::int32_t>(std::lround(angstrom * 1e6));
  const auto found = std::find_if(edits.begin(), edits.end(),
                                  [&](const RadiusOverride& edit) { return edit.atoms == atoms; });
  if (found != edits.end()) {
    found->microangstrom = microangstrom;
  } else {
    edits.push_back({atoms, microangstrom});
  }
  return true;
}

void reset_radius(RadiusEdits& edits, const AtomGroup& atoms) {
  std::erase_if(edits, [&](const RadiusOverride& edit) { return edit.atoms == atoms; });
}

const RadiusOverride* find_radius(const RadiusEdits& edits, const AtomGroup& atoms) {
  const auto found = std::find_if(edits.begin(), edits.end(),
                                  [&](const RadiusOverride& edit) { return edit.atoms == atoms; });
  return found != edits.end() ? &*found : nullptr;
}

}  // namespace alphascope

// See the header.
#include "ui/panels/radius_edits.hpp"

#include <algorithm>
#include <cmath>

#include "core/document/number_input.hpp"

namespace alphascope {
namespace {

constexpr double kPerAngstrom = 1e6;  // radii are kept to 10^-6 Å, as in tables of radii

}  // namespace

bool RadiusEdits::set(const AtomGroup& atoms, double radius) {
  if (!(radius >= kBallRadiusRule.least && radius <= kBallRadiusRule.most)) return false;
  radius = std::round(radius * kPerAngstrom) / kPerAngstrom;
  const auto found = std::find_if(list_.begin(), list_.end(),
                                  [&](const RadiusEdit& edit) { return edit.atoms == atoms; });
  if (found != list_.end()) {
    found->radius = radius;
  } else {
    list_.push_back({atoms, radius});
  }
  return true;
}

void RadiusEdits::reset(const AtomGroup& atoms) {
  std::erase_if(list_, [&](const RadiusEdit& edit) { return edit.atoms == atoms; });
}

const RadiusEdit* RadiusEdits::find(const AtomGroup& atoms) const {
  const auto found = std::find_if(list_.begin(), list_.end(),
                                  [&](const RadiusEdit& edit) { return edit.atoms == atoms; });
  return found != list_.end() ? &*found : nullptr;
}

}  // namespace alphascope

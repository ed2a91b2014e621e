// See the header.
#include "ui/panels/radius_edits.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace alphascope {
namespace {

constexpr double kPerAngstrom = 1e6;  // radii are kept to 10^-6 Å, as in tables of radii

}  // namespace

std::optional<double> RadiusEdits::parse(const std::string& text) {
  std::string plain = text;
  std::replace(plain.begin(), plain.end(), ',', '.');
  if (const auto unit = plain.find("Å"); unit != std::string::npos) plain.erase(unit);
  std::istringstream stream(plain);
  stream.imbue(std::locale::classic());
  double radius = 0;
  if (!(stream >> radius)) return std::nullopt;
  stream >> std::ws;
  if (!stream.eof()) return std::nullopt;
  return radius >= kSmallest && radius <= kLargest ? std::optional(radius) : std::nullopt;
}

bool RadiusEdits::set(const AtomGroup& atoms, double radius) {
  if (!(radius >= kSmallest && radius <= kLargest)) return false;
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

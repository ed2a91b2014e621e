// Radii that the user typed in place of guessed or missing ones. Plain data and rules, no ImGui.
#pragma once

#include <string>
#include <vector>

namespace alphascope {

// All atoms of one name, element and residue name, as the file has them (empty: it gives none).
struct AtomGroup {
  std::string residue, atom, element;
  friend bool operator==(const AtomGroup&, const AtomGroup&) = default;
};

struct RadiusEdit {
  AtomGroup atoms;
  double radius = 0;  // Å, within kBallRadiusRule
  friend bool operator==(const RadiusEdit&, const RadiusEdit&) = default;
};

class RadiusEdits {
 public:
  // Rounded to 10^-6 Å. Outside of kBallRadiusRule nothing changes and false is returned.
  bool set(const AtomGroup& atoms, double radius);
  void reset(const AtomGroup& atoms);
  void reset_all() { list_.clear(); }

  const RadiusEdit* find(const AtomGroup& atoms) const;
  const std::vector<RadiusEdit>& list() const { return list_; }
  friend bool operator==(const RadiusEdits&, const RadiusEdits&) = default;

 private:
  std::vector<RadiusEdit> list_;  // in the order in which they were made
};

}  // namespace alphascope

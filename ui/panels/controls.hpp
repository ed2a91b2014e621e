// What the user can set: plain data that the panels change and the program reads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/document/display.hpp"
#include "core/document/number_input.hpp"
#include "core/document/request.hpp"
#include "ui/panels/radius_edits.hpp"

namespace alphascope {

// Playing ends there, and starts again at 0.
inline constexpr double kPlayUntilAngstrom2 = 10;

// For what counts alpha up and down: stops at the bounds.
inline void set_alpha(Request& request, double angstrom2) {
  request.alpha_angstrom2 = std::clamp(angstrom2, kAlphaRule.least, kAlphaRule.most);
}

// Which atoms become balls, and how large; a change needs new balls.
enum class HydrogenOption : std::uint8_t { automatic, keep, drop };
enum class AltlocOption : std::uint8_t { best, all };
inline constexpr int kEveryModel = -1;
struct SelectionControls {
  bool polymers = true, ligands = true, ions = true, waters = false, dummies = false;
  HydrogenOption hydrogens = HydrogenOption::automatic;
  AltlocOption altlocs = AltlocOption::best;
  int radii_set = 0;        // index into ViewState::radii_sets
  std::string radii_table;  // file of the user's own set
  // What follows belongs to one file and is forgotten with it.
  std::string assembly;  // id; empty: as deposited
  int model = 0;         // index, or kEveryModel: all at once
  std::vector<std::string> chains_off;
  std::string expression;
  RadiusEdits radius_edits;
  friend bool operator==(const SelectionControls&, const SelectionControls&) = default;
};

}  // namespace alphascope

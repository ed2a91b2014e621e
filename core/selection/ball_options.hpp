// SPDX-License-Identifier: GPL-3.0-or-later
// The options that decide which atoms become balls, and with which radii.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/molecule/element.hpp"
#include "core/radii/radii_choice.hpp"

namespace alphascope {

struct UserRadii;

enum class AltlocRule : std::uint8_t {
  // One location per residue, of the atoms that chains and selection keep. Highest occupancy comes
  // first, then lowest B factor, then first letter.
  best,
  all,
};
// automatic drops hydrogens if the radii set is a united-atom one, which includes them.
enum class HydrogenRule : std::uint8_t { automatic, keep, drop };

inline constexpr int kAllModels = -1;

// All atoms of one name, element and residue name.
struct AtomGroup {
  std::string residue, atom;  // as in the file; empty: the file gives none
  Element element = kUnknownElement;
  friend bool operator==(const AtomGroup&, const AtomGroup&) = default;
};

// A radius that a user gave to such atoms.
struct RadiusOverride {
  AtomGroup atoms;
  std::int32_t microangstrom = 0;  // > 0
  friend bool operator==(const RadiusOverride&, const RadiusOverride&) = default;
};

struct BallOptions {
  RadiiSet radii = RadiiSet::automatic;
  std::shared_ptr<const UserRadii> user_radii;  // for RadiiSet::user
  int model = 0;  // index into Molecule::models, or kAllModels for all at once
  AltlocRule altlocs = AltlocRule::best;
  HydrogenRule hydrogens = HydrogenRule::automatic;
  bool polymers = true;
  bool ligands = true;
  bool ions = true;
  bool waters = false;
  bool dummies = false;                     // markers without matter (OPM's membrane planes)
  std::vector<std::string> chains;          // only these; empty: all
  std::vector<std::string> without_chains;  // except these
  std::string selection;  // as in core/selection/selection_expression.hpp; blank: all
  std::vector<RadiusOverride> overrides;  // these replace the radii of every set
  std::vector<std::string> treated;       // kinds of residues set by hand, see treatments.hpp
  friend bool operator==(const BallOptions&, const BallOptions&) = default;
};

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of van der Waals radii with their sources, and the look-up of an atom's radius.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/radii/radii_choice.hpp"

namespace alphascope {

struct Atom;
struct Molecule;

struct RadiiSetInfo {
  RadiiSet set;
  std::string_view id;    // for the command line and session files: "bondi"
  std::string_view name;  // for people: "Bondi"
  std::string_view citation;
  bool united_atom;  // whether radii of heavy atoms include their hydrogens
};

const RadiiSetInfo& radii_set_info(RadiiSet set);
std::span<const RadiiSetInfo> all_radii_sets();
// Finds a set by its id, in any case. Returns false if there is none.
bool find_radii_set(std::string_view id, RadiiSet& set);

// Radii of a user's table (core/read/user_radii.hpp), in 10^-6 Å.
struct UserRadii {
  std::string source;  // file name, for the report
  std::string sha256;  // of that file; empty if the table is not from a file
  std::map<std::string, std::int32_t> by_atom;  // keys "ALA CB", or "* CB" for any residue
  std::map<Element, std::int32_t> by_element;
};

// AssignedRadius::source of atoms that the set knows only by their element, such as a ligand's.
inline constexpr std::string_view kTypicalValueSource = "the set's typical value for the element";

struct AssignedRadius {
  std::int32_t microangstrom = 0;  // > 0
  // The set has no value, so the radius is the element's from elsewhere, or a default
  bool guessed = false;
  std::string_view source;  // source of a guess, such as "Bondi 1964"; static text
};

// The radius of an atom of unknown element (Å).
inline constexpr double kUnknownRadiusAngstrom = 1.8;

// Looks up radii and remembers them by names of residue and atom.
class RadiiLookup {
 public:
  // `user` is needed only for RadiiSet::user. `set` must be neither automatic nor file.
  RadiiLookup(const Molecule& molecule, RadiiSet set, std::shared_ptr<const UserRadii> user);
  // The radius of Molecule::atoms[atom]. Fastest in the order of the atoms.
  AssignedRadius radius(std::size_t atom);

 private:
  // All inputs of a radius. Kind and element mostly follow from the names, but not always: a ligand
  // may be called ALA.
  struct Key {
    NameId residue, name;
    Element element;
    ResidueKind kind;
    AmberForm form;  // of the residue, for AMBER; else 0
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  AssignedRadius find(const Atom& atom, AmberForm form) const;
  AmberForm form_around(std::size_t atom);

  const Molecule& molecule_;
  RadiiSet set_;
  std::shared_ptr<const UserRadii> user_;
  std::unordered_map<Key, AssignedRadius, Hash> known_;
  // Range of the atoms to which residue_form_ belongs.
  std::size_t residue_begin_ = 0, residue_end_ = 0;
  AmberForm residue_form_ = 0;
};

}  // namespace alphascope

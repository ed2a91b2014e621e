// Sets of van der Waals radii, each with its source, and finding an atom's radius in one.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "core/molecule/molecule.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/radii/radii_choice.hpp"

namespace alphascope {

struct RadiiSetInfo {
  RadiiSet set;
  std::string_view id;    // "bondi": for the command line and for session files
  std::string_view name;  // "Bondi"
  std::string_view citation;
  bool united_atom;  // heavy atoms contain their hydrogens
};

const RadiiSetInfo& radii_set_info(RadiiSet set);
std::span<const RadiiSetInfo> all_radii_sets();
// By id, in any case. False when there is none of that name.
bool find_radii_set(std::string_view id, RadiiSet& set);

// Radii of a table written by the user (core/read/user_radii.hpp), in 10^-6 Å.
struct UserRadii {
  std::string source;                           // file name, for the report
  std::string sha256;                           // of that file; empty when it was no file
  std::map<std::string, std::int32_t> by_atom;  // "ALA CB"; "* CB" for any residue
  std::map<Element, std::int32_t> by_element;
};

// AssignedRadius::source of atoms that the set knows by their element only, such as a ligand's.
inline constexpr std::string_view kTypicalOfTheSet = "the set's typical value for the element";

struct AssignedRadius {
  std::int32_t microangstrom = 0;  // > 0
  bool guessed = false;     // the set has no value: the element's from elsewhere, or a default
  std::string_view source;  // of a guess: "Bondi 1964"; static text
};

// What an atom of unknown element gets.
inline constexpr double kUnknownRadiusAngstrom = 1.8;

// Looks radii up, remembering the answer for each pair of residue and atom name.
class RadiiLookup {
 public:
  // user is needed for RadiiSet::user only. set is neither automatic nor file.
  RadiiLookup(const Molecule& molecule, RadiiSet set, std::shared_ptr<const UserRadii> user);
  // Of Molecule::atoms[atom]; quickest when asked in the order of the atoms.
  AssignedRadius radius(std::size_t atom);

 private:
  // All that a radius depends on. Kind and element vary little for one pair of names, but they may:
  // a ligand called ALA.
  struct Key {
    NameId residue, name;
    Element element;
    AtomKind kind;
    AmberForm form;  // of the residue; 0 but for AMBER
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
  std::size_t residue_begin_ = 0, residue_end_ = 0;  // of the residue of residue_form_
  AmberForm residue_form_ = 0;
};

}  // namespace alphascope

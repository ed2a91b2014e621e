// AMBER's van der Waals radii R* (parm99) of proteins, nucleic acids, their caps, water and ions,
// for RadiiSet::amber. AMBER types an atom by what it is bound to, which names do not always tell:
// a few other atoms of its residue do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/molecule/molecule.hpp"

namespace alphascope {

// What a residue's atoms tell of one another; bits of an AmberForm.
enum AmberFormBit : std::uint16_t {
  kAmberNTerminus = 1,     // a charged one: N has a hydrogen more than in the chain
  kAmberRibose = 2,        // there is an O2'
  kAmberCharmmRibose = 4,  // H2'' is the one on C2', H2' the one on O2'
  kAmberMethylamide = 8,   // CHARMM's cap, whose atoms are in the last residue
  kAmberHydroxylD1 = 16,   // of an acid: OD1 or OE1 has a hydrogen
  kAmberHydroxylD2 = 32,   // OD2 or OE2
  kAmberHydroxylOxt = 64,  // OXT
  kAmberHydroxylO5 = 128,  // O5'
  kAmberHydroxylO3 = 256,  // O3'
  kAmberPeptide = 512,     // of no known name, but with N, CA, C and O
};
using AmberForm = std::uint16_t;

// The form of a residue that has these atoms: add them all, then ask. The name must live as long.
class AmberFormFinder {
 public:
  explicit AmberFormFinder(std::string_view residue);
  void add(std::string_view atom);
  AmberForm form() const;

 private:
  std::string_view amino_acid_;
  char base_;
  AmberForm found_ = 0;
  std::uint32_t on_nitrogen_ = 0, in_backbone_ = 0;  // a bit for each name: locations count once
  bool second_on_c2_ = false, on_o2_ = false;
};

struct AmberRadius {
  int milliangstrom = 0;  // 0 when AMBER has no value for the element
  bool typed = false;     // else the element's typical value, the atom's type being unknown
};

AmberRadius amber_radius(std::string_view residue, std::string_view atom, AmberForm form,
                         Element element, AtomKind kind);

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// AMBER's van der Waals radii R* (parm99) of proteins, nucleic acids, their caps, water and ions,
// for RadiiSet::amber. AMBER types an atom by its bonds, which names do not always tell. A few
// other atoms of its residue do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/molecule/element.hpp"
#include "core/molecule/residue_kind.hpp"

namespace alphascope {

// Facts about a residue that follow from its atoms' names; bits of an AmberForm.
enum AmberFormBit : std::uint16_t {
  kAmberNTerminus = 1,     // charged N-terminus: N has one hydrogen more than within a chain
  kAmberRibose = 2,        // it has an O2'
  kAmberCharmmRibose = 4,  // H2'' is on C2' and H2' is on O2'
  kAmberMethylamide = 8,   // CHARMM's cap, whose atoms are listed in the last residue
  kAmberHydroxylD1 = 16,   // an acid with a hydrogen on OD1 or OE1
  kAmberHydroxylD2 = 32,   // on OD2 or OE2
  kAmberHydroxylOxt = 64,  // on OXT
  kAmberHydroxylO5 = 128,  // on O5'
  kAmberHydroxylO3 = 256,  // on O3'
  kAmberPeptide = 512,     // unknown name, but atoms N, CA, C and O
};
using AmberForm = std::uint16_t;

// Finds the form of a residue. add() must be called for all atoms before form(). The residue name
// must outlive this object.
class AmberFormFinder {
 public:
  explicit AmberFormFinder(std::string_view residue);
  void add(std::string_view atom);
  AmberForm form() const;

 private:
  std::string_view amino_acid_;
  char base_;
  AmberForm found_ = 0;
  // A bit for each name, so that alternative locations count once.
  std::uint32_t on_nitrogen_ = 0, in_backbone_ = 0;
  bool second_on_c2_ = false, on_o2_ = false;
};

struct AmberRadius {
  int milliangstrom = 0;  // 0: AMBER has no value for the element
  // False: the atom's type is unknown, and the radius is the element's typical value
  bool typed = false;
};

AmberRadius amber_radius(std::string_view residue, std::string_view atom, AmberForm form,
                         Element element, ResidueKind kind);

}  // namespace alphascope

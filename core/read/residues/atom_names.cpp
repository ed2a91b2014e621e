// SPDX-License-Identifier: GPL-3.0-or-later
// Guesses elements from atom names, and families of residues from residue names.
#include "core/read/residues/atom_names.hpp"

#include <algorithm>
#include <gemmi/resinfo.hpp>  // find_tabulated_residue

#include "core/read/residues/ion_names.hpp"
#include "core/read/residues/virtual_sites.hpp"
#include "core/text/letter_case.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

// Names of simulation packages that are not in the PDB's own dictionary.
constexpr std::string_view kWaters[] = {"WAT", "SOL",   "TIP", "TIP2", "TIP3", "TIP4",
                                        "TP3", "TIP3P", "SPC", "SPCE", "H2O",  "OH2"};

constexpr std::string_view kBiopolymers[] = {
    "HID", "HIE", "HIP", "HSD", "HSE", "HSP", "CYX", "CYM", "ASH", "GLH", "LYN", "ARN", "ACE",
    "NME", "NMA", "FOR", "NH2", "NHE", "ADE", "GUA", "CYT", "THY", "URA", "DA5", "DA3", "DC5",
    "DC3", "DG5", "DG3", "DT5", "DT3", "RA",  "RC",  "RG",  "RU",  "A5",  "A3",  "C5",  "C3",
    "G5",  "G3",  "U5",  "U3",  "RA5", "RA3", "RC5", "RC3", "RG5", "RG3", "RU5", "RU3", "T"};

template <std::size_t N>
bool contains(const std::string_view (&list)[N], std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

// The family of a residue that is no ion, even if its name is an ion's.
ResidueFamily family_without_ions(std::string_view name) {
  if (name == "DUM") return ResidueFamily::dummy;
  const gemmi::ResidueInfo& info = gemmi::find_tabulated_residue(std::string(name));
  if (info.is_water() || contains(kWaters, name)) return ResidueFamily::water;
  if (info.is_amino_acid() || info.is_nucleic_acid() || contains(kBiopolymers, name)) {
    return ResidueFamily::biopolymer;
  }
  return info.found() ? ResidueFamily::ligand : ResidueFamily::unknown;
}

// CHARMM's names of ions that no atom of a ligand has. CAL and CAD are left out: many ligands have
// carbons of these names.
constexpr std::string_view kNoLigandAtoms[] = {"SOD", "POT", "CLA", "CES", "RUB", "LIT"};

// True for "CA", "HG" and "NE". A letter for a position along a chain follows one of C H N O P S.
bool has_position_letter(std::string_view name) {
  constexpr std::string_view kFirst = "CHNOPS", kPosition = "ABGDEZHX";
  return name.size() > 1 && kFirst.find(name[0]) != std::string_view::npos &&
         kPosition.find(name[1]) != std::string_view::npos;
}

// Symbols of rare elements. A name that begins with one nearly always means a light atom. "HO",
// "CS", "CN" and "NP" of ligands are H, C, C and N. Ions of rare elements are found before.
bool is_rare(std::string_view symbol, Element element) {
  constexpr std::string_view kRare[] = {"HE", "HF", "HO", "CE", "CS", "NB", "ND",
                                        "NE", "PM", "PR", "PA", "PO", "SC", "SM"};
  constexpr Element kUranium = 92;
  return element > kUranium || contains(kRare, symbol);
}

// True when the symbol in a name has one letter, for names that allow one or two.
bool has_one_letter(const AtomNaming& naming, std::string_view letters) {
  const std::string_view two = letters.substr(0, 2);
  // Selenium is the only two-letter element of ordinary residues (MSE, SEC).
  if (two == "SE") return false;
  if (naming.family == ResidueFamily::biopolymer || naming.family == ResidueFamily::water) {
    return true;
  }
  if (naming.place == NamePlace::second_column) {
    // Programs that begin every name in column 14 mean these elements. No light atom has these
    // names.
    constexpr std::string_view kHeavy[] = {"CL", "BR", "FE", "SI", "CU", "PT"};
    return letters.size() > 2 || !contains(kHeavy, two);
  }
  if (naming.atom.size() >= 4 && naming.atom[0] == 'H') return true;
  // By the rule of the columns, "CA  " of a HETATM is calcium. "CAA " is never calcium.
  return has_position_letter(letters) &&
         !(naming.place == NamePlace::first_column && naming.hetero && letters.size() == 2);
}

}  // namespace

ResidueFamily residue_family(std::string_view name) {
  const ResidueFamily family = family_without_ions(name);
  const bool ligand = family == ResidueFamily::ligand || family == ResidueFamily::unknown;
  const bool ion = ligand && (is_any_ion(name) || ion_of_residue(name) != kUnknownElement);
  return ion ? ResidueFamily::ion : family;
}

ResidueKind residue_kind(ResidueFamily family, bool hetero) {
  switch (family) {
    case ResidueFamily::water:
      return ResidueKind::water;
    case ResidueFamily::ion:
      return ResidueKind::ion;
    case ResidueFamily::dummy:
      return ResidueKind::dummy;
    case ResidueFamily::biopolymer:
      return ResidueKind::polymer;
    case ResidueFamily::ligand:
      return ResidueKind::ligand;
    case ResidueFamily::unknown:
      break;
  }
  return hetero ? ResidueKind::ligand : ResidueKind::polymer;
}

NamePlace place_of(std::string_view field) {
  const std::string_view name = trimmed(field);
  // A name of four letters fills all columns.
  if (name.empty() || name.size() >= 4) return NamePlace::free;
  return is_blank(field.front()) ? NamePlace::second_column : NamePlace::first_column;
}

Element guess_element(const AtomNaming& naming) {
  if (naming.family == ResidueFamily::ion) {
    const Element ion = ion_element(naming.residue, naming.atom);
    if (ion != kUnknownElement) return ion;
  }
  const bool known =
      naming.family == ResidueFamily::biopolymer || naming.family == ResidueFamily::water;
  if (!known && contains(kNoLigandAtoms, naming.atom)) return ion_element(naming.atom, naming.atom);
  const Element charged = known ? kUnknownElement : charged_ion(naming.atom);
  if (charged != kUnknownElement) return charged;
  // Covers krypton in KR and antimony in SB. They are no ions, but also alone in their residues.
  if (!known && naming.atom == naming.residue && naming.atom.size() == 2) {
    const Element alone = element_from_symbol(naming.atom);
    if (alone != kUnknownElement) return alone;
  }
  std::string_view name = naming.atom;
  while (!name.empty() && !is_letter(name.front())) name.remove_prefix(1);
  std::size_t letters = 0;
  while (letters < name.size() && is_letter(name[letters])) ++letters;
  const std::string upper = upper_case(name.substr(0, letters));
  const std::string_view symbol = std::string_view(upper).substr(0, 2);
  // Names that begin with T mean other things. Tritium is taken only where a file states it.
  const Element one =
      symbol.starts_with('T') ? kUnknownElement : element_from_symbol(symbol.substr(0, 1));
  const Element two = symbol.size() == 2 ? element_from_symbol(symbol) : kUnknownElement;
  if (two == kUnknownElement) return one;
  if (one == kUnknownElement) return two;
  return is_rare(symbol, two) || has_one_letter(naming, upper) ? one : two;
}

ResidueFamily AtomGuesser::family_of(NameId residue_name, const NameTable& names) {
  if (residue_name >= families_.size()) families_.resize(names.size());
  std::optional<ResidueFamily>& family = families_[residue_name];
  if (!family) family = residue_family(names.text(residue_name));
  return *family;
}

ResidueFamily AtomGuesser::identify(Atom& atom, std::optional<Element> stated, NamePlace place,
                                    const NameTable& names) {
  AtomNaming naming{names.text(atom.residue_name), names.text(atom.name),
                    family_of(atom.residue_name, names), place, atom.hetero};
  // Iodide in its own residue I. Elsewhere I is inosine.
  if (atom.name == atom.residue_name && naming.family == ResidueFamily::biopolymer &&
      ion_element(naming.residue, naming.atom) != kUnknownElement) {
    naming.family = ResidueFamily::ion;
  }
  atom.element = stated.value_or(kUnknownElement);
  if (naming.family == ResidueFamily::ion) {
    const Element ion = ion_element(naming.residue, naming.atom);
    const bool is_ion =
        ion == kUnknownElement
            ? stated && *stated != kUnknownElement && *stated == ion_of_residue(naming.residue)
            : !stated || *stated == ion || *stated == kUnknownElement;
    if (!is_ion) naming.family = family_without_ions(naming.residue);
  }
  if (stated) return naming.family;
  atom.element = guess_element(naming);
  // Names in biopolymers and waters are unambiguous.
  atom.element_guessed =
      naming.family != ResidueFamily::biopolymer && naming.family != ResidueFamily::water;
  ++guessed_;
  return naming.family;
}

ResidueFamily AtomGuesser::identify(Atom& atom, const StatedElement& stated, NamePlace place,
                                    const NameTable& names) {
  const AtomNaming naming{names.text(atom.residue_name), names.text(atom.name),
                          family_of(atom.residue_name, names), place, atom.hetero};
  if (is_virtual_site(naming, stated.what)) {
    atom.element = kUnknownElement;
    atom.element_guessed = false;
    return ResidueFamily::dummy;
  }
  std::optional<Element> element;
  if (stated.what == ElementStatement::element || stated.what == ElementStatement::placeholder) {
    element = stated.element;
  }
  misstated_ += stated.what == ElementStatement::other;
  return identify(atom, element, place, names);
}

void AtomGuesser::add_note(Molecule& molecule, std::string_view where_missing) const {
  if (misstated_ > 0) {
    molecule.notes.push_back("Atoms for which the file gives an invalid element: " +
                             std::to_string(misstated_) + "; their names are used instead");
  }
  if (guessed_ == 0) return;
  molecule.notes.push_back("Elements guessed from atom names, " + std::string(where_missing) +
                           ": " + std::to_string(guessed_) + " of " +
                           std::to_string(molecule.atoms.size()) + " atoms");
}

}  // namespace alphascope

#include "core/molecule/molecule.hpp"

namespace alphascope {

std::string atom_label(const Molecule& molecule, std::size_t index) {
  const Atom& atom = molecule.atoms[index];
  std::string label(molecule.text(atom.name));
  if (label.empty()) label = "atom " + std::to_string(index + 1);
  if (atom.altloc != ' ') label += std::string(" (") + atom.altloc + ")";
  if (atom.residue_name != 0 || atom.residue_number != 0) {
    label += ' ';
    label += molecule.text(atom.residue_name);
    label += ' ' + std::to_string(atom.residue_number);
    if (atom.insertion_code != ' ') label += atom.insertion_code;
  }
  if (atom.chain != 0) {
    label += ", chain ";
    label += molecule.text(atom.chain);
  }
  return label;
}

}  // namespace alphascope

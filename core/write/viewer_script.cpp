// SPDX-License-Identifier: GPL-3.0-or-later
// Writes scripts that show cavities or channels in ChimeraX and PyMOL.
#include "core/write/viewer_script.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "core/geometry/lattice_alpha.hpp"
#include "core/write/script_words.hpp"

namespace alphascope {
namespace {

bool is_copy(const ViewerScript& script, std::size_t atom) {
  return atom_source(*script.molecule, atom).copy != 0;
}

// --- ChimeraX

// Returns whether a name needs no quotes in ChimeraX's language.
bool is_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '\'';
  });
}

bool has_letter(const Atom& atom) {
  return std::isalnum(static_cast<unsigned char>(atom.insertion_code)) != 0;
}

// An atom specification such as "#1/A:87@NE2,CD2/A:91@CB"; empty if no atom can be named.
std::string chimerax_atoms(const ViewerScript& script, const std::vector<std::size_t>& atoms) {
  const Molecule& molecule = *script.molecule;
  std::string text;
  const Atom* last = nullptr;
  for (const std::size_t index : atoms) {
    const Atom& atom = molecule.atoms[index];
    const std::string_view chain = molecule.text(atom.chain), name = molecule.text(atom.name);
    if (is_copy(script, index) || !is_word(name) || !(chain.empty() || is_word(chain)) ||
        !(atom.insertion_code == ' ' || has_letter(atom))) {
      continue;
    }
    if (last && same_residue_number(*last, atom)) {
      text += "," + std::string(name);
    } else {
      text += (chain.empty() ? "" : "/" + std::string(chain)) + ":" +
              std::to_string(atom.residue_number);
      if (has_letter(atom)) text += atom.insertion_code;
      text += "@" + std::string(name);
    }
    last = &atom;
  }
  return text.empty() ? text : "#1" + text;
}

// --- PyMOL

// Selects atoms by their serial numbers in the file, up to 100 per line.
std::string pymol_selection(const ViewerScript& script, const ScriptCavity& cavity) {
  const std::string name = script.what + "_" + std::to_string(cavity.number);
  std::vector<std::int32_t> serials;
  for (const std::size_t atom : cavity.lining) {
    const std::int32_t serial = script.molecule->atoms[atom].serial;
    if (serial != 0 && !is_copy(script, atom)) serials.push_back(serial);
  }
  if (serials.empty()) return "";
  constexpr std::size_t kInALine = 100;
  std::string text = "cmd.select('" + name + "', 'none')\n";
  for (std::size_t n = 0; n < serials.size(); ++n) {
    text +=
        n % kInALine == 0 ? "cmd.select('" + name + "', '" + name + " or (molecule and id " : "+";
    text += std::to_string(serials[n]);
    if (n % kInALine == kInALine - 1 || n + 1 == serials.size()) text += ")')\n";
  }
  return text + "cmd.color('" + hex_colour(cavity.colour, "0x") + "', '" + name + "')\n" +
         "cmd.show('sticks', '" + name + "')\n";
}

}  // namespace

std::string chimerax_script(const ViewerScript& script) {
  std::string text = script_comments(script.header) + "open " + chimerax_name(script.file) +
                     " id 1\nhide #1 atoms\ncartoon #1\ncolor #1 #c8c8c8\n";
  for (const ScriptCavity& cavity : script.cavities) {
    const std::string atoms = chimerax_atoms(script, cavity.lining);
    if (atoms.empty()) continue;
    const std::string name = script.what + std::to_string(cavity.number);
    text += "name " + name + " " + atoms + "\nshow " + name + " atoms\nstyle " + name +
            " stick\ncolor " + name + " " + hex_colour(cavity.colour, "#") + "\n";
  }
  if (!script.spheres.empty()) {
    // ChimeraX reads PQR files with its format "pdb"; there is no format "pqr".
    text += "open " + chimerax_name(script.spheres) +
            " format pdb id 2\nstyle #2 sphere\nshow #2 atoms\ntransparency #2 50 target a\n";
    for (const ScriptCavity& cavity : script.cavities) {
      text +=
          "color #2:" + std::to_string(cavity.number) + " " + hex_colour(cavity.colour, "#") + "\n";
    }
  }
  if (!script.surface.empty()) text += "open " + chimerax_name(script.surface) + " id 3\n";
  return text + "view\n";
}

std::string pymol_script(const ViewerScript& script) {
  // Inside "python" a comment reaches to the end of its line, even with a semicolon in it.
  std::string text = "python\n" + script_comments(script.header) +
                     "import os\nfrom pymol import cmd\n" + pymol_load(script.file, "molecule") +
                     "cmd.hide('everything', 'molecule')\ncmd.show('cartoon', 'molecule')\n"
                     "cmd.color('gray80', 'molecule')\n";
  for (const ScriptCavity& cavity : script.cavities) text += pymol_selection(script, cavity);
  if (!script.spheres.empty()) {
    // PyMOL reads the radii of a PQR file as electrostatic radii.
    text += pymol_load(script.spheres, "spheres") +
            "cmd.alter('spheres', 'vdw=elec_radius')\ncmd.rebuild()\n"
            "cmd.hide('everything', 'spheres')\ncmd.show('spheres', 'spheres')\n"
            "cmd.set('sphere_transparency', 0.5, 'spheres')\n";
    for (const ScriptCavity& cavity : script.cavities) {
      text += "cmd.color('" + hex_colour(cavity.colour, "0x") + "', 'spheres and resi " +
              std::to_string(cavity.number) + "')\n";
    }
  }
  return text + "cmd.deselect()\ncmd.zoom('molecule')\npython end\n";
}

}  // namespace alphascope

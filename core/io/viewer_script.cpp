#include "core/io/viewer_script.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "core/molecule/printable.hpp"

namespace alphascope {
namespace {

std::string comments(const ViewerScript& script) {
  std::string text;
  for (const auto& [key, value] : script.header) {
    text += "# " + key + " " + printable(value) + "\n";
  }
  return text;
}

std::string hex(const std::array<std::uint8_t, 3>& colour, const char* before) {
  char text[16];
  std::snprintf(text, sizeof text, "%s%02x%02x%02x", before, colour[0], colour[1], colour[2]);
  return text;
}

bool is_copy(const ViewerScript& script, std::size_t atom) {
  return atom_source(*script.molecule, atom).copy != 0;
}

// --- ChimeraX

std::string chimerax_name(const std::filesystem::path& path) {
  const std::string name = path.string();
  const bool control = std::any_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  const bool single = name.find('\'') != name.npos, both = single && name.find('"') != name.npos;
  if (control || both || name.find('\\') != name.npos) {
    throw std::invalid_argument(
        "A ChimeraX script cannot name the file " + printable(name) +
        ": its name has a control character, a backslash or both kinds of quotes. Rename it, or "
        "write a PyMOL script (.pml).");
  }
  const char quote = single ? '"' : '\'';
  return quote + name + quote;
}

// What needs no quotes in ChimeraX's language.
bool is_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '\'';
  });
}

// "#1/A:87@NE2,CD2/A:91@CB"; "" when no atom can be named.
std::string chimerax_atoms(const ViewerScript& script, const std::vector<std::size_t>& atoms) {
  const Molecule& molecule = *script.molecule;
  std::string text;
  const Atom* last = nullptr;
  for (const std::size_t index : atoms) {
    const Atom& atom = molecule.atoms[index];
    const std::string_view chain = molecule.text(atom.chain), name = molecule.text(atom.name);
    if (is_copy(script, index) || !is_word(name) || !(chain.empty() || is_word(chain))) continue;
    if (last && same_residue_number(*last, atom)) {
      text += "," + std::string(name);
    } else {
      text += (chain.empty() ? "" : "/" + std::string(chain)) + ":" +
              std::to_string(atom.residue_number);
      if (atom.insertion_code != ' ') text += atom.insertion_code;
      text += "@" + std::string(name);
    }
    last = &atom;
  }
  return text.empty() ? text : "#1" + text;
}

// --- PyMOL

// Python's literal of these bytes.
std::string bytes_literal(const std::string& bytes) {
  std::string text = "b'";
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f && c != '\'' && c != '\\') {
      text += c;
    } else {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\x%02x", byte);
      text += escape;
    }
  }
  return text + "'";
}

std::string pymol_load(const std::filesystem::path& path, const char* object) {
  return "cmd.load(os.fsdecode(" + bytes_literal(path.string()) + "), '" + object + "')\n";
}

// Atoms by the serial numbers of the file, some in a line.
std::string pymol_selection(const ViewerScript& script, const ScriptCavity& cavity) {
  const std::string name = "cavity_" + std::to_string(cavity.number);
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
  return text + "cmd.color('" + hex(cavity.colour, "0x") + "', '" + name + "')\n" +
         "cmd.show('sticks', '" + name + "')\n";
}

}  // namespace

std::string chimerax_script(const ViewerScript& script) {
  std::string text = comments(script) + "open " + chimerax_name(script.file) +
                     " id 1\nhide #1 atoms\ncartoon #1\ncolor #1 #c8c8c8\n";
  for (const ScriptCavity& cavity : script.cavities) {
    const std::string atoms = chimerax_atoms(script, cavity.lining);
    if (atoms.empty()) continue;
    const std::string name = "cavity" + std::to_string(cavity.number);
    text += "name " + name + " " + atoms + "\nshow " + name + " atoms\nstyle " + name +
            " stick\ncolor " + name + " " + hex(cavity.colour, "#") + "\n";
  }
  if (!script.spheres.empty()) {
    // Its format "pdb" is that of PQR files, too; there is no other of that name.
    text += "open " + chimerax_name(script.spheres) +
            " format pdb id 2\nstyle #2 sphere\nshow #2 atoms\ntransparency #2 50 target a\n";
    for (const ScriptCavity& cavity : script.cavities) {
      text += "color #2:" + std::to_string(cavity.number) + " " + hex(cavity.colour, "#") + "\n";
    }
  }
  if (!script.surface.empty()) text += "open " + chimerax_name(script.surface) + " id 3\n";
  return text + "view\n";
}

std::string pymol_script(const ViewerScript& script) {
  std::string text = comments(script) + "python\nimport os\nfrom pymol import cmd\n" +
                     pymol_load(script.file, "molecule") +
                     "cmd.hide('everything', 'molecule')\ncmd.show('cartoon', 'molecule')\n"
                     "cmd.color('gray80', 'molecule')\n";
  for (const ScriptCavity& cavity : script.cavities) text += pymol_selection(script, cavity);
  if (!script.spheres.empty()) {
    // PyMOL keeps the radii of a PQR file as those of electrostatics.
    text += pymol_load(script.spheres, "spheres") +
            "cmd.alter('spheres', 'vdw=elec_radius')\ncmd.rebuild()\n"
            "cmd.hide('everything', 'spheres')\ncmd.show('spheres', 'spheres')\n"
            "cmd.set('sphere_transparency', 0.5, 'spheres')\n";
    for (const ScriptCavity& cavity : script.cavities) {
      text += "cmd.color('" + hex(cavity.colour, "0x") + "', 'spheres and resi " +
              std::to_string(cavity.number) + "')\n";
    }
  }
  return text + "cmd.deselect()\ncmd.zoom('molecule')\npython end\n";
}

}  // namespace alphascope

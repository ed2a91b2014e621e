// SPDX-License-Identifier: GPL-3.0-or-later
// One structure as programs write it in PDB, PDBQT, PQR and mmCIF, for tests that such twins agree.
// It is the sample of residues, with a cage beside it that holds a void.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/letter_case.hpp"
#include "tests/core/read/residue_dialects.hpp"

namespace alphascope {

inline constexpr double kCageSide = 4.2;  // Å
inline constexpr const char* kTwinEntities =
    "loop_\n_entity.id\n_entity.type\n1 polymer\n2 polymer\n3 non-polymer\n4 non-polymer\n"
    "5 non-polymer\n6 water\n7 polymer\n";

// Adds the CA of eight alanines at the corners of a cube, far from the rest, each beside the
// previous one. The waters stay last.
inline std::vector<SampleAtom> twin_sample() {
  constexpr int kCorners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 1, 1}, {1, 1, 1}, {1, 0, 1}, {0, 0, 1}};
  std::vector<SampleAtom> sample = residue_sample(), cage;
  for (int k = 0; k < 8; ++k) {
    const auto& [x, y, z] = kCorners[k];
    cage.push_back({"CA", "C", "ALA", 'C', k + 1, kCageSide * x, kCageSide * y - 40, kCageSide * z,
                    false, ResidueKind::polymer, "7"});
  }
  const auto first_of_others = std::find_if(sample.begin(), sample.end(), [](const SampleAtom& a) {
    return a.kind != ResidueKind::polymer;
  });
  sample.insert(first_of_others, cage.begin(), cage.end());
  return sample;
}

// The symbol as a program writes it: Zn for ZN.
inline std::string element_as_written(const SampleAtom& a, bool mixed_case = true) {
  std::string symbol = a.element;
  if (mixed_case && symbol.size() == 2) symbol[1] = lower_case(symbol).back();
  return symbol;
}

// The mmCIF of one program. Tags are without "_atom_site.".
struct CifProgram {
  std::vector<const char*> tags;
  const char* before = "";  // tables before the atoms
  const char* behind = "";
  const char* indent = "";  // before tags
  const char* between = " ";
  bool own_asym = true;  // each entity has a label_asym_id of its own
  bool entities = true;  // label_entity_id is given
  bool chain_as_entity = false;
  bool numbers_all = false;  // label_seq_id for every residue, else for polymers only
  bool mixed_case = false;   // Zn
  const char* b_factor = "10.00";
};

inline std::string cif_value(const SampleAtom& a, std::string_view tag, int serial,
                             const CifProgram& program) {
  const auto number = [](double x) { return text_of("%.3f", x); };
  const std::string asym = program.own_asym ? std::string("L") + a.entity : std::string(1, a.chain);
  const bool numbered = program.numbers_all || a.kind == ResidueKind::polymer;
  if (tag == "group_PDB") return a.hetero ? "HETATM" : "ATOM";
  if (tag == "id") return std::to_string(serial);
  if (tag == "type_symbol") return element_as_written(a, program.mixed_case);
  if (tag == "label_atom_id" || tag == "auth_atom_id") return quoted(a.name);
  if (tag == "label_comp_id" || tag == "auth_comp_id") return a.residue;
  if (tag == "label_asym_id") return asym;
  if (tag == "label_entity_id" && program.chain_as_entity) return std::to_string(a.chain - '@');
  if (tag == "label_entity_id") return program.entities ? a.entity : ".";
  if (tag == "label_seq_id") return numbered ? std::to_string(a.number) : ".";
  if (tag == "Cartn_x") return number(a.x);
  if (tag == "Cartn_y") return number(a.y);
  if (tag == "Cartn_z") return number(a.z);
  if (tag == "occupancy") return "1.00";
  if (tag == "B_iso_or_equiv") return program.b_factor;
  if (tag == "auth_asym_id") return std::string(1, a.chain);
  if (tag == "auth_seq_id") return std::to_string(a.number);
  if (tag == "pdbx_PDB_model_num") return "1";
  return tag == "label_alt_id" ? "." : "?";
}

inline std::string as_cif(const std::vector<SampleAtom>& sample, const CifProgram& program) {
  std::string text = std::string("data_TWIN\n#\n") + program.before + "loop_\n";
  for (const char* tag : program.tags) {
    text += std::string(program.indent) + "_atom_site." + tag + "\n";
  }
  int serial = 0;
  for (const SampleAtom& a : sample) {
    ++serial;
    for (const char* tag : program.tags) {
      text += cif_value(a, tag, serial, program) + program.between;
    }
    text += "\n";
  }
  return text + program.behind;
}

// AutoDock's charges and types behind the columns of PDB. Without `hetatm` all atoms are ATOM, as
// some programs write.
inline std::string as_pdbqt(const std::vector<SampleAtom>& sample, bool hetatm = true) {
  std::string text = "REMARK  a receptor\n";
  const SampleAtom* before = nullptr;
  int serial = 0;
  for (const SampleAtom& a : sample) {
    if (ends_chain(before, a)) text += "TER\n";
    before = &a;
    const std::string element = element_as_written(a);
    const std::string name = (element.size() == 2 ? "" : " ") + std::string(a.name);
    const bool acceptor = element == "O" || a.residue == std::string_view("NH2");
    text += text_of("%-6s%5d %-4s %3s %c%4d    %8.3f%8.3f%8.3f  1.00 10.00    %+6.3f %-2s\n",
                    a.hetero && hetatm ? "HETATM" : "ATOM", ++serial, name.c_str(), a.residue,
                    a.chain, a.number, a.x, a.y, a.z, -0.25,
                    acceptor ? (element + "A").c_str() : element.c_str());
  }
  return text + "TER\n";
}

// Open Babel's columns: eight digits of a charge, and the element last.
inline std::string as_pqr_of_open_babel(const std::vector<SampleAtom>& sample) {
  std::string text = "COMPND    TWIN \nAUTHOR    GENERATED BY OPEN BABEL 3.1.1\n";
  int serial = 0;
  for (const SampleAtom& a : sample) {
    text += text_of("%-6s%5d %-4s %-3s %c%4d    %8.3f%8.3f%8.3f %11.8f%8.3f %2s  \n",
                    a.hetero ? "HETATM" : "ATOM", ++serial,
                    ((a.element[1] ? "" : " ") + std::string(a.name)).c_str(), a.residue, a.chain,
                    a.number, a.x, a.y, a.z, -0.03390870, 1.7, element_as_written(a).c_str());
  }
  return text + "MASTER        0    0    0    0    0    0    0    0   30    0   30    0\nEND\n";
}

// PDB2PQR leaves chains out unless told to keep them.
inline std::string as_pqr_without_chains(const std::vector<SampleAtom>& sample) {
  std::string text = "REMARK   1 PQR file generated by PDB2PQR\n";
  const SampleAtom* before = nullptr;
  int serial = 0;
  for (const SampleAtom& a : sample) {
    if (ends_chain(before, a)) text += "TER\n";
    before = &a;
    text += text_of("%-6s%5d %-4s %3s  %4d    %8.3f%8.3f%8.3f %7.4f %6.4f\n",
                    a.hetero ? "HETATM" : "ATOM", ++serial, a.name, a.residue, a.number, a.x, a.y,
                    a.z, -0.25, 1.5);
  }
  return text + "TER\nEND\n";
}

}  // namespace alphascope

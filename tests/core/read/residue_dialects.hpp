// SPDX-License-Identifier: GPL-3.0-or-later
// One sample of residues as different programs write it. Tests show with it that no dialect changes
// what a residue is. Places are made up but possible.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "core/molecule/molecule.hpp"

namespace alphascope {

struct SampleAtom {
  const char *name, *element, *residue;
  char chain;
  int number;
  double x, y, z;
  bool hetero = false;
  ResidueKind kind = ResidueKind::polymer;  // its expected kind
  const char* entity = "1";                 // an id in sample_entities()
};

inline const char* sample_entities() {
  return "loop_\n_entity.id\n_entity.type\n1 polymer\n2 polymer\n3 non-polymer\n4 non-polymer\n"
         "5 non-polymer\n6 water\n";
}

// Adds N, CA, C and O of the k-th residue of a chain along x. From C to the next N is 1.33 Å.
inline void add_amino_acid(std::vector<SampleAtom>& sample, const char* residue, char chain,
                           int number, double x, double y, bool hetero = false,
                           ResidueKind kind = ResidueKind::polymer, const char* entity = "1") {
  sample.push_back({"N", "N", residue, chain, number, x, y, 0, hetero, kind, entity});
  sample.push_back({"CA", "C", residue, chain, number, x + 1.2, y + 0.8, 0, hetero, kind, entity});
  sample.push_back({"C", "C", residue, chain, number, x + 2.47, y, 0, hetero, kind, entity});
  sample.push_back({"O", "O", residue, chain, number, x + 2.47, y - 1.2, 0, hetero, kind, entity});
}

// A cap, two amino acids with a modified one between them, two nucleotides. Then residues outside
// polymers: a ligand, a free glycine, zinc, and waters of a known and an unknown name.
inline std::vector<SampleAtom> residue_sample() {
  std::vector<SampleAtom> sample;
  sample.push_back({"C", "C", "ACE", 'A', 0, -1.33, 0, 0, true});
  sample.push_back({"O", "O", "ACE", 'A', 0, -1.33, 1.2, 0, true});
  add_amino_acid(sample, "GLY", 'A', 1, 0, 0);
  add_amino_acid(sample, "ZQ2", 'A', 2, 3.8, 0, true);
  add_amino_acid(sample, "ALA", 'A', 3, 7.6, 0);
  sample.push_back({"N", "N", "NH2", 'A', 4, 11.4, 0, 0, true});
  for (int k = 0; k < 2; ++k) {
    const char* base = k ? "DT" : "DA";
    const double x = 6.0 * k;
    const auto add = [&](const char* name, const char* element, double at, double z) {
      sample.push_back(
          {name, element, base, 'B', k + 1, x + at, 20, z, false, ResidueKind::polymer, "2"});
    };
    add("P", "P", 0, 0);
    add("O5'", "O", 1.6, 0);
    add("C4'", "C", 2.8, 0.8);
    add("C1'", "C", 2.8, 2.2);
    add("C3'", "C", 3.9, -0.2);
    add("O3'", "O", 4.6, 0.6);
  }
  sample.push_back({"C1", "C", "LQ9", 'A', 301, 0, 40, 0, true, ResidueKind::ligand, "3"});
  sample.push_back({"C2", "C", "LQ9", 'A', 301, 1.5, 40, 0, true, ResidueKind::ligand, "3"});
  sample.push_back({"O3", "O", "LQ9", 'A', 301, 2.7, 40, 0, true, ResidueKind::ligand, "3"});
  add_amino_acid(sample, "GLY", 'A', 302, 0, 50, true, ResidueKind::ligand, "5");
  sample.push_back({"ZN", "ZN", "ZN", 'A', 303, 0, 60, 0, true, ResidueKind::ion, "4"});
  sample.push_back({"O", "O", "HOH", 'A', 304, 0, 70, 0, true, ResidueKind::water, "6"});
  sample.push_back({"O", "O", "WQ3", 'A', 305, 0, 80, 0, true, ResidueKind::water, "6"});
  return sample;
}

template <class... Values>
std::string text_of(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

inline std::string quoted(const std::string& name) {
  return name.find('\'') == std::string::npos ? name : '"' + name + '"';
}

// Whether a TER record belongs before this atom, because a polymer ends there.
inline bool ends_chain(const SampleAtom* before, const SampleAtom& atom) {
  return before && before->kind == ResidueKind::polymer &&
         std::string_view(before->entity) != atom.entity;
}

inline std::string as_pdb(const std::vector<SampleAtom>& sample, bool with_ter = true) {
  std::string text;
  const SampleAtom* before = nullptr;
  int serial = 0;
  for (const SampleAtom& a : sample) {
    if (with_ter && ends_chain(before, a)) text += "TER\n";
    before = &a;
    const std::string name =
        std::string(a.element).size() == 2 ? a.name : std::string(" ") + a.name;
    text += text_of("%-6s%5d %-4s %3s %c%4d    %8.3f%8.3f%8.3f  1.00 10.00          %2s\n",
                    a.hetero ? "HETATM" : "ATOM", ++serial, name.c_str(), a.residue, a.chain,
                    a.number, a.x, a.y, a.z, a.element);
  }
  return text + "END\n";
}

inline std::string as_pqr(const std::vector<SampleAtom>& sample) {
  std::string text;
  int serial = 0;
  for (const SampleAtom& a : sample) {
    text += text_of("%s %d %s %s %c %d %.3f %.3f %.3f 0.0 1.5\n", a.hetero ? "HETATM" : "ATOM",
                    ++serial, a.name, a.residue, a.chain, a.number, a.x, a.y, a.z);
  }
  return text;
}

// Parts of mmCIF that programs leave out or fill in.
struct CifDialect {
  bool entities = false;          // the tables, and each atom's entity
  bool numbers_polymers = false;  // label_seq_id for polymers, "." for others
  bool numbers_all = false;
  bool group = true;   // ATOM or HETATM
  bool author = true;  // auth_asym_id, auth_seq_id
};

inline std::string as_mmcif(const std::vector<SampleAtom>& sample, const CifDialect& dialect) {
  std::string text = "data_TWIN\n";
  if (dialect.entities) text += sample_entities();
  text += "loop_\n";
  if (dialect.group) text += "_atom_site.group_PDB\n";
  for (const char* tag : {"id", "type_symbol", "label_atom_id", "label_comp_id", "label_asym_id",
                          "label_entity_id", "label_seq_id", "Cartn_x", "Cartn_y", "Cartn_z"}) {
    text += std::string("_atom_site.") + tag + "\n";
  }
  if (dialect.author) text += "_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n";
  int serial = 0;
  for (const SampleAtom& a : sample) {
    if (dialect.group) text += a.hetero ? "HETATM " : "ATOM ";
    // With entities, each one has a label_asym_id of its own.
    const std::string asym =
        dialect.entities ? std::string("L") + a.entity : std::string(1, a.chain);
    const bool numbered =
        dialect.numbers_all || (dialect.numbers_polymers && a.kind == ResidueKind::polymer);
    text +=
        text_of("%d %s %s %s %s %s %s %.3f %.3f %.3f", ++serial, a.element, quoted(a.name).c_str(),
                a.residue, asym.c_str(), dialect.entities ? a.entity : "?",
                numbered ? std::to_string(a.number).c_str() : ".", a.x, a.y, a.z);
    if (dialect.author) text += text_of(" %c %d", a.chain, a.number);
    text += "\n";
  }
  return text;
}

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// Plain data on the molecule, which the program fills and the panels show. Data on running work are
// in work_info.hpp, and data on the view in viewport_info.hpp.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/molecule/assembly.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/contents.hpp"

namespace alphascope {

struct ResidueGroups;
struct RadiusRow;  // radius_row.hpp

// A radius in use, and the radius to which its balls grow in the present request.
struct GrownRadius {
  std::string element;           // "C"; empty if the file does not name it
  double radius = 0, grown = 0;  // Å; grown is 0 if the ball is empty
  std::size_t balls = 0;         // with this element and radius
  std::string atoms = {};        // names of some atoms: "CA, CB, …"; may be empty
};

// Atoms left out for one reason: the reason with their number, "221 waters", and their names, "HOH
// 221".
struct DroppedRow {
  std::string text, detail;
};

struct MoleculeInfo {
  bool loaded = false;
  std::string name, folder, title, format;  // "4hhb.pdb.gz", "/data", "HAEMOGLOBIN…", "PDB"
  std::string summary;                      // one line: used, dropped and guessed atoms
  std::vector<std::string> notes;           // assumptions of the reader
  std::size_t balls = 0;
  std::vector<GrownRadius> radii;  // each pair of element and radius, most frequent first
  std::size_t dropped_atoms = 0;
  std::vector<DroppedRow> dropped;
  std::vector<RadiusRow> radius_rows;
  MoleculeContents contents;                      // of the whole molecule, all models
  std::shared_ptr<const ResidueGroups> residues;  // of the model in use; may be null
  std::uint64_t deposited_atoms = 0;              // in all models
  std::vector<AssemblyInfo> assemblies;
  std::vector<int> models;  // their numbers in the file
  bool has_file_radii = false;
  std::string sha256, radii_name, radii_citation;
  // Provenance of all numbers in full, for people and papers: "Lattice unit", "0.001 Å".
  std::vector<std::pair<std::string, std::string>> provenance;
  BallOptions options;  // the options that chose its balls
};

}  // namespace alphascope

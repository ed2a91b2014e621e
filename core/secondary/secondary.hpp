// SPDX-License-Identifier: GPL-3.0-or-later
// The secondary structure of a model: from the records of its file, or else from hydrogen bonds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/molecule/secondary_structure.hpp"
#include "core/run/cancel_token.hpp"
#include "core/secondary/backbone.hpp"

namespace alphascope {

enum class SecondarySource : std::uint8_t {
  none,           // there is no residue of a protein
  file,           // HELIX and SHEET, or struct_conf and struct_sheet_range
  hydrogen_bonds  // DSSP (dssp.hpp), for residues with N, CA, C and O
};

struct SecondaryModel {
  SecondarySource source = SecondarySource::none;
  // All copies of an assembly, each in the order of its atoms. Distances in the first copy decide
  // for all, so contacts between copies do not count.
  std::vector<BackboneResidue> residues;
  std::vector<SecondaryStructure> kinds;  // per residue
  // Runs of consecutive residues of one kind, by SecondaryStructure.
  std::array<std::size_t, kSecondaryStructures> runs{};
  std::size_t incomplete = 0;  // residues without N, C or O; coil unless the file says otherwise
  std::size_t crowded = 0;     // residues with too many others at one place (hydrogen_bonds.hpp)
};

enum class SecondaryChoice : std::uint8_t {
  automatic,      // the file's records if it has any for this model, else hydrogen bonds
  hydrogen_bonds  // whatever the file says
};

// Takes time linear in the atoms. Throws Cancelled.
SecondaryModel find_secondary(const Molecule& molecule, const ModelRange& model,
                              SecondaryChoice choice = SecondaryChoice::automatic,
                              const RunContext& context = {});

// The same for all models within these atoms, one after another. The numbers of runs are not set.
SecondaryModel find_secondary_of_models(const Molecule& molecule, const ModelRange& models,
                                        const RunContext& context = {});

// "2 helices (2 alpha), 2 strands; from the file's records". Empty without any residue.
std::string summary(const SecondaryModel& secondary);

// The identifiers of tables and JSON: "alpha_helix", "hydrogen_bonds".
const char* secondary_id(SecondaryStructure kind);
const char* secondary_source_id(SecondarySource source);

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// Ids of molecules in public archives, as people type them in place of a file.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace alphascope {

enum class Archive { pdb, alphafold };

struct MoleculeId {
  Archive archive = Archive::pdb;
  // Letters, digits and "_" only. PDB: four characters in upper case, or twelve in lower case that
  // begin with "pdb_". AlphaFold DB: the accession of UniProt in upper case.
  std::string id;
  std::string typed;          // for messages
  bool without_name = false;  // typed without the name of the archive, as "1crn"

  // "pdb:1CRN", "af:P69905".
  std::string text() const;
};

// A text that names an archive, but no id of it. what() is a sentence for the command line.
struct InvalidId : std::invalid_argument {
  InvalidId(const std::string& text, std::string broken_rule)
      : std::invalid_argument(text), rule(std::move(broken_rule)) {}
  std::string rule;  // sentences that say which ids are valid
};

// Reads "pdb:1CRN", "pdb:pdb_00001crn" and "af:P69905", in any case of letters. Without the name of
// the archive, only ids of the PDB are read: "1crn", "pdb_00001crn". Empty for any other text,
// which is the name of a file. Throws InvalidId if an archive is named, but the rest is not a valid
// id.
std::optional<MoleculeId> molecule_id(std::string_view typed);

// The same, but empty if there is a file, a folder or a link of this name.
std::optional<MoleculeId> molecule_id_unless_file(const std::filesystem::path& typed);

}  // namespace alphascope

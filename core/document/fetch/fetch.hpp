// SPDX-License-Identifier: GPL-3.0-or-later
// Fetches molecules by their id into the folder of fetched files (core/files/fetched_file.hpp).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/document/fetch/molecule_id.hpp"
#include "core/document/fetch/transfer.hpp"
#include "core/files/fetched_file.hpp"

namespace alphascope {

struct FetchOptions {
  std::filesystem::path folder;  // of fetched files; empty: there is none
  // "http://127.0.0.1:8080" or another loopback address, which takes the place of all servers.
  // Empty: the public servers.
  std::string base;
  bool offline = false;  // ask no server; use a file that was fetched before
  bool again = false;    // ask even if the file was fetched before
  int connect_milliseconds = 15'000;
  int stall_seconds = 20;
  std::string user_agent;
  Transfer get;
};

// Folder, base address and `offline` by the environment: XDG_CACHE_HOME, HOME,
// ALPHASCOPE_FETCH_BASE, ALPHASCOPE_OFFLINE. Throws std::invalid_argument if the base address is
// not a loopback address.
FetchOptions fetch_options_of_environment();

struct FetchedMolecule {
  std::filesystem::path file;
  FetchedFrom from;
};

// Returns the fetched file, which is whole and looks like an mmCIF file. Reports progress as
// "fetching pdb:1CRN". Throws ReadError if it cannot be fetched, WriteError if it cannot be kept,
// and Cancelled.
FetchedMolecule fetch_molecule(const MoleculeId& id, const FetchOptions& options,
                               const RunContext& context);

// The server that is asked for an id, with its scheme: "https://files.rcsb.org".
std::string server_for(const MoleculeId& id, const FetchOptions& options);

// The file of an id, if it was fetched before. Asks no server.
std::optional<FetchedMolecule> fetched_before(const MoleculeId& id, const FetchOptions& options);

// The id whose file has this path, by the address at the end of the path. The file need not exist,
// and its folder may be that of another user. Empty for all other paths.
std::optional<MoleculeId> id_of_fetched(const std::filesystem::path& file);

// Whether the address is of this computer: the host is localhost, 127.0.0.1 or [::1].
bool is_loopback(const std::string& address);

// Whether AlphaFold DB has the model of this accession under this name, in any version:
// "AF-P69905-F1-model_v6.cif".
bool is_name_of_model(std::string_view name, const std::string& accession);

// The address of the model in the answer of AlphaFold DB about an accession. `server` begins every
// address that is accepted: "https://alphafold.ebi.ac.uk". Throws std::invalid_argument that says
// what is wrong with the answer.
std::string address_of_model(const std::string& answer, const std::string& accession,
                             const std::string& server);

}  // namespace alphascope

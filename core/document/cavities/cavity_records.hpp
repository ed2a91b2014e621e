// SPDX-License-Identifier: GPL-3.0-or-later
// The cavities of a table as records for programs (docs/output-files.md), written by command line
// and window.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/cavity_identity/network_radius.hpp"
#include "core/document/cavities/known_cavities.hpp"
#include "core/document/export/record_source.hpp"
#include "core/document/settings/request.hpp"
#include "core/write/csv.hpp"

namespace alphascope {

// All facts that are reported on cavities. Vectors are indexed by rows of the table unless their
// comment states otherwise. Only `exact` may be null, if exact volumes are not wanted, and the
// results of the window alone.
struct CavityFacts : KnownCavities {
  RecordSource source;
  Request request;
  std::vector<std::string> differences;  // from CASTp's choices
  std::vector<std::size_t> exact_rank;   // 1: the largest clipped volume; empty without `exact`
  std::vector<std::size_t> rows;         // rows to report
  std::map<std::size_t, NetworkEnd> network_ends;  // of rows that are networks, if known

  // The source with the lattice of the computation.
  RecordSource computed_source() const;
  // Null if it is unknown, or if the cavity is not a network.
  const NetworkEnd* network_end(std::size_t row) const {
    const auto at = network_ends.find(row);
    return at == network_ends.end() ? nullptr : &at->second;
  }
};

// Ranks by row; 1 is the largest. Equal volumes rank in the order of rows.
std::vector<std::size_t> ranks_by_exact_volume(const CavityTable& table, const ExactVolumes& exact);

// Å² and Å; empty if there is no such value.
std::string alpha_text(const NetworkEnd& end);
std::string radius_text(const NetworkEnd& end);

std::string comparable_text(const std::vector<std::string>& differences_from_castp);

// `first_id` is the id of the same cavity with the first radii and solvent radius. It is the
// cavity's own id if there are no others; 0: there is no such cavity.
CsvRow cavity_csv(const CavityFacts& facts, std::size_t row, std::size_t first_id);

// Provenance and request for files on the cavities, without notes.
std::vector<std::pair<std::string, std::string>> cavity_header(const CavityFacts& facts);

}  // namespace alphascope

// The cavities of one table as programs read them (docs/output-files.md): what the command line and
// the window write of them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/cavity_identity/network_radius.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/export/record_source.hpp"
#include "core/document/settings/request.hpp"
#include "core/write/csv.hpp"

namespace alphascope {

// All that is reported of them; by row of the table where nothing else is said. Nothing is null but
// `exact`, where nobody wants it.
struct CavityFacts {
  RecordSource source;
  Request request;
  std::shared_ptr<const BallReferences> atoms;
  std::shared_ptr<const CavityTable> all;
  std::shared_ptr<const ExactVolumes> exact;  // if null: no clipped() and no is_doubtful()
  std::shared_ptr<const CavityDepths> depths;
  std::shared_ptr<const CavityLives> lives;  // of no cavity: empty
  std::shared_ptr<const CavityContents> contents;
  std::vector<std::string> differences;   // from what CASTp takes
  std::vector<std::size_t> clipped_rank;  // 1: the largest clipped volume; empty without `exact`
  std::vector<std::size_t> rows;          // those to report
  std::map<std::size_t, NetworkEnd> network_ends;  // of rows that are networks, where it is known

  const CavityTable& table() const { return *all; }
  // With the lattice that was computed on.
  RecordSource computed_source() const { return source.on(table().ground->balls->lattice); }
  const ClippedMeasures& clipped(std::size_t row) const { return exact->of[table().order[row]]; }
  bool is_doubtful(std::size_t row) const;
  const char* kind(std::size_t row) const {
    const Cavity& cavity = table().cavity(row);
    return cavity.is_void() ? "void" : cavity.is_part() ? "part" : "pocket";
  }
  // Null where it is not known, or is no network.
  const NetworkEnd* network_end(std::size_t row) const {
    const auto at = network_ends.find(row);
    return at == network_ends.end() ? nullptr : &at->second;
  }
  std::string name(std::size_t row) const { return cavity_name(*atoms, table(), row); }
  // "A:HEM 142 (41 of 43 atoms)"; "" when it holds nothing.
  std::string contents_text(std::size_t row) const;
  // Å²; the solvent radius stays.
  struct Life {
    double born, closed, gone;
    bool closes;  // it is a void from `closed` on
  };
  Life life(std::size_t row) const;
};

// 1 for the largest, by row; of equal ones the first.
std::vector<std::size_t> ranks_by_clipped(const CavityTable& table, const ExactVolumes& exact);

// Å², Å; empty where there is none.
std::string alpha_text(const NetworkEnd& end);
std::string radius_text(const NetworkEnd& end);

std::string comparable_text(const std::vector<std::string>& differences_from_castp);

// `first_id`: the id of the cavity of the first radii and solvent radius that it is, its own where
// there are no others; 0 for none.
CsvRow cavity_csv(const CavityFacts& facts, std::size_t row, std::size_t first_id);

// Where it comes from and what was asked, for whatever else is written of it, without notes.
std::vector<std::pair<std::string, std::string>> cavity_header(const CavityFacts& facts);

}  // namespace alphascope

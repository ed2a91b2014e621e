// SPDX-License-Identifier: GPL-3.0-or-later
// Cavity tables by an independent program (see the README in its folder), and our comparison with
// them. Used by tests and by a program run by hand.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/cavity/cavity_measures.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope::testing {

// A row of a table, its columns by name.
using TableRow = std::map<std::string, std::string>;

class CavityReference {
 public:
  // Reads reference.tsv, cavities.tsv, lining.tsv.gz and traps.tsv in this folder, beside inputs
  // and traps.
  explicit CavityReference(std::filesystem::path folder);

  // The rows of reference.tsv and traps.tsv. Each is one computation.
  const std::vector<TableRow>& runs() const { return runs_; }
  // The balls of a run, grown by its solvent radius.
  std::shared_ptr<const BallSet> balls(const TableRow& run) const;

  // Differences from the row and from the tables of cavities, in words. Empty if there are none.
  std::vector<std::string> differences(const TableRow& run, const CavityGround& ground,
                                       const Cavities& found,
                                       const std::vector<CavityMeasures>& measures) const;

 private:
  struct KnownCavity {
    TableRow row;
    std::vector<BallIndex> atoms, lining;
  };
  std::filesystem::path folder_;
  std::vector<TableRow> runs_;
  std::map<std::string, std::vector<KnownCavity>> cavities_;  // by input and solvent radius
};

}  // namespace alphascope::testing

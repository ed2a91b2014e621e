// Tables of cavities that an independent program computed (docs of the folder: its README), and the
// comparison of ours with them. For tests and for the program that does so by hand.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/cavity/cavity_measures.hpp"

namespace alphascope::testing {

// A row of a table: its columns by name.
using TableRow = std::map<std::string, std::string>;

class CavityReference {
 public:
  // reference.tsv, cavities.tsv, lining.tsv.gz and traps.tsv of this folder, beside inputs and
  // traps.
  explicit CavityReference(std::filesystem::path folder);

  // The rows of reference.tsv and traps.tsv: each is a computation.
  const std::vector<TableRow>& runs() const { return runs_; }
  // Its balls, grown by its solvent radius.
  std::shared_ptr<const BallSet> balls(const TableRow& run) const;

  // What differs from the row and from the cavities' tables, in words; empty if nothing does.
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

// SPDX-License-Identifier: GPL-3.0-or-later
// The results on the cavities of one table, as far as they are known. Columns read them.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace alphascope {

class BallReferences;
struct CavityBottlenecks;
struct CavityContents;
struct CavityDepths;
struct CavityLines;
struct CavityLives;
struct CavityTable;
struct ExactCavityMeasures;
struct ExactVolumes;

// Results that are not known yet, or not wanted, are null. A function may be called only if the
// results that it reads are there.
struct KnownCavities {
  std::shared_ptr<const CavityTable> all;
  std::shared_ptr<const BallReferences> atoms;
  std::shared_ptr<const CavityLines> lines;  // of the window alone
  std::shared_ptr<const ExactVolumes> exact;
  std::shared_ptr<const CavityDepths> depths;
  std::shared_ptr<const CavityLives> lives;  // empty if there is no cavity
  std::shared_ptr<const CavityContents> contents;
  std::shared_ptr<const CavityBottlenecks> bottlenecks;  // of the window alone

  const CavityTable& table() const { return *all; }
  std::size_t size() const;
  const ExactCavityMeasures& exact_measures(std::size_t row) const;
  bool differs_from_exact(std::size_t row) const;
  const char* kind(std::size_t row) const;  // "void", "pocket", or "part" of a network
  std::string name(std::size_t row) const;
  std::size_t lining_residues(std::size_t row) const;  // their number
  // "A:HEM 142 (41 of 43 atoms)"; empty for an empty cavity.
  std::string contents_text(std::size_t row) const;
  // Alphas in Å², at the same solvent radius.
  struct Life {
    double born, closed, gone;
    bool closes;  // the cavity is a void from `closed` on
  };
  Life life(std::size_t row) const;
};

}  // namespace alphascope

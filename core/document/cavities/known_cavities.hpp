// SPDX-License-Identifier: GPL-3.0-or-later
// The results on the cavities of one table, as far as they are known. Columns read them.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/channel/bottlenecks.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"

namespace alphascope {

// The bottlenecks on the ways out of the cavities on screen, computed in the background.
struct CavityBottlenecks {
  // More rows would take minutes: each new value needs two triangulations.
  static constexpr std::size_t kMostRows = 100;
  std::vector<Bottleneck> rows;  // for the first rows of the CavityTable
};

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
  std::size_t size() const { return all ? all->size() : 0; }
  const ExactCavityMeasures& exact_measures(std::size_t row) const {
    return exact->of[table().order[row]];
  }
  bool differs_from_exact(std::size_t row) const;
  const char* kind(std::size_t row) const;  // "void", "pocket", or "part" of a network
  std::string name(std::size_t row) const { return cavity_name(*atoms, table(), row); }
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

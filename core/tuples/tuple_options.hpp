// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the tuple engine. None changes the result; each changes the work that is done for
// it.
#pragma once

namespace alphascope {

// automatic: cells at least half as wide as the widest cube of neighbours. thesis: 100 x 100 x 100
// cells for every molecule.
enum class TupleGridKind { automatic, thesis };

struct TupleOptions {
  TupleGridKind grid = TupleGridKind::automatic;
  bool edge_optimisation = true;   // only tuples whose grown balls meet in pairs
  bool alpha_optimisation = true;  // drop tuples with ortho-radius > alpha before kernel II
  // For the CUDA executor only.
  bool pinned = true;   // page-locked staging memory
  int streams = 2;      // 1 to 8 streams take turns with batches of tuples; 1: no overlap
  bool texture = true;  // kernels read balls through textures
  // Bound on the tuples in memory for each stream, which bounds memory for every input. 0: chosen
  // automatically.
  int tuples_per_batch = 0;

  friend bool operator==(const TupleOptions&, const TupleOptions&) = default;
};

}  // namespace alphascope

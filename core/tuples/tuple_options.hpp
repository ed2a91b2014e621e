// The switches of the tuple engine. None changes the result; each changes what work is done for it.
#pragma once

namespace alphascope {

// automatic: cells as wide as half the widest cube of neighbours, or wider. thesis: 100 x 100 x 100
// cells whatever the molecule.
enum class TupleGridKind { automatic, thesis };

struct TupleOptions {
  TupleGridKind grid = TupleGridKind::automatic;
  bool edge_optimisation = true;   // only tuples whose grown balls meet in pairs
  bool alpha_optimisation = true;  // drop tuples with ortho-radius > alpha before kernel II
  // Of the CUDA executor only.
  bool pinned = true;   // page-locked staging memory
  int streams = 2;      // 1 to 8: batches of tuples in turns; 1 is without overlap
  bool texture = true;  // kernels read balls through textures
  // Most tuples held at once for each stream; 0 chooses. Bounds memory, whatever the input.
  int tuples_per_batch = 0;

  friend bool operator==(const TupleOptions&, const TupleOptions&) = default;
};

}  // namespace alphascope

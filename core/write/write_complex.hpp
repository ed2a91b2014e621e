// An alpha complex as text with all its simplices (docs/output-files.md), in our layout and in
// ParallelAC's. Other formats are written elsewhere.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/files/atomic_file.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// Where the complex comes from: one line each, "key value", in this order.
using ComplexHeader = std::vector<std::pair<std::string, std::string>>;

// `balls` are those the complex was computed of (with the solvent radius). Does not commit. Throws
// WriteError, and Cancelled.
void write_complex_text(const BallSet& balls, const AlphaComplex& complex,
                        const ComplexHeader& header, AtomicFile& file, const RunContext& context);

// The layout of ParallelAC's results: "V E F T", a line "x y z r" (Å, five digits) for each ball,
// then the balls, from 0, of each edge, triangle and tetrahedron. V counts all balls, so that
// indices are the same as everywhere; there are no comments in this layout, so no header. Otherwise
// as above.
void write_parallelac_text(const BallSet& balls, const AlphaComplex& complex, AtomicFile& file,
                           const RunContext& context);

}  // namespace alphascope

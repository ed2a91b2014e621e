// SPDX-License-Identifier: GPL-3.0-or-later
// An alpha complex as text with all its simplices (docs/output-files.md), in the layouts of
// Alphascope and ParallelAC. Other formats are in other files.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alphascope {

class AtomicFile;
struct AlphaComplex;
struct BallSet;
class TextWriter;
struct RunContext;

// The provenance of the complex: one line "key value" each, in this order.
using ComplexHeader = std::vector<std::pair<std::string, std::string>>;

// Writes the first line, which names the format; the header; and the section of balls. For the
// formats of complexes as text.
void write_header_and_balls(std::string_view format, const ComplexHeader& header,
                            const BallSet& balls, TextWriter& text);

// `balls` are those of which the complex was computed, with the solvent radius. Does not commit the
// file. Throws WriteError and Cancelled.
void write_complex_text(const BallSet& balls, const AlphaComplex& complex,
                        const ComplexHeader& header, AtomicFile& file, const RunContext& context);

// Writes the layout of ParallelAC's results. It has a line "V E F T", then a line "x y z r" (Å,
// five digits) per ball. Then follow the balls, counted from 0, of each edge, triangle and
// tetrahedron. V counts all balls, so that indices are the same as everywhere. The layout has no
// comments, so there is no header. Commit and exceptions as above.
void write_parallelac_text(const BallSet& balls, const AlphaComplex& complex, AtomicFile& file,
                           const RunContext& context);

}  // namespace alphascope

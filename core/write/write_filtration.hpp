// SPDX-License-Identifier: GPL-3.0-or-later
// The filtration of a complex as text (docs/output-files.md): all simplices in the order in which a
// growing alpha reaches them.
#pragma once

#include <memory>

#include "core/write/write_complex.hpp"

namespace alphascope {

// `complex` is a whole complex of these balls, which include the solvent radius. Does not commit
// the file. Works in the caller's task arena. Throws WriteError, Cancelled, and
// std::invalid_argument for a complex of tetrahedra only.
void write_filtration_text(const std::shared_ptr<const BallSet>& balls, const AlphaComplex& complex,
                           const ComplexHeader& header, AtomicFile& file,
                           const RunContext& context);

}  // namespace alphascope

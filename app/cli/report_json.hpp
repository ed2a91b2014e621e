// SPDX-License-Identifier: GPL-3.0-or-later
// The provenance of results: as JSON (docs/output-files.md), and as the header of text files.
#pragma once

#include <string>

#include "app/cli/input.hpp"
#include "core/complex/compare.hpp"
#include "core/document/export/record_json.hpp"
#include "core/document/store/answer.hpp"
#include "core/write/write_complex.hpp"

namespace alphascope::cli {

ProgramName program();
std::string program_text();  // "alphascope-cli 0.2.0 (0123456789ab)"
Json program_json();
RecordSource source_of(const Input& input);
// `computed_on`: the lattice of the balls in the computation.
Json input_json(const Input& input, const Lattice& computed_on);
Json comparison_json(const Comparison& comparison);

// Returns the JSON to write. With --no-times it lacks everything that depends on time or threads.
Json json_to_write(Json json);

// The header with all notes of reader and engine.
ComplexHeader complex_header(const Input& input, const EngineAnswer& answer);

}  // namespace alphascope::cli

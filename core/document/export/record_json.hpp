// SPDX-License-Identifier: GPL-3.0-or-later
// JSON of results with their provenance (docs/output-files.md), for window and command line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/document/export/record_source.hpp"
#include "core/document/session/alpha_json.hpp"
#include "core/document/settings/request.hpp"

namespace alphascope {

using Json = nlohmann::ordered_json;

Json program_json(const ProgramName& program);
Json input_json(const RecordSource& source);
Json request_json(const Request& request, const Lattice& lattice);
// Keys counts, euler_characteristic, hash, tetrahedra_hash, engine, timings_ms. If only tetrahedra
// were computed, the missing values are null.
Json complex_json(const AlphaComplex& complex, const std::string& engine_note);

// Removes, at any depth, values that depend on time and threads: times, device, route, counters.
void leave_out_run(Json& json);

// Indented text that ends with a newline. NaN and infinite numbers become null. Text that is not
// UTF-8 becomes { "bytes": "c3a4" }, as in sessions.
std::string json_text(const Json& json);

}  // namespace alphascope

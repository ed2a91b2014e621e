// Results with their provenance as JSON (docs/output-files.md), for window and command line.
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
// Keys counts, euler_characteristic, hash, tetrahedra_hash, engine, timings_ms. What a
// tetrahedra-only complex does not hold is null.
Json complex_json(const AlphaComplex& complex, const std::string& engine_note);

// Leaves out, at any depth, what depends on time and threads: times, device, route, counters.
void leave_out_run(Json& json);

// Indented, and a line of its own at the end. A number that is none (NaN, infinite) is null; a text
// that is no UTF-8 is { "bytes": "c3a4" }, as in sessions.
std::string json_text(const Json& json);

}  // namespace alphascope

// Results with their provenance as JSON (docs/output-files.md) and as the header of a text file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/input.hpp"
#include "core/complex/compare.hpp"
#include "core/io/write_complex.hpp"

namespace alphascope::cli {

using Json = nlohmann::ordered_json;

std::string program_text();  // "alphascope-cli 0.1.0 (0123456789ab)"
Json program_json();
Json input_json(const Input& input);
Json request_json(const Request& request, const Lattice& lattice);
// Keys counts, euler_characteristic, hash, tetrahedra_hash, engine, timings_ms. What a
// tetrahedra-only complex does not hold is null.
Json complex_json(const AlphaComplex& complex, const std::string& engine_note);
Json comparison_json(const Comparison& comparison);

// With every note of the readers and of the engine.
ComplexHeader complex_header(const Input& input, const EngineAnswer& answer);

// Indented, and a line of its own at the end. A number that is none (NaN, infinite) is null.
std::string json_text(const Json& json);

}  // namespace alphascope::cli

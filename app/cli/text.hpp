// Numbers and results as people read them.
#pragma once

#include <cstdint>
#include <string>

#include "app/cli/commands.hpp"
#include "core/complex/alpha_complex.hpp"

namespace alphascope::cli {

std::string grouped(std::uint64_t number);  // "16,445"
std::string number_text(double number);     // shortest: "1.4", "-0.5"
std::string format_text(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string milliseconds_text(double milliseconds);  // "0.42 ms", "1.53 s"

// Several lines, each ended: counts, Euler characteristic, hash, engine; unless quiet, what the
// engine counted, and times.
std::string complex_text(const AlphaComplex& complex, Verbosity verbosity);
// The stages alone, a line each.
std::string stages_text(const AlphaComplex& complex);

}  // namespace alphascope::cli

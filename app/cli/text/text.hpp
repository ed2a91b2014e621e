// Numbers and results as people read them.
#pragma once

#include <chrono>
#include <string>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/text/grouped_number.hpp"
#include "core/write/csv.hpp"

namespace alphascope::cli {

std::string format_text(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string milliseconds_text(double milliseconds);  // "0.42 ms", "1.53 s"

// How long it takes, in milliseconds.
template <class Work>
double timed(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

// Several lines, each ended: counts, Euler characteristic, hash, engine; where times are shown,
// also what the engine counted, and times.
std::string complex_text(const AlphaComplex& complex);
// The stages alone, a line each.
std::string stages_text(const AlphaComplex& complex);

}  // namespace alphascope::cli

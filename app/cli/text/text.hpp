// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and results as text for people.
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

// The duration of work(), milliseconds.
template <class Work>
double timed(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

// Several lines with line ends: counts, Euler characteristic, hash and engine. If times are shown,
// also the engine's counters and times.
std::string complex_text(const AlphaComplex& complex);
// The stages alone, one a line.
std::string stages_text(const AlphaComplex& complex);

}  // namespace alphascope::cli

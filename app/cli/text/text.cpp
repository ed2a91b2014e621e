// SPDX-License-Identifier: GPL-3.0-or-later
// Formats numbers, times and complexes for people.
#include "app/cli/text/text.hpp"

#include <cstdarg>
#include <cstdio>

#include "app/cli/text/terminal.hpp"

namespace alphascope::cli {

std::string format_text(const char* format, ...) {
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, again)), ' ');
  va_end(again);
  std::vsnprintf(text.data(), text.size() + 1, format, arguments);
  va_end(arguments);
  return text;
}

std::string milliseconds_text(double milliseconds) {
  char buffer[48];
  if (milliseconds >= 1000) {
    std::snprintf(buffer, sizeof buffer, "%.2f s", milliseconds / 1000);
  } else {
    std::snprintf(buffer, sizeof buffer, milliseconds < 10 ? "%.2f ms" : "%.1f ms", milliseconds);
  }
  return buffer;
}

std::string stages_text(const AlphaComplex& complex) {
  std::string text;
  for (const StageTime& stage : complex.timings.stages) {
    text += "            " + milliseconds_text(stage.milliseconds) + "  " + stage.label +
            (stage.setup ? " (once per molecule)" : "") + "\n";
  }
  return text;
}

std::string complex_text(const AlphaComplex& complex) {
  std::string text;
  if (!complex.tetrahedra_only) {
    text += "vertices    " + grouped(complex.vertices.size()) + "\n";
    text += "edges       " + grouped(complex.edges.size()) + "\n";
    text += "triangles   " + grouped(complex.triangles.size()) + "\n";
  }
  text += "tetrahedra  " + grouped(complex.tetrahedra.size()) + "\n";
  if (!complex.tetrahedra_only) {
    text += "Euler       " + std::to_string(complex.euler_characteristic()) + "\n";
  }
  text += "hash        " + hash_text(complex.hash) + "\n";
  text += "engine      " + complex.engine.name;
  if (times_wanted()) text += ", " + complex.engine.device + " (" + complex.engine.route + ")";
  text += "\n";
  if (!times_shown()) return text;
  for (const EngineCounter& counter : complex.engine.counters) {
    text += "            " + grouped(counter.value) + " " + counter.name + "\n";
  }
  text += "time        " + milliseconds_text(complex.timings.wall_milliseconds) + "\n";
  return text + stages_text(complex);
}

}  // namespace alphascope::cli

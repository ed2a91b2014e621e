// SPDX-License-Identifier: GPL-3.0-or-later
// Writes times, bytes, shares and ratios.
#include "ui/widgets/format.hpp"

#include <cmath>

#include "core/text/grouped_number.hpp"
#include "ui/number_text.hpp"

namespace alphascope {
namespace {

// Peak memory of the window with the complex of an assembly, measured with 3J6R (1.03 million
// atoms) and the CPU engine. An empty window takes 130 MB. Each atom adds 1,230 bytes at alpha 0,
// and 1,800 bytes at 1.4 Å². A solvent radius of 1.4 Å, set afterwards, raises this to 2,370 bytes.
// The memory depends on alpha, so a range is reported. Its upper end is a tenth above the measured
// one.
constexpr std::uint64_t kBytesOfTheWindow = 130'000'000;
constexpr std::uint64_t kLeastBytesPerAtom = 1230, kMostBytesPerAtom = 2600;

}  // namespace

std::string with_separators(long long value) {
  const std::string digits = grouped(static_cast<std::uint64_t>(value < 0 ? -value : value));
  return value < 0 ? "−" + digits : digits;
}

std::string milliseconds_text(double milliseconds) {
  if (milliseconds >= 10000) return number_text(milliseconds / 1000, 1) + " s";
  if (milliseconds >= 1000) return number_text(milliseconds / 1000, 2) + " s";
  if (milliseconds >= 100) return number_text(milliseconds, 0) + " ms";
  if (milliseconds >= 10) return number_text(milliseconds, 1) + " ms";
  if (milliseconds >= 1) return number_text(milliseconds, 2) + " ms";
  if (milliseconds == 0) return "0 ms";
  if (milliseconds < 0.0005) return "<0.001 ms";
  return number_text(milliseconds, 3) + " ms";
}

std::string bytes_text(std::size_t bytes) {
  const double value = static_cast<double>(bytes);
  if (value >= 1e9) return number_text(value / 1e9, 2) + " GB";
  if (value >= 1e6) return number_text(value / 1e6, 0) + " MB";
  if (value >= 1e3) return number_text(value / 1e3, 0) + " kB";
  return number_text(value, 0) + " bytes";
}

MemoryRange assembly_memory(std::uint64_t atoms) {
  return {kBytesOfTheWindow + atoms * kLeastBytesPerAtom,
          kBytesOfTheWindow + atoms * kMostBytesPerAtom};
}

std::string percent_text(double share) {
  return number_text(100 * share, 0) + " %";
}

std::string ratio_text(double ratio) {
  if (!(ratio > 0) || std::isinf(ratio)) return "–";
  if (ratio >= 99.95) return with_separators(std::llround(ratio)) + "×";
  if (ratio >= 0.995) return number_text(ratio, 1) + "×";
  return ratio < 0.005 ? "< 0.01×" : number_text(ratio, 2) + "×";
}

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// The list of columns, and their values.
#include "app/bench/thesis_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/bench/report_columns.hpp"
#include "core/geometry/shortest_number.hpp"

namespace alphascope {
namespace {

double tenth_of_microsecond(double milliseconds) {
  return std::round(milliseconds * 1e4) / 1e4;
}

CellValue milliseconds(std::optional<double> value) {
  return value ? CellValue(tenth_of_microsecond(*value)) : CellValue();
}

template <class T>
CellValue cell(const std::optional<T>& value) {
  return value ? CellValue(*value) : CellValue();
}

CellValue count(std::uint64_t number) {
  return number;
}

const char* kind_text(ThesisRow::Kind kind) {
  switch (kind) {
    case ThesisRow::Kind::cgal:
      return "cgal";
    case ThesisRow::Kind::engine:
      return "engine";
    case ThesisRow::Kind::ablation:
      break;
  }
  return "ablation";
}

std::string counters_text(const EngineInfo& engine) {
  std::string text;
  for (const EngineCounter& c : engine.counters) {
    text += (text.empty() ? "" : "; ") + c.name + " = " + std::to_string(c.value);
  }
  return text;
}

std::string stages_text(const std::vector<StageTime>& stages) {
  std::string text;
  for (const StageTime& s : stages) {
    text += (text.empty() ? "" : "; ") + s.label + " = " +
            shortest_number(tenth_of_microsecond(s.milliseconds)) + " ms";
  }
  return text;
}

// Returns alpha as a number if a double represents it exactly, else as a text with all digits. All
// JSON of the program does so.
CellValue alpha_cell(const Alpha& alpha) {
  return alpha.is_shortest_of_double() ? CellValue(alpha.nearest()) : CellValue(alpha.digits());
}

// Null if the row has no break-even.
const BreakEven* break_even_of(const ThesisTableRow& r) {
  if (r.row.kind != ThesisRow::Kind::engine) return nullptr;
  const auto& all = r.report.break_even;
  const auto found = std::find_if(all.begin(), all.end(), [&](const BreakEven& b) {
    return b.molecule_index == r.row.molecule_index && b.choice == r.row.choice;
  });
  return found == all.end() ? nullptr : &*found;
}

using Row = ThesisTableRow;

// The value, or none if nothing was measured.
CellValue when_measured(const Row& r, const CellValue& value) {
  return r.row.measured() ? value : CellValue();
}

CellValue stage(const Row& r, std::optional<double> ThesisStages::*time) {
  return milliseconds(r.row.stages.*time);
}

const ThesisReport& suite_of(const Row& r) {
  return r.report;
}

const Column<Row> kColumns[] = {
    kMoleculeColumn<Row>,
    kBallsColumn<Row>,
    {.id = "alpha_angstrom2",
     .title = "alpha",
     .unit = "Å²",
     .help = "The requested alpha.",
     .value = [](const Row& r) -> CellValue { return alpha_cell(r.row.alpha_angstrom2); }},
    kSolventColumn<Row, suite_of>,
    {.id = "tetrahedra_only",
     .title = "tetrahedra only",
     .help = "Only tetrahedra were computed, as in the thesis.",
     .value = [](const Row& r) -> CellValue { return r.report.options.tetrahedra_only; }},
    {.id = "kind",
     .title = "kind",
     .help =
         "“cgal”, “engine”, or “ablation”: the tuple engine with the change that `variant` names.",
     .value = [](const Row& r) -> CellValue { return std::string(kind_text(r.row.kind)); }},
    {.id = "engine",
     .title = "engine",
     .help = "The engine, as the command line names it.",
     .value = [](const Row& r) -> CellValue { return std::string(engine_id(r.row.choice)); }},
    {.id = "variant",
     .title = "variant",
     .help = "The change of an ablation, or the threads of CGAL.",
     .value = [](const Row& r) -> CellValue { return r.row.variant; }},
    {.id = "threads",
     .title = "threads",
     .help = "The number of CPU threads.",
     .value = [](const Row& r) -> CellValue {
       return count(static_cast<std::uint64_t>(r.row.threads > 0 ? r.row.threads
                                                                 : r.report.machine.threads));
     }},
    {.id = "skipped",
     .title = "skipped",
     .help = "The reason why nothing was measured; else empty.",
     .value = [](const Row& r) -> CellValue { return r.row.skipped; }},
    {.id = "run_complete",
     .title = "complete",
     .help = "False if the run was cancelled in the window, so that later rows are missing.",
     .value = [](const Row& r) -> CellValue { return r.report.complete; }},
    {.id = "runs",
     .title = "runs",
     .help = "The number of counted runs. It is less than requested if the time for a row ran out.",
     .value = [](const Row& r) -> CellValue {
       return when_measured(r, count(static_cast<std::uint64_t>(r.row.runs)));
     }},
    {.id = "memcpy_ms",
     .title = "memcpy",
     .unit = "ms",
     .help =
         "The thesis' column: copies to and from the device. Times are medians of the cold runs.",
     .value = [](const Row& r) -> CellValue { return stage(r, &ThesisStages::memcpy); }},
    {.id = "kernel1_ms",
     .title = "kernel1",
     .unit = "ms",
     .help = "The thesis' column: kernel I, which finds candidates.",
     .value = [](const Row& r) -> CellValue { return stage(r, &ThesisStages::kernel1); }},
    {.id = "kernel1_includes_kernel2",
     .help = "True if one launch does both; then `kernel2_ms` is empty.",
     .value = [](const Row& r) -> CellValue {
       return when_measured(r, r.row.stages.kernel1_has_kernel2);
     }},
    {.id = "prefix_sum_ms",
     .title = "prefixsum",
     .unit = "ms",
     .help = "The thesis' column: the prefix sum over counts.",
     .value = [](const Row& r) -> CellValue { return stage(r, &ThesisStages::prefix_sum); }},
    {.id = "kernel2_ms",
     .title = "kernel2",
     .unit = "ms",
     .help = "The thesis' column: kernel II.",
     .value = [](const Row& r) -> CellValue { return stage(r, &ThesisStages::kernel2); }},
    {.id = "kernel3_ms",
     .title = "kernel3",
     .unit = "ms",
     .help = "The thesis' column: kernel III.",
     .value = [](const Row& r) -> CellValue { return stage(r, &ThesisStages::kernel3); }},
    {.id = "other_stages_ms",
     .title = "other",
     .unit = "ms",
     .help = "All other stages, such as grid, classification and hash.",
     .value = [](const Row& r) -> CellValue { return stage(r, &ThesisStages::other); }},
    {.id = "cold_median_ms",
     .title = "cold",
     .unit = "ms",
     .help = "The wall time of a new engine that is made and asked once; the median.",
     .value = [](const Row& r) -> CellValue {
       return when_measured(r, tenth_of_microsecond(r.row.cold_milliseconds));
     }},
    {.id = "warm_median_ms",
     .title = "warm",
     .unit = "ms",
     .help = "The wall time of the same engine, asked again at an alpha smaller by 0.001 Å²; the "
             "median.",
     .value = [](const Row& r) -> CellValue {
       return when_measured(r, tenth_of_microsecond(r.row.warm_milliseconds));
     }},
    {.id = "cgal_cold_median_ms",
     .title = "CGAL cold",
     .unit = "ms",
     .help = "The wall time of CGAL at the same alpha, with one thread.",
     .value = [](const Row& r) -> CellValue { return milliseconds(r.row.cgal_cold_milliseconds); }},
    {.id = "cgal_parallel_cold_median_ms",
     .title = "CGAL parallel",
     .unit = "ms",
     .help = "The wall time of CGAL at the same alpha, with all threads.",
     .value = [](const Row& r) -> CellValue {
       return milliseconds(r.row.cgal_parallel_cold_milliseconds);
     }},
    {.id = "speed_up_over_cgal",
     .title = "speed-up",
     .help = "`cgal_cold_median_ms` / `cold_median_ms`, before rounding.",
     .value = [](const Row& r) -> CellValue { return cell(r.row.speed_up()); }},
    {.id = "tetrahedra",
     .title = "tetrahedra",
     .help = "The number of tetrahedra of the result.",
     .value = [](const Row& r) -> CellValue { return when_measured(r, count(r.row.tetrahedra)); }},
    {.id = "full_triangulation_tetrahedra",
     .title = "full",
     .help = "The number of tetrahedra of the molecule's whole regular triangulation.",
     .value = [](const Row& r) -> CellValue {
       return r.row.full_tetrahedra ? count(*r.row.full_tetrahedra) : CellValue();
     }},
    {.id = "share_of_full_triangulation",
     .title = "of full",
     .help = "The share of these tetrahedra in the result, 0 to 1.",
     .value = [](const Row& r) -> CellValue { return cell(r.row.share_of_full()); }},
    {.id = "beats_cgal_up_to_angstrom2",
     .title = "beats CGAL up to",
     .unit = "Å²",
     .help = "The largest alpha at which the engine was faster than CGAL with one thread.",
     .value =
         [](const Row& r) {
           const BreakEven* even = break_even_of(r);
           return even ? cell(even->alpha_angstrom2) : CellValue();
         }},
    {.id = "beats_cgal_beyond_that",
     .help = "True if the engine was faster at the largest alpha, too.",
     .value =
         [](const Row& r) {
           const BreakEven* even = break_even_of(r);
           return even ? CellValue(even->beyond) : CellValue();
         }},
    {.id = "loses_to_cgal_at_angstrom2",
     .title = "loses to CGAL at",
     .unit = "Å²",
     .help = "The smallest alpha at which CGAL was faster. The break-even lies between the two.",
     .value =
         [](const Row& r) {
           const BreakEven* even = break_even_of(r);
           return even ? cell(even->lost_at_angstrom2) : CellValue();
         }},
    {.id = "hash",
     .title = "hash",
     .help = "The hash of the result.",
     .value = [](const Row& r) -> CellValue { return when_measured(r, hash_text(r.row.hash)); }},
    {.id = "same_as_cgal",
     .title = "same",
     .help = "The result has the hash of CGAL's; empty if CGAL was left out.",
     .value = [](const Row& r) -> CellValue { return cell(r.row.same_as_cgal); }},
    {.id = "engine_name",
     .title = "engine",
     .help = "The name of the engine.",
     .value = [](const Row& r) -> CellValue { return r.row.engine.name; }},
    {.id = "device",
     .title = "device",
     .help = "The device that computed.",
     .value = [](const Row& r) -> CellValue { return r.row.engine.device; }},
    {.id = "route",
     .title = "route",
     .help = "The way in which this alpha was computed.",
     .value = [](const Row& r) -> CellValue { return r.row.engine.route; }},
    {.id = "counters",
     .title = "counters",
     .help = "The counts of the engine, such as 4-tuples.",
     .value = [](const Row& r) -> CellValue { return counters_text(r.row.engine); }},
    {.id = "stages",
     .title = "stages",
     .help = "All stages in the words of the program, with their times.",
     .value = [](const Row& r) -> CellValue { return stages_text(r.row.stage_medians); }},
    kProgramColumn<Row, suite_of>,
    kCpuColumn<Row, suite_of>,
    {.id = "cpu_threads",
     .title = "CPU threads",
     .help = "The number of its threads.",
     .value = [](const Row& r) -> CellValue {
       return count(static_cast<std::uint64_t>(r.report.machine.threads));
     }},
    {.id = "gpu",
     .title = "GPU",
     .help = "The name of the GPU; empty without one.",
     .value = [](const Row& r) -> CellValue { return r.report.machine.gpu.name; }},
    {.id = "gpu_driver",
     .title = "GPU driver",
     .help = "The version of its driver.",
     .value = [](const Row& r) -> CellValue { return r.report.machine.gpu.driver; }},
    {.id = "gpu_compute_capability",
     .title = "capability",
     .help = "Its compute capability.",
     .value = [](const Row& r) -> CellValue { return r.report.machine.gpu.capability_text(); }},
    {.id = "gpu_memory_bytes",
     .title = "GPU memory",
     .unit = "bytes",
     .help = "Its memory.",
     .value = [](const Row& r) -> CellValue { return count(r.report.machine.gpu.memory_bytes); }}};

}  // namespace

std::span<const Column<ThesisTableRow>> thesis_columns() {
  return kColumns;
}

std::string shortest_cell(const CellValue& value) {
  const double* number = std::get_if<double>(&value);
  return number && std::isfinite(*number) ? shortest_number(*number) : csv_cell(value);
}

std::vector<CsvRow> thesis_csv(const ThesisReport& report) {
  std::vector<CsvRow> rows;
  for (const ThesisRow& row : report.rows) {
    CsvRow& cells = rows.emplace_back();
    for (const Column<ThesisTableRow>& column : kColumns) {
      cells.emplace_back(column.id, shortest_cell(column.value({report, row})));
    }
    const auto& provenance = report.molecules[row.molecule_index].provenance;
    cells.insert(cells.end(), provenance.begin(), provenance.end());
  }
  return rows;
}

std::string contestant_text(const ThesisRow& row) {
  const std::string name =
      row.choice == EngineChoice::cgal ? "CGAL" : std::string(engine_id(row.choice));
  return row.variant.empty() ? name : name + ", " + row.variant;
}

std::string break_even_text(const BreakEven& found) {
  if (!found.alpha_angstrom2) return "none of the tried alphas";
  const std::string won = shortest_number(*found.alpha_angstrom2) + " Å²";
  if (found.beyond) return "≥ " + won;
  return won + " (lost at " + shortest_number(*found.lost_at_angstrom2) + ")";
}

}  // namespace alphascope

// Fills the columns of the table.
#include "app/bench/thesis_table.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/geometry/shortest_number.hpp"

namespace alphascope {
namespace {

double tenth_of_microsecond(double milliseconds) {
  return std::round(milliseconds * 1e4) / 1e4;
}

ThesisCell milliseconds(std::optional<double> value) {
  if (!value) return {};
  return tenth_of_microsecond(*value);
}

template <class T>
ThesisCell cell(const std::optional<T>& value) {
  if (!value) return {};
  return *value;
}

ThesisCell count(const std::optional<std::size_t>& value) {
  if (!value) return {};
  return std::uint64_t{*value};
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

// A number if a double represents it, else all digits as text, as in all our JSON.
ThesisCell alpha_cell(const Alpha& alpha) {
  if (alpha.is_shortest_of_double()) return alpha.nearest();
  return alpha.digits();
}

void add_task(ThesisTableRow& cells, const ThesisReport& report, const ThesisRow& row) {
  const int threads = row.threads > 0 ? row.threads : report.machine.threads;
  cells.insert(cells.end(), {{"molecule", row.molecule},
                             {"balls", std::uint64_t{row.balls}},
                             {"alpha_angstrom2", alpha_cell(row.alpha_angstrom2)},
                             {"solvent_radius_angstrom", report.options.solvent_radius_angstrom},
                             {"tetrahedra_only", report.options.tetrahedra_only},
                             {"kind", std::string(kind_text(row.kind))},
                             {"engine", std::string(engine_id(row.choice))},
                             {"variant", row.variant},
                             {"threads", static_cast<std::uint64_t>(threads)},
                             {"skipped", row.skipped},
                             {"run_complete", report.complete}});
}

void add_times(ThesisTableRow& cells, const ThesisRow& row) {
  const bool ok = row.measured();
  const auto when = [ok](ThesisCell value) { return ok ? value : ThesisCell{}; };
  cells.insert(cells.end(),
               {{"runs", when(static_cast<std::uint64_t>(row.runs))},
                {"memcpy_ms", milliseconds(row.stages.memcpy)},
                {"kernel1_ms", milliseconds(row.stages.kernel1)},
                {"kernel1_includes_kernel2", when(row.stages.kernel1_has_kernel2)},
                {"prefix_sum_ms", milliseconds(row.stages.prefix_sum)},
                {"kernel2_ms", milliseconds(row.stages.kernel2)},
                {"kernel3_ms", milliseconds(row.stages.kernel3)},
                {"other_stages_ms", milliseconds(row.stages.other)},
                {"cold_median_ms", when(tenth_of_microsecond(row.cold_milliseconds))},
                {"warm_median_ms", when(tenth_of_microsecond(row.warm_milliseconds))},
                {"cgal_cold_median_ms", milliseconds(row.cgal_cold_milliseconds)},
                {"cgal_parallel_cold_median_ms", milliseconds(row.cgal_parallel_cold_milliseconds)},
                {"speed_up_over_cgal", cell(row.speed_up())}});
}

const BreakEven* break_even_of(const ThesisReport& report, const ThesisRow& row) {
  if (row.kind != ThesisRow::Kind::engine) return nullptr;
  const auto found =
      std::find_if(report.break_even.begin(), report.break_even.end(), [&](const BreakEven& b) {
        return b.molecule_index == row.molecule_index && b.choice == row.choice;
      });
  return found == report.break_even.end() ? nullptr : &*found;
}

void add_result(ThesisTableRow& cells, const ThesisReport& report, const ThesisRow& row) {
  const bool ok = row.measured();
  const BreakEven* even = break_even_of(report, row);
  const auto when = [ok](ThesisCell value) { return ok ? value : ThesisCell{}; };
  cells.insert(cells.end(),
               {{"tetrahedra", when(std::uint64_t{row.tetrahedra})},
                {"full_triangulation_tetrahedra", count(row.full_tetrahedra)},
                {"share_of_full_triangulation", cell(row.share_of_full())},
                {"beats_cgal_up_to_angstrom2", even ? cell(even->alpha_angstrom2) : ThesisCell{}},
                {"beats_cgal_beyond_that", even ? ThesisCell{even->beyond} : ThesisCell{}},
                {"loses_to_cgal_at_angstrom2", even ? cell(even->lost_at_angstrom2) : ThesisCell{}},
                {"hash", when(hash_text(row.hash))},
                {"same_as_cgal", cell(row.same_as_cgal)},
                {"engine_name", row.engine.name},
                {"device", row.engine.device},
                {"route", row.engine.route},
                {"counters", counters_text(row.engine)},
                {"stages", stages_text(row.stage_medians)}});
}

void add_machine(ThesisTableRow& cells, const ThesisReport& report) {
  const MachineInfo& m = report.machine;
  cells.insert(cells.end(), {{"program", report.program},
                             {"cpu", m.cpu},
                             {"cpu_threads", static_cast<std::uint64_t>(m.threads)},
                             {"gpu", m.gpu.name},
                             {"gpu_driver", m.gpu.driver},
                             {"gpu_compute_capability", m.gpu.capability_text()},
                             {"gpu_memory_bytes", std::uint64_t{m.gpu.memory_bytes}}});
}

struct ToText {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const std::string& s) const { return s; }
  std::string operator()(double number) const {
    return std::isfinite(number) ? shortest_number(number) : "";
  }
  std::string operator()(std::uint64_t number) const { return std::to_string(number); }
  std::string operator()(bool yes) const { return yes ? "1" : "0"; }
};

}  // namespace

std::vector<ThesisTableRow> thesis_table(const ThesisReport& report) {
  std::vector<ThesisTableRow> table;
  for (const ThesisRow& row : report.rows) {
    ThesisTableRow cells;
    add_task(cells, report, row);
    add_times(cells, row);
    add_result(cells, report, row);
    add_machine(cells, report);
    for (const auto& [key, value] : report.molecules[row.molecule_index].provenance) {
      cells.emplace_back(key, value);
    }
    table.push_back(std::move(cells));
  }
  return table;
}

std::vector<CsvRow> to_csv(const std::vector<ThesisTableRow>& table) {
  std::vector<CsvRow> rows;
  for (const ThesisTableRow& cells : table) {
    CsvRow row;
    for (const auto& [name, value] : cells) row.emplace_back(name, std::visit(ToText{}, value));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string contestant_text(const ThesisRow& row) {
  const std::string name =
      row.choice == EngineChoice::cgal ? "CGAL" : std::string(engine_id(row.choice));
  return row.variant.empty() ? name : name + ", " + row.variant;
}

std::string break_even_text(const BreakEven& found) {
  if (!found.alpha_angstrom2) return "none of those tried";
  const std::string won = shortest_number(*found.alpha_angstrom2) + " Å²";
  if (found.beyond) return "≥ " + won;
  return won + " (lost at " + shortest_number(*found.lost_at_angstrom2) + ")";
}

}  // namespace alphascope

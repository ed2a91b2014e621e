// SPDX-License-Identifier: GPL-3.0-or-later
// Draws each figure from the rows of a report.
#include "app/bench/thesis_charts.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>

#include "app/bench/thesis_table.hpp"
#include "core/chart/readable_number.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/radii_set.hpp"

namespace alphascope {
namespace {

using Kind = ThesisRow::Kind;

std::string short_text(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

class Figures {
 public:
  explicit Figures(const ThesisReport& report) : report_(report), options_(report.options) {}

  std::vector<Chart> run() {
    speed_up();
    for (const EngineChoice choice : options_.engines) improvement(choice);
    beaten_up_to();
    share_of_full();
    for (const EngineChoice choice : options_.engines) {
      if (!is_tuple_engine(choice)) continue;
      ablation(choice);
      stage_shares(choice);
    }
    std::erase_if(charts_, [](const Chart& chart) { return chart.empty(); });
    return std::move(charts_);
  }

 private:
  Chart& start(ChartKind kind, const std::string& id, const std::string& title) {
    Chart chart;
    chart.kind = kind;
    chart.id = id;
    chart.title = title;
    chart.caption = machine_text(report_.machine) + ". " + report_.program + ". Medians of " +
                    std::to_string(options_.repeats) + " runs or fewer, " +
                    (options_.tetrahedra_only ? "tetrahedra only" : "whole complex") +
                    ", solvent radius " + short_text(options_.solvent_radius_angstrom) + " Å.";
    if (!report_.complete) {
      chart.caption += " Incomplete: the run was cancelled before all was measured.";
    }
    charts_.push_back(std::move(chart));
    return charts_.back();
  }

  void name_molecules(Chart& chart) const {
    for (const ThesisMolecule& m : report_.molecules) {
      chart.categories.push_back(m.name + " (" + separated_number(std::to_string(m.balls->size())) +
                                 ")");
    }
  }

  const ThesisRow* find(std::size_t molecule, const Alpha& alpha, Kind kind, EngineChoice choice,
                        const std::string& variant = {}) const {
    for (const ThesisRow& row : report_.rows) {
      if (row.molecule_index == molecule && row.alpha_angstrom2 == alpha && row.kind == kind &&
          row.choice == choice && row.variant == variant) {
        return &row;
      }
    }
    return nullptr;
  }

  const Alpha& least_alpha() const { return options_.alphas.front(); }
  std::string at_least_alpha() const { return " at α = " + short_text(least_alpha()) + " Å²"; }
  static std::string of(EngineChoice choice) { return std::string(engine_id(choice)); }

  void speed_up() {
    Chart& chart =
        start(ChartKind::bars, "speed-up",
              "Speed-up over CGAL with one thread" + at_least_alpha() + " (thesis, Figure 4.1)");
    chart.value_label = "time of CGAL / time of the engine, both cold (×)";
    chart.ratios = true;
    chart.reference = 1;
    chart.reference_label = "as fast as CGAL";
    name_molecules(chart);
    for (const EngineChoice choice : options_.engines) {
      add_speed_up(chart, of(choice), Kind::engine, choice, {});
    }
    add_speed_up(chart, "CGAL, parallel", Kind::cgal, EngineChoice::cgal, "parallel");
  }

  void add_speed_up(Chart& chart, const std::string& name, Kind kind, EngineChoice choice,
                    const std::string& variant) {
    ChartSeries series{name, {}};
    bool there = false;
    for (std::size_t m = 0; m < report_.molecules.size(); ++m) {
      const ThesisRow* row = find(m, least_alpha(), kind, choice, variant);
      there |= row != nullptr;
      series.values.push_back(row ? row->speed_up() : std::nullopt);
      series.notes.push_back(row ? row->skipped : "");
    }
    if (there) chart.series.push_back(std::move(series));
  }

  void improvement(EngineChoice choice) {
    Chart& chart = start(ChartKind::lines, "improvement-" + of(choice),
                         "Improvement of " + of(choice) +
                             " over CGAL with one thread (as thesis, Figures 4.2 to 4.4, there "
                             "over gReg3d)");
    chart.value_label = "time saved, % of CGAL's";
    lines_of_molecules(chart, [&](std::size_t m, const Alpha& alpha) -> std::optional<double> {
      const ThesisRow* row = find(m, alpha, Kind::engine, choice);
      if (!row || !row->speed_up()) return std::nullopt;
      return 100 * (1 - 1 / *row->speed_up());
    });
  }

  void lines_of_molecules(
      Chart& chart, const std::function<std::optional<double>(std::size_t, const Alpha&)>& value) {
    chart.x_label = "α (Å²)";
    for (std::size_t m = 0; m < report_.molecules.size(); ++m) {
      ChartSeries series{report_.molecules[m].name, {}};
      for (const Alpha& alpha : options_.alphas) {
        series.x.push_back(alpha);
        series.values.push_back(value(m, alpha));
      }
      chart.series.push_back(std::move(series));
    }
  }

  void beaten_up_to() {
    const std::string how = options_.bisections > 0 ? ", by bisection between the alphas measured"
                                                    : ", among the alphas measured";
    Chart& chart = start(ChartKind::bars, "beaten-up-to",
                         "Largest α at which the engine is faster than CGAL with one thread" + how +
                             " (as thesis, Figure 4.5, there gReg3d)");
    chart.value_label = "α (Å²); ≥ where the largest α measured was won, too";
    name_molecules(chart);
    for (const EngineChoice choice : options_.engines) {
      ChartSeries series{of(choice), {}};
      for (std::size_t m = 0; m < report_.molecules.size(); ++m) add_break_even(series, m, choice);
      chart.series.push_back(std::move(series));
    }
  }

  void add_break_even(ChartSeries& series, std::size_t molecule, EngineChoice choice) const {
    series.values.emplace_back();
    series.notes.emplace_back("unknown");
    for (const BreakEven& found : report_.break_even) {
      if (found.molecule_index != molecule || found.choice != choice) continue;
      series.values.back() = found.alpha_angstrom2;
      series.notes.back() = break_even_text(found);
    }
  }

  void share_of_full() {
    Chart& chart = start(ChartKind::lines, "share-of-full-triangulation",
                         "Tetrahedra computed, of the whole regular triangulation (thesis, Figure "
                         "4.6)");
    chart.value_label = "% of all tetrahedra";
    lines_of_molecules(chart, [&](std::size_t m, const Alpha& alpha) -> std::optional<double> {
      for (const ThesisRow& row : report_.rows) {
        if (row.molecule_index == m && row.alpha_angstrom2 == alpha && row.share_of_full()) {
          return 100 * *row.share_of_full();
        }
      }
      return std::nullopt;
    });
  }

  std::vector<std::string> variants(EngineChoice choice) const {
    std::vector<std::string> names;
    for (const ThesisRow& row : report_.rows) {
      if (row.kind != Kind::ablation || row.choice != choice) continue;
      if (std::find(names.begin(), names.end(), row.variant) == names.end()) {
        names.push_back(row.variant);
      }
    }
    return names;
  }

  void ablation(EngineChoice choice) {
    Chart& chart = start(
        ChartKind::bars, "ablation-" + of(choice),
        "What each optimisation saves, " + of(choice) + at_least_alpha() + " (thesis, Figure 4.7)");
    chart.value_label =
        "time saved by the optimisation, % of the time without it (negative: it costs time)";
    name_molecules(chart);
    for (const std::string& variant : variants(choice)) {
      ChartSeries series{variant, {}};
      for (std::size_t m = 0; m < report_.molecules.size(); ++m) {
        const ThesisRow* with = find(m, least_alpha(), Kind::engine, choice);
        const ThesisRow* without = find(m, least_alpha(), Kind::ablation, choice, variant);
        series.values.emplace_back();
        series.notes.push_back(without ? without->skipped : "");
        if (!with || !without || !with->measured() || !without->measured()) continue;
        series.values.back() = 100 * (1 - with->cold_milliseconds / without->cold_milliseconds);
      }
      chart.series.push_back(std::move(series));
    }
  }

  void stage_shares(EngineChoice choice) {
    Chart& chart =
        start(ChartKind::stacked_bars, "stages-" + of(choice),
              "Shares of the stages, " + of(choice) + at_least_alpha() + " (thesis, Figure 4.8)");
    chart.value_label = "% of the sum of all stages";
    name_molecules(chart);
    constexpr std::pair<const char*, std::optional<double> ThesisStages::*> kColumns[] = {
        {"memcpy", &ThesisStages::memcpy},         {"kernel I", &ThesisStages::kernel1},
        {"prefix sum", &ThesisStages::prefix_sum}, {"kernel II", &ThesisStages::kernel2},
        {"kernel III", &ThesisStages::kernel3},    {"other (grid, hash, …)", &ThesisStages::other}};
    for (const auto& [name, column] : kColumns) {
      ChartSeries series{name, {}};
      for (std::size_t m = 0; m < report_.molecules.size(); ++m) {
        const ThesisRow* row = find(m, least_alpha(), Kind::engine, choice);
        series.notes.push_back(row ? row->skipped : "");
        series.values.push_back(row ? share(*row, row->stages.*column) : std::nullopt);
      }
      chart.series.push_back(std::move(series));
    }
  }

  static std::optional<double> share(const ThesisRow& row, std::optional<double> milliseconds) {
    double sum = 0;
    for (const StageTime& s : row.stage_medians) sum += s.milliseconds;
    if (!milliseconds || sum <= 0) return std::nullopt;
    return 100 * *milliseconds / sum;
  }

  const ThesisReport& report_;
  const ThesisOptions& options_;
  std::vector<Chart> charts_;
};

}  // namespace

std::vector<Chart> thesis_charts(const ThesisReport& report) {
  return Figures(report).run();
}

}  // namespace alphascope

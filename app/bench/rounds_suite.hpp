// SPDX-License-Identifier: GPL-3.0-or-later
// Part I of the thesis' suite: the thesis' rounds for given molecules (core/rounds), beside the
// other ways to the whole triangulation. Prints nothing.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/bench/thesis_suite.hpp"
#include "core/document/tables/column.hpp"
#include "core/rounds/thesis_rounds.hpp"

namespace alphascope {

class TriangulationMaker;

// The rounds' name in tables. It tells them from the way that all other results take.
inline constexpr const char* kThesisRoundsName = "the thesis' rounds";

struct RoundsRow {
  enum class Kind { round, completion, whole };
  Kind kind = Kind::round;
  std::string molecule;
  std::size_t molecule_index = 0, balls = 0;
  bool by_rounds = false;  // else by the program's usual way, or by CGAL
  std::string maker;       // kThesisRoundsName, "usual way: NVIDIA H200", "CGAL"
  std::size_t number = 0;  // of the round, from 1
  std::string skipped;     // why nothing below was measured; empty: measured
  // Of Kind::whole only the number of tetrahedra and, for the rounds, of saturated balls.
  ThesisRound step;
  int runs = 0;                      // counted runs
  double milliseconds = 0;           // their median
  std::optional<bool> same_as_cgal;  // of Kind::whole: the same tetrahedra

  bool measured() const { return skipped.empty(); }
  std::optional<double> saturated_share() const;  // 0 to 1
};

// "round 2", "star completion", "whole"
std::string rounds_step_text(const RoundsRow& row);

struct RoundsReport {
  ThesisReport suite;  // for its molecules, options, machine and program
  std::vector<RoundsRow> rows;

  // True if no measured row differs from CGAL.
  bool all_same() const;
};

// Called on the measuring thread when the rows of a molecule are complete.
using RoundsListener = std::function<void(std::span<const RoundsRow> rows)>;

// Of the options only threads, repeats and time limit count. The limit is for the runs of each
// contestant: the rounds, the program's usual way, and CGAL. They take turns. `usual` makes the
// triangulations of the usual way (null: the CPU). Throws Cancelled.
RoundsReport run_rounds_suite(const std::vector<ThesisMolecule>& molecules,
                              const ThesisOptions& options,
                              const std::shared_ptr<TriangulationMaker>& usual,
                              const RunContext& context, const RoundsListener& listener = {});

struct RoundsTableRow {
  const RoundsReport& report;
  const RoundsRow& row;
};

// The columns of CSV and JSON, without provenance.
std::span<const Column<RoundsTableRow>> rounds_columns();

// One row for each row of the report, then the provenance.
std::vector<CsvRow> rounds_csv(const RoundsReport& report);

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// Matches the cavities of several answers, and prints them side by side.
#include "app/cli/cavities/cavity_comparison.hpp"

#include <algorithm>
#include <iostream>
#include <utility>

#include "app/cli/cavities/cavity_records.hpp"
#include "app/cli/cavities/comparison_columns.hpp"
#include "app/cli/text/printed_columns.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_identity.hpp"
#include "core/document/tables/column_json.hpp"
#include "core/molecule/molecule.hpp"
#include "core/predicates/wide_int.hpp"
#include "core/radii/radii_set.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {
namespace {

std::vector<std::size_t> rows_of(const CavityTable& table) {
  std::vector<std::size_t> rows(table.size());
  for (std::size_t row = 0; row < table.size(); ++row) rows[table.order[row]] = row;
  return rows;
}

double volume(const CavityAnswer& answer, std::size_t row) {
  return answer.table().measure(row).volume_sa_angstrom3;
}

}  // namespace

CavityComparison::Match CavityComparison::match(const CavityAnswer& first,
                                                const CavityAnswer& other,
                                                const CancelToken& cancel) {
  const CavityMatch found = match_cavities(first.table(), other.table(), cancel);
  const std::vector<std::size_t> rows = rows_of(other.table()), first_rows = rows_of(first.table());
  Match match;
  for (std::size_t row = 0; row < first.table().size(); ++row) {
    const std::uint32_t earlier = first.table().order[row];
    const std::uint32_t later = found.goes_to[earlier];
    Counterpart counterpart;
    if (later != CavityMatch::kNone) {
      counterpart.row = rows[later];
      counterpart.same = found.is_same(later) && found.came_from[later] == earlier;
      counterpart.parts = std::max<std::size_t>(1, found.parts(earlier).size());
    }
    match.of_first.push_back(counterpart);
  }
  for (std::size_t row = 0; row < other.table().size(); ++row) {
    const std::uint32_t later = other.table().order[row];
    match.first_ids.push_back(found.is_same(later) ? first_rows[found.came_from[later]] + 1 : 0);
  }
  return match;
}

CavityComparison::CavityComparison(std::vector<CavityAnswer> answers, const RunContext& context)
    : answers_(std::move(answers)) {
  WorkThreads threads(answers_.front().request.threads);
  threads.run([&] {
    for (const CavityAnswer& answer : answers_) {
      matches_.push_back(match(answers_.front(), answer, context.cancel));
    }
  });
}

Counterpart CavityComparison::counterpart(std::size_t answer, std::size_t first_row) const {
  return matches_[answer].of_first[first_row];
}

std::size_t CavityComparison::first_id(std::size_t answer, std::size_t row) const {
  return matches_[answer].first_ids[row];
}

std::optional<double> CavityComparison::spread_percent(std::size_t first_row) const {
  double least = volume(answers_.front(), first_row), most = least;
  std::size_t number = 0;
  for (std::size_t n = 0; n < answers_.size(); ++n) {
    const Counterpart other = counterpart(n, first_row);
    if (!other.row || !other.same) continue;
    least = std::min(least, volume(answers_[n], *other.row));
    most = std::max(most, volume(answers_[n], *other.row));
    ++number;
  }
  if (number < 2 || !(most > 0)) return std::nullopt;
  return 100 * (most - least) / most;
}

std::string variant_text(const CavityAnswer& answer) {
  return std::string(radii_set_info(answer.input.prepared().report.radii).id) + " " +
         shortest_number(answer.request.solvent_radius_angstrom);
}

namespace {

std::string cell(const CavityComparison& comparison, std::size_t n, std::size_t first_row) {
  const Counterpart other = comparison.counterpart(n, first_row);
  if (!other.row) return "gone";
  const CavityAnswer& answer = comparison.answers()[n];
  if (!other.same) {
    const std::size_t id = comparison.first_id(n, *other.row);
    return id ? "in #" + std::to_string(id) : "joined";
  }
  const std::string number = format_text("%.3f", volume(answer, *other.row));
  return other.parts > 1 ? number + " /" + std::to_string(other.parts) : number;
}

void print_variants(const CavityComparison& comparison) {
  constexpr PrintedColumn kPrinted[] = {{"variant", 18, true},
                                        {"voids", 6},
                                        {"pockets", 7},
                                        {"mouths", 6},
                                        {"volume_of_voids", 15},
                                        {"volume_of_pockets", 13},
                                        {"new", 6},
                                        {"choices", 0, true}};
  const PrintedTable<ComparedVariant> table(variant_columns(), kPrinted);
  std::cout << table.heading();
  for (std::size_t n = 0; n < comparison.answers().size(); ++n) {
    std::cout << table.line(ComparedVariant{comparison, n});
  }
}

// Prints the cavities of the first answer. The volumes in each answer are a column, before the last
// two columns.
void print_side_by_side(const CavityComparison& comparison, std::size_t shown) {
  constexpr PrintedColumn kPrinted[] = {
      {"id", 4},
      {"kind", 6, true},
      {.id = "spread_percent", .width = 7, .decimals = 0, .none = ""},
      {"name", 0, true}};
  const PrintedTable<ComparedCavity> table(compared_cavity_columns(), kPrinted);
  std::vector<TableColumn> headings = table.columns();
  std::size_t at = 2;
  for (const CavityAnswer& answer : comparison.answers()) {
    headings.insert(headings.begin() + static_cast<std::ptrdiff_t>(at++),
                    {variant_text(answer), 14});
  }
  const Table wide(headings);
  std::cout << wide.heading();
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t row = comparison.answers().front().rows[k];
    std::vector<std::string> cells = table.cells(ComparedCavity{comparison, row});
    for (std::size_t n = 0; n < comparison.answers().size(); ++n) {
      cells.insert(cells.begin() + static_cast<std::ptrdiff_t>(2 + n), cell(comparison, n, row));
    }
    std::cout << wide.line(cells);
  }
}

}  // namespace

void print_comparison(const CavityComparison& comparison, const CavitiesOptions& options) {
  const CavityAnswer& first = comparison.answers().front();
  std::cout << input_text(first.input) << "sha256      " << first.input.molecule().sha256 << "\n"
            << "alpha       " << shortest_number(first.request.alpha_angstrom2) << " Å²\n";
  print_variants(comparison);
  const std::size_t shown = std::min(first.rows.size(), static_cast<std::size_t>(options.shown));
  if (shown > 0) print_side_by_side(comparison, shown);
  if (verbosity() != Verbosity::quiet && shown > 0) {
    std::cout
        << "Rows are the cavities of the first column. \"/2\": the cavity has split into 2 parts, "
           "and the largest is listed. \"in #3\": it has merged into cavity 3. new: cavities that "
           "the first column lacks. spread: difference of the volumes in per cent of the largest\n";
  }
  std::cout << std::flush;
}

Json comparison_json(const CavityComparison& comparison, const CavitiesOptions& options) {
  Json variants = Json::array(), side_by_side = Json::array();
  for (const CavityAnswer& answer : comparison.answers()) {
    Json variant{{"variant", variant_text(answer)}};
    variant.update(result_json(answer, options));
    variants.push_back(std::move(variant));
  }
  const CavityAnswer& first = comparison.answers().front();
  for (const std::size_t row : first.rows) {
    Json in = Json::array();
    for (std::size_t n = 0; n < comparison.answers().size(); ++n) {
      add_keys_up_to(in.emplace_back(Json::object()), counterpart_columns(),
                     ComparedCounterpart{comparison, n, row});
    }
    Json& cavity = side_by_side.emplace_back(Json::object());
    add_keys_up_to(cavity, compared_cavity_columns(), ComparedCavity{comparison, row});
    cavity["in"] = in;
  }
  return {{"variants", variants}, {"side_by_side", side_by_side}};
}

}  // namespace alphascope::cli

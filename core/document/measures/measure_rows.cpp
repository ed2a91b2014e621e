// SPDX-License-Identifier: GPL-3.0-or-later
// Makes rows of groups, filters and sorts them.
#include "core/document/measures/measure_rows.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/document/measures/measure_columns.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/store/answer.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/document/tables/column.hpp"
#include "core/engine/known_results.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/atom_groups.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

AtomGrouping grouping(MeasureGrouping per) {
  if (per == MeasureGrouping::atom) return AtomGrouping::atom;
  return per == MeasureGrouping::residue ? AtomGrouping::residue : AtomGrouping::chain;
}

struct Groups {
  std::vector<std::uint32_t> of_ball;
  std::size_t count = 0;
};
Groups groups_of(MeasureGrouping per, const Molecule& molecule,
                 const std::vector<std::uint32_t>& atom_of_ball, const Components& components) {
  if (per == MeasureGrouping::all) {
    return {std::vector<std::uint32_t>(atom_of_ball.size(), 0), 1};
  }
  if (per == MeasureGrouping::component) return {components.of_ball, components.count};
  AtomGroups groups = atom_groups(molecule, atom_of_ball, grouping(per));
  const std::size_t count = groups.size();
  return {std::move(groups.of_ball), count};
}

std::string row_name(MeasureGrouping per, const Molecule& molecule, std::size_t atom) {
  if (per == MeasureGrouping::all) return "";
  if (per == MeasureGrouping::component) return atom_address(molecule, atom);
  return group_name(molecule, atom, grouping(per));
}

double share(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

// Rows in the order of the molecule, complete except for names.
std::vector<MeasureRow> rows_of(const Groups& groups, const MeasuredComplex& measured) {
  const UnionMeasures& m = measured.measures();
  const auto sums = [&](const std::vector<double>& values) {
    return sums_by_group(values, groups.of_ball, groups.count);
  };
  PerQuantity<std::vector<double>> of;
  each_quantity([&](MeasuredQuantity q) { of[q] = sums(m.of_ball[q]); });
  const std::vector<double> free = sums(measured.free_area_angstrom2);
  std::vector<MeasureRow> rows(groups.count);
  for (std::size_t ball = 0; ball < groups.of_ball.size(); ++ball) {
    const std::uint32_t g = groups.of_ball[ball];
    if (g == kNoGroup) continue;
    if (rows[g].atoms++ == 0) rows[g].first_ball = static_cast<std::uint32_t>(ball);
  }
  for (std::size_t g = 0; g < rows.size(); ++g) {
    MeasureRow& row = rows[g];
    row.group = static_cast<std::uint32_t>(g);
    each_quantity([&](MeasuredQuantity q) { row.of[q] = of[q][g]; });
    const double area = row.of[MeasuredQuantity::area];
    row.exposed_share = share(area, free[g]);
    row.share_of_area = share(area, m.area_angstrom2());
    row.share_of_volume = share(row.of[MeasuredQuantity::volume], m.volume_angstrom3());
  }
  return rows;
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
bool contains(const std::string& name, const std::string& part) {
  const auto at = std::search(name.begin(), name.end(), part.begin(), part.end(),
                              [](char a, char b) { return lower(a) == lower(b); });
  return part.empty() || at != name.end();
}

void sort_rows(MeasureRows& table) {
  const Column<MeasuredRow>& column = column_of(measure_columns(), table.query.column);
  std::vector<CellValue> values;
  std::vector<std::size_t> order;
  for (const MeasureRow& row : table.rows) {
    order.push_back(values.size());
    values.push_back(column.value({table, row}));
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (table.query.descending) std::swap(a, b);
    return values[a] < values[b];
  });
  std::vector<MeasureRow> sorted;
  for (const std::size_t row : order) sorted.push_back(std::move(table.rows[row]));
  table.rows = std::move(sorted);
}

std::uint64_t number_of(const MeasureQuery& query) {
  const std::string text = query.filter + '\n' + std::to_string(static_cast<int>(query.per)) + ' ' +
                           query.column + ' ' + (query.descending ? 'd' : '-') +
                           (query.derivatives ? 'c' : '-');
  return std::hash<std::string>()(text) | 1;
}

}  // namespace

MeasureRows make_measure_rows(const MeasureQuery& query, const Molecule& molecule,
                              const std::vector<std::uint32_t>& atom_of_ball,
                              const MeasuredComplex& measured,
                              std::shared_ptr<const UnionDerivatives> derivatives,
                              const RunContext& context) {
  MeasureRows table;
  table.query = query;
  table.derivatives = std::move(derivatives);
  Groups groups = groups_of(query.per, molecule, atom_of_ball, measured.components);
  table.rows = rows_of(groups, measured);
  table.all = table.rows.size();
  table.group_of_ball = std::move(groups.of_ball);
  for (std::size_t n = 0; n < table.rows.size(); ++n) {
    if (n % 4096 == 0) context.cancel.throw_if_cancelled();
    MeasureRow& row = table.rows[n];
    if (row.atoms > 0) row.name = row_name(query.per, molecule, atom_of_ball[row.first_ball]);
  }
  std::erase_if(table.rows,
                [&](const MeasureRow& row) { return !contains(row.name, query.filter); });
  context.cancel.throw_if_cancelled();
  sort_rows(table);
  return table;
}

Definition<MeasureRows> measure_rows(const MeasureQuery& query,
                                     const std::shared_ptr<const Answer>& answer) {
  AnyDefinition about{.id = "measures.rows",
                      .title = "Table of areas and volumes",
                      .made_of = {&union_measures()},
                      .key =
                          [more = number_of(query)](const Inputs& in) {
                            Key key = key_of_balls_and_alpha(in);
                            key.more = more;
                            return key;
                          },
                      .memory =
                          [](const Inputs& in) {
                            const std::uint64_t bytes = 150 * in.balls->size();
                            return MemoryNeed{bytes, bytes};
                          },
                      .lane = Lane::interactive};
  const bool changes = query.derivatives && query.per == MeasureGrouping::atom;
  if (changes) about.made_of.push_back(&union_derivatives());
  return {about, [query, changes, molecule = answer->molecule, prepared = answer->prepared](
                     const Inputs& in, const RunContext& context) {
            return std::make_shared<const MeasureRows>(
                make_measure_rows(query, *molecule, prepared->atom_of_ball, in.of(union_measures()),
                                  changes ? in.share(union_derivatives()) : nullptr, context));
          }};
}

}  // namespace alphascope

// Makes rows of groups, filters and sorts them.
#include "core/document/measures/measure_rows.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/selection/atom_address.hpp"
#include "core/selection/atom_groups.hpp"

namespace alphascope {
namespace {

AtomGrouping grouping(MeasuredPer per) {
  if (per == MeasuredPer::atom) return AtomGrouping::atom;
  return per == MeasuredPer::residue ? AtomGrouping::residue : AtomGrouping::chain;
}

struct Groups {
  std::vector<std::uint32_t> of_ball;
  std::size_t count = 0;
};
Groups groups_of(MeasuredPer per, const Molecule& molecule,
                 const std::vector<std::uint32_t>& atom_of_ball, const Components& components) {
  if (per == MeasuredPer::all) {
    return {std::vector<std::uint32_t>(atom_of_ball.size(), 0), 1};
  }
  if (per == MeasuredPer::component) return {components.of_ball, components.count};
  AtomGroups groups = atom_groups(molecule, atom_of_ball, grouping(per));
  const std::size_t count = groups.size();
  return {std::move(groups.of_ball), count};
}

std::string row_name(MeasuredPer per, const Molecule& molecule, std::size_t atom) {
  if (per == MeasuredPer::all) return "";
  if (per == MeasuredPer::component) return atom_address(molecule, atom);
  return group_name(molecule, atom, grouping(per));
}

double share(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}
double length(const Gradient& g) {
  return std::sqrt(g.x * g.x + g.y * g.y + g.z * g.z);
}

// Rows in the order of the molecule, complete except for names.
std::vector<MeasureRow> rows_of(const Groups& groups, const MeasuredComplex& measured) {
  const UnionMeasures& m = measured.measures();
  const auto sums = [&](const std::vector<double>& values) {
    return sums_by_group(values, groups.of_ball, groups.count);
  };
  const std::vector<double> areas = sums(m.ball_area_angstrom2),
                            volumes = sums(m.ball_volume_angstrom3),
                            free = sums(measured.free_area_angstrom2);
  std::vector<MeasureRow> rows(groups.count);
  for (std::size_t ball = 0; ball < groups.of_ball.size(); ++ball) {
    const std::uint32_t g = groups.of_ball[ball];
    if (g == kNoGroup) continue;
    if (rows[g].atoms++ == 0) rows[g].first_ball = static_cast<std::uint32_t>(ball);
  }
  for (std::size_t g = 0; g < rows.size(); ++g) {
    MeasureRow& row = rows[g];
    row.group = static_cast<std::uint32_t>(g);
    row.area_angstrom2 = areas[g];
    row.volume_angstrom3 = volumes[g];
    row.exposed_share = share(areas[g], free[g]);
    row.share_of_area = share(areas[g], m.area_angstrom2);
    row.share_of_volume = share(volumes[g], m.volume_angstrom3);
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
  const MeasureQuery& query = table.query;
  const auto before = [&](const MeasureRow& a, const MeasureRow& b) {
    if (query.column == MeasureColumn::name) return a.name < b.name;
    return table.value(a, query.column) < table.value(b, query.column);
  };
  if (query.descending) {
    std::stable_sort(table.rows.begin(), table.rows.end(),
                     [&](const MeasureRow& a, const MeasureRow& b) { return before(b, a); });
  } else {
    std::stable_sort(table.rows.begin(), table.rows.end(), before);
  }
}

std::uint64_t number_of(const MeasureQuery& query) {
  const std::string text = query.filter + '\n' + std::to_string(static_cast<int>(query.per)) + ' ' +
                           std::to_string(static_cast<int>(query.column)) + ' ' +
                           (query.descending ? 'd' : '-') + (query.derivatives ? 'c' : '-');
  return std::hash<std::string>()(text) | 1;
}

}  // namespace

double MeasureRows::value(const MeasureRow& row, MeasureColumn column) const {
  const UnionDerivatives* d = derivatives.get();
  const std::size_t ball = row.first_ball;
  switch (column) {
    case MeasureColumn::number:
      return row.group;
    case MeasureColumn::name:
      return 0;
    case MeasureColumn::atoms:
      return row.atoms;
    case MeasureColumn::area:
      return row.area_angstrom2;
    case MeasureColumn::volume:
      return row.volume_angstrom3;
    case MeasureColumn::exposed:
      return row.exposed_share;
    case MeasureColumn::area_share:
      return row.share_of_area;
    case MeasureColumn::volume_share:
      return row.share_of_volume;
    case MeasureColumn::area_gradient:
      return d ? length(d->area_by_centre_angstrom[ball]) : 0;
    case MeasureColumn::area_by_radius:
      return d ? d->area_by_radius_angstrom[ball] : 0;
    case MeasureColumn::volume_gradient:
      return d ? length(d->volume_by_centre_angstrom2[ball]) : 0;
    case MeasureColumn::volume_by_radius:
      return d ? d->volume_by_radius_angstrom2[ball] : 0;
  }
  return 0;
}

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

std::vector<std::pair<std::string, double>> measure_values(const MeasureRows& rows,
                                                           const MeasureRow& row) {
  std::vector<std::pair<std::string, double>> values{{"area_angstrom2", row.area_angstrom2},
                                                     {"volume_angstrom3", row.volume_angstrom3},
                                                     {"exposed_share", row.exposed_share},
                                                     {"share_of_area", row.share_of_area},
                                                     {"share_of_volume", row.share_of_volume}};
  if (!rows.derivatives) return values;
  const UnionDerivatives& d = *rows.derivatives;
  const Gradient &area = d.area_by_centre_angstrom[row.first_ball],
                 &volume = d.volume_by_centre_angstrom2[row.first_ball];
  const std::pair<const char*, double> more[] = {
      {"area_by_x_angstrom", area.x},
      {"area_by_y_angstrom", area.y},
      {"area_by_z_angstrom", area.z},
      {"area_by_radius_angstrom", d.area_by_radius_angstrom[row.first_ball]},
      {"volume_by_x_angstrom2", volume.x},
      {"volume_by_y_angstrom2", volume.y},
      {"volume_by_z_angstrom2", volume.z},
      {"volume_by_radius_angstrom2", d.volume_by_radius_angstrom2[row.first_ball]}};
  values.insert(values.end(), std::begin(more), std::end(more));
  return values;
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
  const bool changes = query.derivatives && query.per == MeasuredPer::atom;
  if (changes) about.made_of.push_back(&union_derivatives());
  return {about, [query, changes, molecule = answer->molecule, prepared = answer->prepared](
                     const Inputs& in, const RunContext& context) {
            return std::make_shared<const MeasureRows>(
                make_measure_rows(query, *molecule, prepared->atom_of_ball, in.of(union_measures()),
                                  changes ? in.share(union_derivatives()) : nullptr, context));
          }};
}

}  // namespace alphascope

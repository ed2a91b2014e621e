// The list of the table's columns, the texts and values of their cells, and the order of rows.
#include "ui/panels/cavities/cavity_columns.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/chart/readable_number.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/table_cells.hpp"

namespace alphascope {
namespace {

using C = CavityColumn;

constexpr CavityColumnSpec kColumns[] = {
    {C::rank, "rank", "#", "Its place by falling SA volume, as CASTp numbers cavities.", 34, true},
    {C::kind, "kind", "kind",
     "Nothing can leave a void; a pocket opens to the outside through mouths. Network: a pocket of "
     "twenty mouths or more, which is gaps that are connected rather than one hole. Part: of a "
     "network that is split at its bottlenecks. ↔: it lies between separate bodies, or two chains "
     "line it and no other, each with a fifth of the residues or more. ↕: it has split off or "
     "merged while a slider moved last.",
     100, true},
    {C::volume, "volume", "SA vol. Å³",
     "CASTp's volume of the region of probe centres: not comparable with volumes of KVFinder or "
     "fpocket, nor with MS volumes. A sum over angles, exact for voids; of a pocket it can even be "
     "negative.",
     68, true},
    {C::exact, "exact", "exact Å³",
     "What of the cavity's tetrahedra is really outside all grown balls. * marks cavities below "
     "1 Å³ and those whose SA volume differs by more than a tenth.",
     68, true},
    {C::area, "area", "SA area Å²",
     "CASTp's area of the region of probe centres: of the grown balls' surfaces in it.", 72, true},
    {C::ms_volume, "ms_volume", "MS vol. Å³",
     "CASTp's volume of all that a probe in the cavity reaches with its surface.", 76, false},
    {C::ms_area, "ms_area", "MS area Å²",
     "CASTp's area of all that a probe in the cavity reaches with its surface.", 80, false},
    {C::mouths, "mouths", "mouths",
     "Through how many mouths it opens; a pocket with two or more may be a pore, one with twenty "
     "or more is a network of gaps.",
     58, true},
    {C::mouth_area, "mouth_area", "mouth Å²",
     "The area of all its mouths, outside the grown balls.", 64, false},
    {C::residues, "residues", "residues",
     "How many residues line it: a part of an atom's surface lies in the cavity.", 62, true},
    {C::depth, "depth", "depth Å",
     "How deep the pocket is: the largest distance of a lining atom's centre from the nearest "
     "triangle of a mouth or of a passage to another part. A void has no mouth, so its depth is –.",
     58, true},
    {C::born, "born", "born at Å²",
     "The α from which on it is a cavity of its own; below, it is part of a deeper one. −∞: at "
     "every lower α.",
     66, false},
    {C::gone, "gone", "gone at Å²", "The α at which its deepest point is filled, and it is gone.",
     66, false},
    {C::bottleneck, "bottleneck", "bottleneck Å",
     "The radius of the largest ball that gets out of its widest place, by true clearance from the "
     "atoms as they are, without solvent radius. Of the 100 largest cavities; it takes many "
     "seconds in the background.",
     94, false},
    {C::holds, "holds", "holds",
     "Ligands, ions and waters that are no part of the body and have most of their atoms in it.",
     60, true},
    {C::name, "name", "name: atoms of the deepest point",
     "It stays while α moves, whatever the number of the line: use it in a paper.", 200, false},
};

constexpr double kUnknown = -std::numeric_limits<double>::infinity();

double exact_volume(const CavityRows& rows, std::size_t row) {
  return rows.exact->of[rows.table().order[row]].volume_sa_angstrom3;
}

// Returns the alpha at which the cavity is born or gone, Å².
double life_value(const CavityRows& rows, C column, std::size_t row) {
  const CavityLife& life = rows.lives->of(rows.table().cavity(row).deepest_sink);
  return rows.table().ground->balls->lattice.square_angstrom(column == C::born ? life.born
                                                                               : life.gone);
}

// Marks an exact volume that differs much from CASTp's sum. If a ball pokes through the mouth of a
// pocket, the sum is not its volume.
std::string exact_text_of(const CavityRows& rows, std::size_t row) {
  const double exact = exact_volume(rows, row);
  const bool doubtful = is_doubtful(rows.lines->of[row].volume_sa_angstrom3, exact);
  return measure_text(exact) + (doubtful ? " *" : "  ");
}

// Returns null if the cavity is not among the largest.
const Bottleneck* bottleneck_of(const CavityRows& rows, std::size_t row) {
  const auto& known = rows.bottlenecks->rows;
  return row < known.size() ? &known[row] : nullptr;
}

std::string bottleneck_text(const CavityRows& rows, std::size_t row) {
  const Bottleneck* b = bottleneck_of(rows, row);
  if (!b || b->kind == Bottleneck::Kind::covered) return "–";
  return b->is_open() ? measure_text(b->radius_angstrom) : "closed";
}

std::string holds_text(const CavityRows& rows, std::size_t row) {
  return contents_text(rows.lines->atoms->molecule(), *rows.contents, rows.table().order[row]);
}

bool is_known(const CavityRows& rows, C column) {
  switch (column) {
    case C::exact:
      return rows.exact != nullptr;
    case C::depth:
      return rows.depths != nullptr;
    case C::born:
    case C::gone:
      return rows.lives != nullptr;
    case C::bottleneck:
      return rows.bottlenecks != nullptr;
    case C::holds:
      return rows.contents != nullptr;
    default:
      return true;
  }
}

}  // namespace

std::span<const CavityColumnSpec> cavity_columns() {
  return kColumns;
}

double cavity_value(const CavityRows& rows, C column, std::size_t row) {
  if (!is_known(rows, column)) return kUnknown;
  const CavityLine& line = rows.lines->of[row];
  switch (column) {
    case C::kind:
      return line.is_void ? 0 : 1;
    case C::volume:
      return line.volume_sa_angstrom3;
    case C::exact:
      return exact_volume(rows, row);
    case C::area:
      return line.area_sa_angstrom2;
    case C::ms_volume:
      return line.volume_ms_angstrom3;
    case C::ms_area:
      return line.area_ms_angstrom2;
    case C::mouths:
      return static_cast<double>(line.mouths);
    case C::mouth_area:
      return line.mouth_area_angstrom2;
    case C::residues:
      return static_cast<double>(line.lining.residues);
    case C::depth:
      return rows.depths->of_angstrom[row];
    case C::born:
    case C::gone:
      return life_value(rows, column, row);
    case C::bottleneck: {
      const Bottleneck* b = bottleneck_of(rows, row);
      return b && b->is_open() ? b->radius_angstrom : kUnknown;
    }
    case C::holds:  // number of things held
      return static_cast<double>(rows.contents->of[rows.table().order[row]].size());
    default:
      return static_cast<double>(row);
  }
}

std::string cavity_text(const CavityRows& rows, C column, std::size_t row) {
  if (!is_known(rows, column)) return "…";
  const CavityLine& line = rows.lines->of[row];
  const double value = cavity_value(rows, column, row);
  switch (column) {
    case C::rank:
    case C::kind:
    case C::name:
      return "";
    case C::exact:
      return exact_text_of(rows, row);
    case C::mouths:
    case C::residues:
      return with_separators(static_cast<long long>(value));
    case C::mouth_area:
    case C::depth:
      return line.is_void ? "–" : measure_text(value);
    case C::bottleneck:
      return bottleneck_text(rows, row);
    case C::holds:
      return holds_text(rows, row);
    case C::born:
      return std::isinf(value) ? "−∞" : measure_text(value);
    default:
      return measure_text(value);
  }
}

std::vector<std::size_t> ordered_rows(const CavityRows& rows, const CavityFilter& filter) {
  const auto column = static_cast<CavityColumn>(filter.sort_column);
  std::vector<std::size_t> order;
  std::vector<double> values(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (!filter.shows(rows.lines->of[row])) continue;
    order.push_back(row);
    values[row] = cavity_value(rows, column, row);
  }
  const CavityTable* table = rows.lines ? rows.lines->table.get() : nullptr;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (filter.descending) std::swap(a, b);
    // Sinks follow the order of atoms in the file, and names are made of these atoms.
    return column == CavityColumn::name ? table->sink(a) < table->sink(b) : values[a] < values[b];
  });
  return order;
}

}  // namespace alphascope

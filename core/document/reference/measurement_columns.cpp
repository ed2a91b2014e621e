// SPDX-License-Identifier: GPL-3.0-or-later
// The list of columns of measured distances and angles, and how a row gives their values.
#include "core/document/reference/measurement_columns.hpp"

#include <cstdint>

#include "core/document/tables/cell_value.hpp"
#include "core/document/tables/column.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/atom_address.hpp"
#include "core/write/csv.hpp"

namespace alphascope {
namespace {

using Row = MeasurementRow;

// The address of an atom, counted from 0; empty if there is no such atom.
template <std::size_t N>
CellValue atom(const Row& r) {
  if (!r.of || N >= r.of->atoms.size()) return {};
  return atom_address(r.molecule, r.of->atoms[N]);
}

CellValue between(const Row& r) {
  std::string text;
  if (!r.of) return text;
  for (const std::size_t index : r.of->atoms) {
    text += (text.empty() ? "" : " – ") + atom_address(r.molecule, index);
  }
  return text;
}

const Column<Row> kColumns[] = {
    {.id = "number",
     .title = "#",
     .help = "The number in the list.",
     .value = [](const Row& r) -> CellValue { return std::uint64_t{r.number}; },
     .files = InFiles::csv},
    {.id = "kind",
     .title = "what",
     .help = "“distance”, “angle” or “dihedral angle”.",
     .value = [](const Row& r) -> CellValue { return measurement_name(r.measurement); },
     .text = [](const Row& r) -> std::string {
       return r.measurement.atoms.size() == 4 ? "dihedral" : measurement_name(r.measurement);
     },
     .files = InFiles::csv},
    {.id = "between",
     .title = "between",
     .help = "The addresses of the atoms.",
     .value = between,
     .files = InFiles::none},
    {.id = "value",
     .title = "value",
     .help = "The distance in Å, or the angle in degrees. It is empty where points coincide or lie "
             "on a line, and where the molecule lacks an atom.",
     .value = [](const Row& r) -> CellValue {
       return r.of && r.of->value ? CellValue(*r.of->value) : CellValue();
     },
     .files = InFiles::csv},
    {.id = "unit",
     .title = "unit",
     .help = "“angstrom” or “degree”.",
     .value = [](const Row& r) -> CellValue {
       return r.measurement.atoms.size() == 2 ? "angstrom" : "degree";
     },
     .files = InFiles::csv},
    {.id = "atom_1",
     .title = "atom 1",
     .help = "The address of the first atom.",
     .value = atom<0>,
     .files = InFiles::csv},
    {.id = "atom_2",
     .title = "atom 2",
     .help = "The address of the second atom.",
     .value = atom<1>,
     .files = InFiles::csv},
    {.id = "atom_3",
     .title = "atom 3",
     .help = "The address of the third atom; empty for a distance.",
     .value = atom<2>,
     .files = InFiles::csv},
    {.id = "atom_4",
     .title = "atom 4",
     .help = "The address of the fourth atom of a dihedral angle; else empty.",
     .value = atom<3>,
     .files = InFiles::csv}};

}  // namespace

std::span<const Column<MeasurementRow>> measurement_columns() {
  return kColumns;
}

std::string measurements_csv(const Molecule& molecule, const Measurements& measurements) {
  std::string text;
  for (std::size_t n = 0; n < measurements.size(); ++n) {
    if (n == 0) text = csv_heading(measurement_columns());
    text += csv_values(csv_row_of(measurement_columns(), {molecule, measurements[n], n + 1}));
  }
  return text;
}

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// The list of columns of the table of areas and volumes, and how a row gives their values.
#include "core/document/measures/measure_columns.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/document/measures/measure_names.hpp"
#include "core/document/measures/measure_records.hpp"
#include "core/document/settings/request_columns.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/selection/provenance.hpp"

namespace alphascope {
namespace {

using Row = MeasuredRow;

std::string percent(double share) {
  return measure_text(100 * share);
}
CellValue name(const Row& r) {
  return r.row.name;
}
bool has_derivatives(const Row& r) {
  return r.rows.derivatives != nullptr;
}

using Gradients = std::vector<Gradient> UnionDerivatives::*;
const Gradient& gradient(const Row& r, Gradients of) {
  return ((*r.rows.derivatives).*of)[r.row.first_ball];
}
// The derivative along the direction in which the quantity grows most.
CellValue steepest(const Row& r, Gradients of) {
  if (!has_derivatives(r)) return {};
  const Gradient& g = gradient(r, of);
  return std::sqrt(g.x * g.x + g.y * g.y + g.z * g.z);
}
constexpr Gradients kArea = &UnionDerivatives::area_by_centre_angstrom,
                    kVolume = &UnionDerivatives::volume_by_centre_angstrom2;

const Request& request_of(const Row& r) {
  return r.facts->answer->request;
}

const Column<Row> kColumns[] = {
    {.id = "model",
     .title = "model",
     .help = "The model of the file, from 1; “joined” for all models as one.",
     .value = [](const Row& r) -> CellValue { return model_text(r.facts->source.options.model); },
     .files = InFiles::csv},
    {.id = "number",
     .title = "#",
     .help = "The order of the molecule.",
     .value = [](const Row& r) -> CellValue { return std::uint64_t{r.row.group} + 1; },
     .files = InFiles::none},
    {.id = "group",
     .title = "group",
     .help = "Chain, residue and atom. A component has the name of its first atom.",
     .value = name,
     .files = InFiles::csv},
    {.id = "name",
     .title = "name",
     .help = "Chain, residue and atom. A component has the name of its first atom.",
     .value = name,
     .files = InFiles::json},
    {.id = "atoms",
     .title = "atoms",
     .help = "The number of atoms of the row that are balls.",
     .value = [](const Row& r) -> CellValue { return std::uint64_t{r.row.atoms}; }},
    {.id = "area_angstrom2",
     .title = "area",
     .unit = "Å²",
     .help = "The part of the surface that lies on the balls of these atoms, outside all others.",
     .value = [](const Row& r) -> CellValue { return r.row.of[MeasuredQuantity::area]; }},
    {.id = "volume_angstrom3",
     .title = "volume",
     .unit = "Å³",
     .help = "The part of the union's volume whose points have the least power distance from these "
             "atoms. The parts add up to the whole volume.",
     .value = [](const Row& r) -> CellValue { return r.row.of[MeasuredQuantity::volume]; }},
    {.id = "exposed_share",
     .title = "exposed %",
     .help = "The area, as a share of the whole spheres of these atoms: 0 is buried. Files have 0 "
             "to 1.",
     .value = [](const Row& r) -> CellValue { return r.row.exposed_share; },
     .text = [](const Row& r) { return percent(r.row.exposed_share); }},
    {.id = "share_of_area",
     .title = "% of all",
     .help = "Its share of the whole surface. Files have 0 to 1.",
     .value = [](const Row& r) -> CellValue { return r.row.share_of_area; },
     .text = [](const Row& r) { return percent(r.row.share_of_area); }},
    {.id = "share_of_volume",
     .title = "% of all",
     .help = "Its share of the whole volume. Files have 0 to 1.",
     .value = [](const Row& r) -> CellValue { return r.row.share_of_volume; },
     .text = [](const Row& r) { return percent(r.row.share_of_volume); }},
    {.id = "arc_length_angstrom",
     .title = "arcs",
     .unit = "Å",
     .help = "The length of the arcs on the surface in which two spheres meet. Each of the two "
             "balls has half of an arc.",
     .value = [](const Row& r) -> CellValue { return r.row.of[MeasuredQuantity::arc_length]; }},
    {.id = "area_by_shift_angstrom",
     .title = "area/shift",
     .unit = "Å",
     .help = "How fast the whole area grows when the atom is shifted in the direction in which it "
             "grows most, in Å² for each Å.",
     .value = [](const Row& r) { return steepest(r, kArea); },
     .files = InFiles::none},
    {.id = "area_by_x_angstrom",
     .title = "area/x",
     .unit = "Å",
     .help = "The derivative of the whole area along x of the atom's centre.",
     .value = [](const Row& r) -> CellValue { return gradient(r, kArea).x; },
     .shown_if = has_derivatives},
    {.id = "area_by_y_angstrom",
     .title = "area/y",
     .unit = "Å",
     .help = "The derivative of the whole area along y.",
     .value = [](const Row& r) -> CellValue { return gradient(r, kArea).y; },
     .shown_if = has_derivatives},
    {.id = "area_by_z_angstrom",
     .title = "area/z",
     .unit = "Å",
     .help = "The derivative of the whole area along z.",
     .value = [](const Row& r) -> CellValue { return gradient(r, kArea).z; },
     .shown_if = has_derivatives},
    {.id = "area_by_radius_angstrom",
     .title = "area/radius",
     .unit = "Å",
     .help = "How fast the whole area grows with the atom's radius, in Å² for each Å.",
     .value = [](const Row& r) -> CellValue {
       if (!has_derivatives(r)) return {};
       return r.rows.derivatives->area_by_radius_angstrom[r.row.first_ball];
     },
     .shown_if = has_derivatives},
    {.id = "volume_by_shift_angstrom2",
     .title = "vol./shift",
     .unit = "Å²",
     .help = "How fast the whole volume grows when the atom is shifted in the direction in which "
             "it grows most, in Å³ for each Å.",
     .value = [](const Row& r) { return steepest(r, kVolume); },
     .files = InFiles::none},
    {.id = "volume_by_x_angstrom2",
     .title = "vol./x",
     .unit = "Å²",
     .help = "The derivative of the whole volume along x of the atom's centre.",
     .value = [](const Row& r) -> CellValue { return gradient(r, kVolume).x; },
     .shown_if = has_derivatives},
    {.id = "volume_by_y_angstrom2",
     .title = "vol./y",
     .unit = "Å²",
     .help = "The derivative of the whole volume along y.",
     .value = [](const Row& r) -> CellValue { return gradient(r, kVolume).y; },
     .shown_if = has_derivatives},
    {.id = "volume_by_z_angstrom2",
     .title = "vol./z",
     .unit = "Å²",
     .help = "The derivative of the whole volume along z.",
     .value = [](const Row& r) -> CellValue { return gradient(r, kVolume).z; },
     .shown_if = has_derivatives},
    {.id = "volume_by_radius_angstrom2",
     .title = "vol./radius",
     .unit = "Å²",
     .help = "How fast the whole volume grows with the atom's radius, in Å³ for each Å.",
     .value = [](const Row& r) -> CellValue {
       if (!has_derivatives(r)) return {};
       return r.rows.derivatives->volume_by_radius_angstrom2[r.row.first_ball];
     },
     .shown_if = has_derivatives},
    {.id = "surface",
     .title = "surface",
     .help = "The name of the surface, such as “van der Waals surface”.",
     .value = [](const Row& r) -> CellValue { return surface_name(r.facts->answer->request); },
     .files = InFiles::csv},
    {.id = "measured_by",
     .title = "measured by",
     .help = "The device that measured.",
     .value = [](const Row& r) -> CellValue { return r.facts->measured->by->device; },
     .files = InFiles::csv},
    kRequestedAlpha<Row, request_of>,
    kRequestedSolvent<Row, request_of>,
    {.id = "hash",
     .title = "hash",
     .help = "The hash of the complex.",
     .value = [](const Row& r) -> CellValue { return hash_text(r.facts->answer->complex.hash); },
     .files = InFiles::csv}};

}  // namespace

std::span<const Column<MeasuredRow>> measure_columns() {
  return kColumns;
}

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// The list of columns of the table of cavities, and how a row gives their values. Nested values of
// JSON are in cavity_json.cpp.
#include "core/document/cavities/cavity_columns.hpp"

#include <cmath>
#include <cstdint>
#include <string>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_measures.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/cavity_identity/network_radius.hpp"
#include "core/channel/bottlenecks.hpp"
#include "core/document/cavities/cavity_bottlenecks.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_records.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/known_cavities.hpp"
#include "core/document/export/program_name.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/request_columns.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/molecule/element.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/provenance.hpp"

namespace alphascope {
namespace {

using Row = CavityRow;

const CavityMeasures& measures(const Row& r) {
  return r.of.table().measure(r.row);
}
const Cavity& cavity(const Row& r) {
  return r.of.table().cavity(r.row);
}
CellValue count(std::size_t number) {
  return static_cast<std::uint64_t>(number);
}

CellValue exact_value(const Row& r, double ExactCavityMeasures::*value) {
  return r.of.exact ? CellValue(r.of.exact_measures(r.row).*value) : CellValue();
}

// Marks an exact volume that differs much from CASTp's sum. If a ball pokes through the mouth of a
// pocket, the sum is not its volume.
std::string exact_text(const Row& r) {
  if (!r.of.exact) return "…";
  return measure_text(r.of.exact_measures(r.row).volume_sa_angstrom3) +
         (r.of.differs_from_exact(r.row) ? " *" : "  ");
}

CellValue network_end(const Row& r, std::string (*text)(const NetworkEnd&)) {
  const NetworkEnd* end = r.facts->network_end(r.row);
  return end ? CellValue(text(*end)) : CellValue();
}

CellValue depth(const Row& r) {
  return r.of.depths ? CellValue(r.of.depths->of_angstrom[r.row]) : CellValue();
}

// A void has no mouth, so it has neither an area of mouths nor a depth.
std::string dash_of_void(const Row& r, const CellValue& value) {
  return cavity(r).is_void() && value.index() != 0 ? "–" : readable_cell(value);
}

CellValue born(const Row& r) {
  return r.of.lives ? CellValue(r.of.life(r.row).born) : CellValue();
}
CellValue closed(const Row& r) {
  if (!r.of.lives) return {};
  const KnownCavities::Life life = r.of.life(r.row);
  return life.closes ? CellValue(life.closed) : CellValue();
}

// Returns null if the cavity is not among the largest.
const Bottleneck* bottleneck_of(const Row& r) {
  if (!r.of.bottlenecks) return nullptr;
  const auto& known = r.of.bottlenecks->rows;
  return r.row < known.size() ? &known[r.row] : nullptr;
}
CellValue bottleneck(const Row& r) {
  const Bottleneck* b = bottleneck_of(r);
  return b && b->is_open() ? CellValue(b->radius_angstrom) : CellValue();
}
std::string bottleneck_text(const Row& r) {
  if (!r.of.bottlenecks) return "…";
  const Bottleneck* b = bottleneck_of(r);
  if (!b || b->kind == Bottleneck::Kind::covered) return "–";
  return b->is_open() ? measure_text(b->radius_angstrom) : "closed";
}

// The share of nitrogen and oxygen among the lining atoms that are no hydrogens. None if there is
// no such atom, or if an element is unknown.
CellValue polar_percent(const Row& r) {
  constexpr Element kNitrogen = 7, kOxygen = 8;
  std::size_t heavy = 0, polar = 0;
  for (const BallIndex ball : measures(r).lining) {
    const Element element =
        r.of.atoms->molecule().atoms[r.of.atoms->prepared().atom_of_ball[ball]].element;
    if (element == kUnknownElement) return {};
    heavy += element != kHydrogen;
    polar += element == kNitrogen || element == kOxygen;
  }
  if (heavy == 0) return {};
  return 100.0 * static_cast<double>(polar) / static_cast<double>(heavy);
}

std::string residues_text(const Row& r) {
  std::string text;
  for (const LiningResidue& residue : lining_residues(*r.of.atoms, r.of.table(), r.row)) {
    text += (text.empty() ? "" : "; ") + residue.address;
  }
  return text;
}

const Request& request_of(const Row& r) {
  return r.facts->request;
}

const Column<Row> kColumns[] = {
    {.id = "model",
     .title = "model",
     .help = "The model of the file, from 1; “joined” for all models as one.",
     .value = [](const Row& r) -> CellValue { return model_text(r.facts->source.options.model); },
     .files = InFiles::csv},
    {.id = "id",
     .title = "#",
     .help = "The rank by SA volume, as CASTp numbers cavities: 1 is the largest.",
     .value = [](const Row& r) { return count(r.row + 1); }},
    {.id = "first_id",
     .title = "first #",
     .help = "The id of the same cavity with the first radii and solvent radius. It is empty where "
             "there is none.",
     .value = [](const Row& r) { return r.first_id ? count(r.first_id) : CellValue(); },
     .files = InFiles::csv},
    {.id = "kind",
     .title = "kind",
     .help = "A void is closed on all sides. A pocket opens to the outside through mouths. A "
             "network is a pocket of twenty mouths or more: connected gaps rather than one hole. A "
             "part belongs to a network that is split at its bottlenecks.",
     .value = [](const Row& r) -> CellValue { return r.of.kind(r.row); }},
    {.id = "name",
     .title = "name: atoms of the deepest point",
     .help = "The four atoms around its deepest point. The name stays while α moves, whatever the "
             "number of the line: use it in a paper.",
     .value = [](const Row& r) -> CellValue { return r.of.name(r.row); }},
    {.id = "volume_sa_angstrom3",
     .title = "SA vol.",
     .unit = "Å³",
     .help = "CASTp's volume of the region that the probe's centre can reach. It cannot be "
             "compared with MS volumes, or with volumes of KVFinder or fpocket. CASTp's sum is "
             "exact for voids; for a pocket it can be wrong and even negative.",
     .value = [](const Row& r) -> CellValue { return measures(r).volume_sa_angstrom3; }},
    {.id = "area_sa_angstrom2",
     .title = "SA area",
     .unit = "Å²",
     .help = "CASTp's area of the surfaces of the grown balls in the region that the probe's "
             "centre can reach.",
     .value = [](const Row& r) -> CellValue { return measures(r).area_sa_angstrom2; }},
    {.id = "volume_sa_clipped_angstrom3",
     .title = "exact",
     .unit = "Å³",
     .help = "The volume of the cavity's tetrahedra outside all grown balls. A star marks cavities "
             "below 1 Å³ and those whose SA volume differs by more than a tenth.",
     .value =
         [](const Row& r) { return exact_value(r, &ExactCavityMeasures::volume_sa_angstrom3); },
     .text = exact_text},
    {.id = "area_sa_clipped_angstrom2",
     .title = "exact area",
     .unit = "Å²",
     .help = "The area of the grown balls' surfaces in the cavity's tetrahedra, outside all other "
             "balls.",
     .value = [](const Row& r) { return exact_value(r, &ExactCavityMeasures::area_sa_angstrom2); }},
    {.id = "rank_by_clipped_volume",
     .title = "rank",
     .help = "The rank by exact volume: 1 is the largest.",
     .value =
         [](const Row& r) { return r.of.exact ? count(r.facts->exact_rank[r.row]) : CellValue(); }},
    {.id = "doubtful",
     .help = "The exact volume is below 1 Å³, or the SA volume differs from it by more than a "
             "tenth.",
     .value =
         [](const Row& r) {
           return r.of.exact ? CellValue(r.of.differs_from_exact(r.row)) : CellValue();
         }},
    {.id = "volume_ms_angstrom3",
     .title = "MS vol.",
     .unit = "Å³",
     .help = "CASTp's volume of all that a probe in the cavity reaches with its surface.",
     .value = [](const Row& r) -> CellValue { return measures(r).volume_ms_angstrom3; }},
    {.id = "area_ms_angstrom2",
     .title = "MS area",
     .unit = "Å²",
     .help = "CASTp's area of all that a probe in the cavity reaches with its surface.",
     .value = [](const Row& r) -> CellValue { return measures(r).area_ms_angstrom2; }},
    {.id = "area_ms_steiner_angstrom2",
     .title = "MS area, Steiner",
     .unit = "Å²",
     .help = "The MS area by Steiner's formula. Where a torus meets itself it counts that part as "
             "negative, and CASTp as positive.",
     .value = [](const Row& r) -> CellValue { return measures(r).area_ms_steiner_angstrom2; }},
    {.id = "volume_of_tetrahedra_angstrom3",
     .title = "tetrahedra",
     .unit = "Å³",
     .help = "The volume of the cavity's tetrahedra, with the parts of balls in them.",
     .value = [](const Row& r) -> CellValue { return measures(r).volume_of_tetrahedra_angstrom3; }},
    {.id = "mouths",
     .title = "mouths",
     .help = "The number of mouths. A pocket with two or more may be a pore; one with twenty or "
             "more is a network of gaps.",
     .value = [](const Row& r) { return count(measures(r).mouths.size()); }},
    {.id = "network",
     .title = "network",
     .help = "The cavity is a network: a pocket of twenty mouths or more.",
     .value = [](const Row& r) -> CellValue { return cavity(r).is_network(); }},
    {.id = "falls_apart_alpha_angstrom2",
     .title = "falls apart at α",
     .unit = "Å²",
     .help = "The alpha, to 0.01 Å², at which the network has fallen apart: none of the cavities "
             "left of it is a network. It is empty where that is not known.",
     .value = [](const Row& r) { return network_end(r, alpha_text); },
     .files = InFiles::csv},
    {.id = "falls_apart_solvent_radius_angstrom",
     .title = "falls apart at radius",
     .unit = "Å",
     .help = "The solvent radius, to 0.1 Å, at which the network has fallen apart: none of the "
             "cavities left of it is a network. It is empty where that is not known.",
     .value = [](const Row& r) { return network_end(r, radius_text); },
     .files = InFiles::csv},
    {.id = "part_of",
     .title = "part of",
     .help = "The number of the network that a part belongs to, from 1.",
     .value =
         [](const Row& r) {
           return cavity(r).is_part() ? count(cavity(r).network + 1) : CellValue();
         }},
    {.id = "passages",
     .title = "passages",
     .help = "The number of groups of triangles between a part and other parts.",
     .value = [](const Row& r) { return count(cavity(r).passages.size()); }},
    {.id = "mouth_triangles",
     .title = "mouth triangles",
     .help = "The number of triangles in all mouths.",
     .value = [](const Row& r) { return count(cavity(r).mouth_triangles()); }},
    {.id = "mouth_area_angstrom2",
     .title = "mouth",
     .unit = "Å²",
     .help = "The area of all mouths together, outside the grown balls.",
     .value = [](const Row& r) -> CellValue { return measures(r).all_mouths().area_angstrom2; },
     .text = [](const Row& r) { return dash_of_void(r, measures(r).all_mouths().area_angstrom2); }},
    {.id = "mouth_length_angstrom",
     .title = "mouth rim",
     .unit = "Å",
     .help = "The length of the rims of all mouths together.",
     .value = [](const Row& r) -> CellValue { return measures(r).all_mouths().length_angstrom; }},
    {.id = "depth_angstrom",
     .title = "depth",
     .unit = "Å",
     .help = "The largest distance of a lining atom's centre from the nearest triangle of a mouth "
             "or of a passage to another part. A void has no mouth; files have 0 there.",
     .value = depth,
     .text = [](const Row& r) { return dash_of_void(r, depth(r)); }},
    {.id = "born_alpha_angstrom2",
     .title = "born at",
     .unit = "Å²",
     .help = "The α from which on it is a cavity of its own; below, it is part of a deeper one. It "
             "is minus infinity, and empty in files, if it is one at every lower α.",
     .value = born,
     .text =
         [](const Row& r) {
           return r.of.lives && std::isinf(r.of.life(r.row).born) ? "−∞" : readable_cell(born(r));
         }},
    {.id = "closed_alpha_angstrom2",
     .title = "closed at",
     .unit = "Å²",
     .help = "The α from which on it is a void. It is empty if the cavity never closes.",
     .value = closed},
    {.id = "gone_alpha_angstrom2",
     .title = "gone at",
     .unit = "Å²",
     .help = "The α at which its deepest point is filled, and it is gone.",
     .value =
         [](const Row& r) { return r.of.lives ? CellValue(r.of.life(r.row).gone) : CellValue(); }},
    {.id = "arc_length_angstrom",
     .title = "arcs",
     .unit = "Å",
     .help = "The length of the arcs in which two grown balls meet.",
     .value = [](const Row& r) -> CellValue { return measures(r).arc_length_angstrom; }},
    {.id = "corners",
     .title = "corners",
     .help = "The number of points in which three grown balls meet.",
     .value = [](const Row& r) { return count(measures(r).corners); }},
    {.id = "tetrahedra",
     .title = "tetrahedra",
     .help = "The number of its tetrahedra.",
     .value = [](const Row& r) { return count(cavity(r).tetrahedra.size()); }},
    {.id = "sinks",
     .title = "sinks",
     .help = "The number of its tetrahedra in which the flow ends.",
     .value = [](const Row& r) { return count(cavity(r).sinks); }},
    {.id = "atoms",
     .title = "atoms",
     .help = "The number of atoms that are corners of its tetrahedra.",
     .value = [](const Row& r) { return count(cavity(r).atoms.size()); },
     .files = InFiles::csv},
    {.id = "lining_atoms",
     .title = "lining atoms",
     .help = "The number of atoms that line it: a part of their surface lies in the cavity.",
     .value = [](const Row& r) { return count(measures(r).lining.size()); },
     .files = InFiles::csv},
    {.id = "lining_residues",
     .title = "residues",
     .help = "The number of residues that line it: a part of an atom's surface lies in the cavity.",
     .value = [](const Row& r) { return count(r.of.lining_residues(r.row)); },
     .files = InFiles::none},
    {.id = "polar_lining_percent",
     .title = "polar",
     .unit = "%",
     .help = "The share of nitrogen and oxygen among the lining atoms. Hydrogens do not count. It "
             "is unknown if the file does not give the element of a lining atom.",
     .value = polar_percent,
     .text =
         [](const Row& r) {
           const CellValue value = polar_percent(r);
           return value.index() == 0 ? "–" : readable_cell(value);
         }},
    {.id = "residues",
     .title = "lining",
     .help = "The residues that line it: “A:HIS 87; A:LEU 91”.",
     .value = [](const Row& r) -> CellValue { return residues_text(r); },
     .files = InFiles::csv},
    {.id = "bottleneck_angstrom",
     .title = "bottleneck",
     .unit = "Å",
     .help = "The radius of the largest ball that gets out of its widest place, by true clearance "
             "from the atoms as they are, without solvent radius. It is computed for the 100 "
             "largest cavities only, in the background, which takes many seconds.",
     .value = bottleneck,
     .text = bottleneck_text,
     .files = InFiles::none},
    {.id = "holds",
     .title = "holds",
     .help = "Ligands, ions and waters that are no part of the body and have most of their atoms "
             "in it.",
     .value =
         [](const Row& r) {
           return r.of.contents ? CellValue(r.of.contents_text(r.row)) : CellValue();
         },
     .files = InFiles::csv},
    kRequestedAlpha<Row, request_of>,
    kRequestedSolvent<Row, request_of>,
    {.id = "choices",
     .title = "choices",
     .help = "“comparable with CASTp”, or the choices that differ from CASTp's.",
     .value = [](const Row& r) -> CellValue { return comparable_text(r.facts->differences); },
     .files = InFiles::csv}};

}  // namespace

std::span<const Column<CavityRow>> cavity_columns() {
  return kColumns;
}

}  // namespace alphascope

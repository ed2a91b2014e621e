// SPDX-License-Identifier: GPL-3.0-or-later
// The lists of columns, and their values.
#include "app/cli/cavities/comparison_columns.hpp"

#include <cstdint>
#include <optional>

#include "core/cavity/cavity_table.hpp"

namespace alphascope::cli {
namespace {

CellValue count(std::size_t number) {
  return static_cast<std::uint64_t>(number);
}

const CavityAnswer& answer(const ComparedVariant& v) {
  return v.all.answers()[v.answer];
}
const CavityAnswer& first(const ComparedCavity& c) {
  return c.all.answers().front();
}
Counterpart counterpart(const ComparedCounterpart& c) {
  return c.all.counterpart(c.answer, c.first_row);
}

// Returns how many cavities of an answer match no cavity of the first answer.
std::size_t new_ones(const ComparedVariant& v) {
  std::size_t number = 0;
  for (const std::size_t row : answer(v).rows) number += v.all.first_id(v.answer, row) == 0;
  return number;
}

const Column<ComparedVariant> kVariants[] = {
    {.id = "variant",
     .title = "radii, solvent",
     .unit = "Å",
     .help = "The radii set and the solvent radius.",
     .value = [](const ComparedVariant& v) -> CellValue { return variant_text(answer(v)); },
     .files = InFiles::json},
    {.id = "voids",
     .title = "voids",
     .help = "The number of voids.",
     .value = [](const ComparedVariant& v) { return count(answer(v).table().voids); },
     .files = InFiles::none},
    {.id = "pockets",
     .title = "pockets",
     .help = "The number of pockets.",
     .value = [](const ComparedVariant& v) { return count(answer(v).table().pockets); },
     .files = InFiles::none},
    {.id = "mouths",
     .title = "mouths",
     .help = "The number of mouths.",
     .value = [](const ComparedVariant& v) { return count(answer(v).table().mouths); },
     .files = InFiles::none},
    {.id = "volume_of_voids",
     .title = "SA vol. of voids",
     .unit = "Å³",
     .help = "The SA volume of all voids.",
     .value = [](const ComparedVariant& v) -> CellValue {
       return answer(v).table().volume_sa_angstrom3(true);
     },
     .files = InFiles::none},
    {.id = "volume_of_pockets",
     .title = "of pockets",
     .unit = "Å³",
     .help = "The SA volume of all pockets.",
     .value = [](const ComparedVariant& v) -> CellValue {
       return answer(v).table().volume_sa_angstrom3(false);
     },
     .files = InFiles::none},
    {.id = "new",
     .title = "new",
     .help = "The number of listed cavities that the first variant lacks.",
     .value = [](const ComparedVariant& v) { return count(new_ones(v)); },
     .files = InFiles::none},
    {.id = "choices",
     .help = "“comparable with CASTp”, or the choices that differ from CASTp's.",
     .value = [](const ComparedVariant& v) -> CellValue {
       return comparable_text(answer(v).differences);
     },
     .files = InFiles::none}};

const Column<ComparedCavity> kCavities[] = {
    {.id = "id",
     .title = "#",
     .help = "The id of the cavity in the first variant.",
     .value = [](const ComparedCavity& c) { return count(c.first_row + 1); },
     .files = InFiles::json},
    {.id = "kind",
     .title = "kind",
     .help = "The kind of the cavity in the first variant.",
     .value = [](const ComparedCavity& c) -> CellValue { return first(c).kind(c.first_row); },
     .files = InFiles::none},
    {.id = "name",
     .title = "SA volume in Å³ of (atoms of the deepest point)",
     .help = "The name of the cavity in the first variant.",
     .value = [](const ComparedCavity& c) -> CellValue { return first(c).name(c.first_row); },
     .files = InFiles::json},
    {.id = "spread_percent",
     .title = "spread",
     .unit = "%",
     .help = "The difference of the largest and the smallest SA volume, in per cent of the "
             "largest. Only variants with the same cavity count.",
     .value = [](const ComparedCavity& c) -> CellValue {
       const std::optional<double> spread = c.all.spread_percent(c.first_row);
       return spread ? CellValue(*spread) : CellValue();
     },
     .files = InFiles::json}};

const Column<ComparedCounterpart> kCounterparts[] = {
    {.id = "variant",
     .title = "variant",
     .help = "The radii set and the solvent radius.",
     .value = [](const ComparedCounterpart& c) -> CellValue {
       return variant_text(c.all.answers()[c.answer]);
     },
     .files = InFiles::json},
    {.id = "id",
     .title = "#",
     .help = "The id of the cavity in this variant. Empty if it does not exist there.",
     .value =
         [](const ComparedCounterpart& c) {
           const Counterpart other = counterpart(c);
           return other.row ? count(*other.row + 1) : CellValue();
         },
     .files = InFiles::json},
    {.id = "same",
     .title = "same",
     .help = "False if it has merged into a cavity that is mostly another one.",
     .value = [](const ComparedCounterpart& c) -> CellValue { return counterpart(c).same; },
     .files = InFiles::json},
    {.id = "parts",
     .title = "parts",
     .help = "The number of cavities into which it has come apart.",
     .value =
         [](const ComparedCounterpart& c) {
           const Counterpart other = counterpart(c);
           return count(other.row ? other.parts : 0);
         },
     .files = InFiles::json},
    {.id = "volume_sa_angstrom3",
     .title = "SA vol.",
     .unit = "Å³",
     .help = "The SA volume of the largest part, if it is the same cavity.",
     .value =
         [](const ComparedCounterpart& c) {
           const Counterpart other = counterpart(c);
           if (!other.same) return CellValue();
           return CellValue(
               c.all.answers()[c.answer].table().measure(*other.row).volume_sa_angstrom3);
         },
     .files = InFiles::json}};

}  // namespace

std::span<const Column<ComparedVariant>> variant_columns() {
  return kVariants;
}

std::span<const Column<ComparedCavity>> compared_cavity_columns() {
  return kCavities;
}

std::span<const Column<ComparedCounterpart>> counterpart_columns() {
  return kCounterparts;
}

}  // namespace alphascope::cli

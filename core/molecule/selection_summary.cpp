// The one line that tells what was used of a molecule.
#include "core/molecule/prepare_balls.hpp"

namespace alphascope {
namespace {

std::string with_commas(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t k = text.size(); k > 3; k -= 3) text.insert(k - 3, ",");
  return text;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return with_commas(count) + ' ' + (count == 1 ? one : many);
}

}  // namespace

std::string summary(const SelectionReport& report) {
  std::string text =
      "used " + with_commas(report.used) + " of " + counted(report.total, "atom", "atoms");
  // A water of a crystal is one atom; with hydrogens, atoms are counted and said to be.
  const bool one_atom_each = report.dropped_water_hydrogens == 0;
  const struct {
    std::size_t count;
    const char *one, *many;
  } reasons[] = {
      {report.dropped_chains, "atom of another chain", "atoms of other chains"},
      {report.dropped_selection, "atom not selected", "atoms not selected"},
      {report.dropped_dummies, "dummy atom", "dummy atoms"},
      {report.dropped_waters, one_atom_each ? "water" : "water atom",
       one_atom_each ? "waters" : "water atoms"},
      {report.dropped_ions, "ion", "ions"},
      {report.dropped_ligands, "ligand atom", "ligand atoms"},
      {report.dropped_polymers, "polymer atom", "polymer atoms"},
      {report.dropped_hydrogens, "hydrogen", "hydrogens"},
      {report.dropped_altlocs, "alternative location", "alternative locations"},
      {report.dropped_zero_radius, "atom of radius 0", "atoms of radius 0"},
      {report.dropped_without_radius, "atom without radius", "atoms without radius"},
  };
  const char* separator = "; dropped ";
  for (const auto& reason : reasons) {
    if (reason.count == 0) continue;
    text += separator + counted(reason.count, reason.one, reason.many);
    separator = ", ";
  }
  text += "; radii " + report.radii_name;
  if (report.guessed_atoms > 0) text += "; " + with_commas(report.guessed_atoms) + " guessed";
  if (report.coincident_centres > 0) {
    text += "; " + counted(report.coincident_centres, "coincident centre", "coincident centres");
  }
  return text;
}

}  // namespace alphascope

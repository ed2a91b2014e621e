// SPDX-License-Identifier: GPL-3.0-or-later
// Texts and rows about the open molecule: atoms used and dropped, radii and their evidence.
#include "app/viewer/molecule_info.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <tuple>

#include "core/files/fetched_file.hpp"
#include "core/geometry/grown_radius.hpp"
#include "core/molecule/molecule.hpp"
#include "core/text/grouped_number.hpp"
#include "core/text/printable.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/molecule/radius_row.hpp"
#include "ui/panels/whole_state.hpp"
#include "ui/widgets/format.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kResiduesListed = 12;  // names per reason for dropping

std::string count(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

// "HOH 221" or "ALA 40, GLY 12, … and 3 more".
std::string residues_of(const SelectionReport& report, DropReason reason) {
  std::string text;
  std::size_t listed = 0, more = 0;
  for (const DroppedAtoms& d : report.dropped) {
    if (d.reason != reason || (d.residue.empty() && report.dropped.size() == 1)) continue;
    if (listed == kResiduesListed) {
      ++more;
      continue;
    }
    text += (listed++ == 0 ? "" : ", ") + (d.residue.empty() ? "no residue" : d.residue) + " " +
            count(d.count);
  }
  if (more > 0) text += " and " + count(more) + " more residue names";
  return text;
}

void add_radius_rows(MoleculeInfo& info, const std::vector<GuessedRadius>& list,
                     RadiusRow::Kind kind) {
  for (const GuessedRadius& radius : list) info.radius_rows.push_back({kind, radius});
}

// Sorts uncommon elements such as metals first, since their guessed radii are the most doubtful.
// The order does not depend on kind or radius, so a row that the user edits stays in its place.
void sort_radius_rows(std::vector<RadiusRow>& rows) {
  const auto key = [](const RadiusRow& row) {
    static const std::set<std::string_view> kCommon{"C", "N", "O", "S", "P", "H"};
    const AtomGroup& atoms = row.radius.group;
    const std::string_view element = element_symbol(atoms.element);
    return std::tuple(kCommon.contains(element), std::string_view(atoms.residue),
                      std::string_view(atoms.atom), element);
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const RadiusRow& a, const RadiusRow& b) { return key(a) < key(b); });
}

void describe_contents(MoleculeInfo& info, const OpenedMolecule& opened) {
  info.contents = *opened.contents;
  info.residues = opened.residues;
  info.deposited_atoms = opened.deposited->atoms.size();
  info.assemblies = opened.assemblies;
  for (const ModelRange& model : opened.molecule->models) info.models.push_back(model.number);
}

std::string assembly_text(const OpenedMolecule& opened) {
  const std::string& id = opened.molecule->assembly_id;
  if (id.empty()) return "none: as deposited";
  for (const AssemblyInfo& a : opened.assemblies) {
    if (a.id == id) return id + ": " + count(a.copies) + (a.copies == 1 ? " copy" : " copies");
  }
  return id;
}

std::string model_text(const OpenedMolecule& opened) {
  const auto& models = opened.molecule->models;
  const int model = opened.options.balls.model;
  const std::string of = " of " + count(models.size());
  if (model == kAllModels) return "all" + of + " at once";
  return count(static_cast<std::size_t>(model) + 1) + of + " (number " +
         std::to_string(models[static_cast<std::size_t>(model)].number) + " in the file)";
}

std::string rounding_text(const OpenedMolecule& opened) {
  const double atoms = opened.molecule->rounding_angstrom;
  const double radii = opened.prepared->report.radius_rounding_angstrom;
  if (atoms == 0 && radii == 0) return "none: every digit of the file is kept";
  std::string text;
  if (atoms > 0) text = "coordinates by at most " + short_number_text(atoms, 9) + " Å";
  if (radii > 0) {
    text += (text.empty() ? "" : ", ") + std::string("radii by at most ") +
            short_number_text(radii, 9) + " Å";
  }
  return text;
}

void describe_provenance(MoleculeInfo& info, const OpenedMolecule& opened) {
  const Molecule& m = *opened.molecule;
  const SelectionReport& report = opened.prepared->report;
  const std::string& expression = opened.options.balls.selection;
  info.sha256 = m.sha256;
  info.options = opened.options.balls;
  info.radii_name = report.radii_name;
  info.radii_citation = report.radii_citation;
  auto& rows = info.provenance;
  rows = {{"File", printable(m.source.string())}, {"Format", m.format}, {"SHA-256", m.sha256}};
  if (const auto from = fetched_from(m.source)) {
    rows.emplace_back("Fetched", printable(from->text()));
  }
  rows.emplace_back("Assembly", assembly_text(opened));
  if (m.models.size() > 1) rows.emplace_back("Model", model_text(opened));
  rows.emplace_back("Selection", summary(report));
  if (expression.find_first_not_of(" \t") != std::string::npos) {
    rows.emplace_back("Expression", expression);
  }
  rows.emplace_back("Radii", report.radii_name + (report.radii_citation.empty() ? "" : ": ") +
                                 report.radii_citation);
  for (const std::string& treated : opened.options.balls.treated) {
    rows.emplace_back("By hand", treated);
  }
  for (const GuessedRadius& o : report.overridden) {
    rows.emplace_back("By hand", o.atoms + ": " + short_number_text(o.radius_angstrom, 6) + " Å (" +
                                     count(o.count) + ")");
  }
  rows.emplace_back("Lattice unit", short_number_text(report.lattice.unit_angstrom(), 9) + " Å");
  rows.emplace_back("Rounding", rounding_text(opened));
}

std::vector<std::string> notes_of(const OpenedMolecule& opened) {
  const SelectionReport& report = opened.prepared->report;
  std::vector<std::string> notes = opened.molecule->notes;
  if (report.used == 0) {
    notes.push_back("The selection has no atoms, so the complex is empty.");
  }
  if (opened.molecule->rounding_angstrom > 0) {
    notes.push_back("Rounded to the lattice, by at most " +
                    short_number_text(opened.molecule->rounding_angstrom, 9) + " Å.");
  }
  if (report.coincident_centres > 0) {
    notes.push_back(counted(report.coincident_centres, "ball shares", "balls share") +
                    " a centre with another ball. Only the largest ball at each centre counts.");
  }
  return notes;
}

}  // namespace

MoleculeInfo describe_molecule(const OpenedMolecule& opened) {
  const Molecule& molecule = *opened.molecule;
  const SelectionReport& report = opened.prepared->report;
  MoleculeInfo info;
  info.loaded = true;
  info.name = printable(molecule.source.filename().string());
  info.folder = printable(molecule.source.parent_path().string());
  info.title = molecule.title;
  info.format = molecule.format;
  info.summary = summary(report);
  info.balls = opened.prepared->balls->size();
  info.has_file_radii = molecule.has_file_radii;
  info.notes = notes_of(opened);
  info.dropped_atoms = report.total - report.used;
  for (const CountedReason& reason : drop_reasons(report)) {
    info.dropped.push_back({reason.text, residues_of(report, reason.reason)});
  }
  add_radius_rows(info, report.unsized, RadiusRow::Kind::none);
  add_radius_rows(info, report.overridden, RadiusRow::Kind::by_hand);
  add_radius_rows(info, report.guessed, RadiusRow::Kind::guessed);
  sort_radius_rows(info.radius_rows);
  describe_contents(info, opened);
  describe_provenance(info, opened);
  return info;
}

std::vector<GrownRadius> grown_radii(const PreparedBalls& prepared, const Request& controls) {
  std::vector<GrownRadius> result;
  for (const BallSize& size : prepared.report.sizes) {
    GrownRadius row;
    if (size.element != kUnknownElement) row.element = element_symbol(size.element);
    row.balls = size.count;
    row.atoms = printable(size.atoms);
    row.radius = prepared.balls->lattice.angstrom(size.radius);
    row.grown =
        grown_radius(row.radius, controls.solvent_radius_angstrom, controls.alpha_angstrom2);
    result.push_back(std::move(row));
  }
  return result;
}

}  // namespace alphascope

// See the header.
#include "app/viewer/molecule_info.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <tuple>

#include "core/molecule/printable.hpp"
#include "core/molecule/selection_expression.hpp"
#include "ui/panels/format.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kResiduesListed = 12;  // names per reason for dropping

std::string count(std::size_t n) {
  return with_separators(static_cast<long long>(n));
}

std::size_t of_kind(const KindCounts& kinds, AtomKind kind) {
  return kinds[static_cast<std::size_t>(kind)];
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
  for (const GuessedRadius& g : list) {
    info.radius_rows.push_back({kind,
                                {g.residue, g.atom, std::string(element_symbol(g.element))},
                                g.count,
                                g.radius_angstrom,
                                g.source});
  }
}

// Metals and the like first: their guesses are the most doubtful. Kind and radius do not count, so
// that an edit does not move its row from under the mouse.
void sort_radius_rows(std::vector<RadiusRow>& rows) {
  const auto key = [](const RadiusRow& row) {
    static const std::set<std::string> kCommon{"C", "N", "O", "S", "P", "H"};
    return std::tuple(kCommon.contains(row.atoms.element), std::string_view(row.atoms.residue),
                      std::string_view(row.atoms.atom), std::string_view(row.atoms.element));
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const RadiusRow& a, const RadiusRow& b) { return key(a) < key(b); });
}

std::string kinds_text(const KindCounts& kinds) {
  static constexpr const char* kNames[] = {"polymer", "water", "ligand", "ion", "dummy"};
  std::string text;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (kinds[k] == 0) continue;
    text += (text.empty() ? "" : " · ") + std::string(kNames[k]) + " " + count(kinds[k]);
  }
  return text;
}

void describe_contents(MoleculeInfo& info, const OpenedMolecule& opened) {
  const MoleculeContents& c = *opened.contents;
  for (const ChainContents& chain : c.chains) {
    info.chains.push_back({chain.name, kinds_text(chain.kinds), chain.atoms});
  }
  info.kinds = {of_kind(c.kinds, AtomKind::polymer),
                of_kind(c.kinds, AtomKind::water),
                of_kind(c.kinds, AtomKind::ligand),
                of_kind(c.kinds, AtomKind::ion),
                of_kind(c.kinds, AtomKind::dummy),
                c.hydrogens,
                c.with_altloc};
  info.deposited_atoms = opened.deposited->atoms.size();
  for (const AssemblyInfo& a : opened.assemblies) {
    info.assemblies.push_back({a.id, a.details, a.copies, a.atoms, a.memory_bytes});
  }
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
  info.radii_name = report.radii_name;
  info.radii_citation = report.radii_citation;
  auto& rows = info.provenance;
  rows = {{"File", printable(m.source.string())}, {"Format", m.format}, {"SHA-256", m.sha256}};
  rows.emplace_back("Assembly", assembly_text(opened));
  if (m.models.size() > 1) rows.emplace_back("Model", model_text(opened));
  rows.emplace_back("Selection", summary(report));
  if (expression.find_first_not_of(" \t") != std::string::npos) {
    rows.emplace_back("Expression", expression);
  }
  rows.emplace_back("Radii", report.radii_name + (report.radii_citation.empty() ? "" : ": ") +
                                 report.radii_citation);
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
    notes.push_back("No atom is left by this selection, so the complex is empty.");
  }
  if (opened.molecule->rounding_angstrom > 0) {
    notes.push_back("Rounded to the lattice, by at most " +
                    short_number_text(opened.molecule->rounding_angstrom, 9) + " Å.");
  }
  if (report.coincident_centres > 0) {
    notes.push_back(count(report.coincident_centres) +
                    " balls share a centre with another; the largest of each counts.");
  }
  return notes;
}

template <class Enum, class Option>
Enum as(Option option) {
  return static_cast<Enum>(static_cast<int>(option));
}
static_assert(static_cast<int>(HydrogenOption::drop) == static_cast<int>(HydrogenRule::drop));
static_assert(static_cast<int>(HydrogenOption::keep) == static_cast<int>(HydrogenRule::keep));
static_assert(static_cast<int>(AltlocOption::all) == static_cast<int>(AltlocRule::all));
static_assert(kEveryModel == kAllModels);

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
    const double with_solvent = row.radius + controls.solvent_radius_angstrom;
    row.grown = std::sqrt(std::max(0.0, with_solvent * with_solvent + controls.alpha_angstrom2));
    result.push_back(std::move(row));
  }
  return result;
}

std::vector<RadiiSet> offered_radii_sets() {
  std::vector<RadiiSet> sets;
  for (const RadiiSetInfo& info : all_radii_sets()) sets.push_back(info.set);
  return sets;
}

std::vector<RadiiSetEntry> radii_set_entries(const std::vector<RadiiSet>& radii_sets) {
  std::vector<RadiiSetEntry> entries;
  for (const RadiiSet set : radii_sets) {
    const RadiiSetInfo& info = radii_set_info(set);
    RadiiSetEntry entry{std::string(info.name), std::string(info.citation)};
    if (set == RadiiSet::automatic) {
      entry.citation =
          "The file's own radii when it has any; else ProtOr for proteins and nucleic acids "
          "without "
          "hydrogens; else Bondi.";
    } else if (set == RadiiSet::amber) {
      entry.citation =
          "Half the distance at which two atoms of one type have their least van der Waals energy "
          "in AMBER's force fields; hydrogens too.\n" +
          entry.citation;
    } else if (set == RadiiSet::file) {
      entry.kind = RadiiSetEntry::Kind::from_file;
    } else if (set == RadiiSet::user) {
      entry.kind = RadiiSetEntry::Kind::user_table;
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

OpenOptions to_open_options(const SelectionControls& controls,
                            const std::vector<RadiiSet>& radii_sets) {
  OpenOptions options;
  BallOptions& b = options.balls;
  b.polymers = controls.polymers;
  b.waters = controls.waters;
  b.ligands = controls.ligands;
  b.ions = controls.ions;
  b.dummies = controls.dummies;
  b.radii = radii_sets.at(static_cast<std::size_t>(controls.radii_set));
  b.hydrogens = as<HydrogenRule>(controls.hydrogens);
  b.altlocs = as<AltlocRule>(controls.altlocs);
  b.model = controls.model;
  b.without_chains = controls.chains_off;
  b.selection = controls.expression;
  for (const RadiusEdit& edit : controls.radius_edits.list()) {
    b.overrides.push_back({edit.atoms.residue, edit.atoms.atom,
                           element_from_symbol(edit.atoms.element),
                           static_cast<std::int32_t>(std::lround(edit.radius * 1e6))});
  }
  options.assembly = controls.assembly;
  if (b.radii == RadiiSet::user) options.radii_table = controls.radii_table;
  return options;
}

SelectionControls to_controls(const OpenOptions& options, const std::vector<RadiiSet>& radii_sets) {
  const BallOptions& b = options.balls;
  SelectionControls controls;
  controls.polymers = b.polymers;
  controls.waters = b.waters;
  controls.ligands = b.ligands;
  controls.ions = b.ions;
  controls.dummies = b.dummies;
  const auto set = std::find(radii_sets.begin(), radii_sets.end(), b.radii);
  controls.radii_set = set == radii_sets.end() ? 0 : static_cast<int>(set - radii_sets.begin());
  controls.radii_table = options.radii_table.string();
  controls.hydrogens = as<HydrogenOption>(b.hydrogens);
  controls.altlocs = as<AltlocOption>(b.altlocs);
  controls.model = b.model;
  controls.chains_off = b.without_chains;
  controls.expression = b.selection;
  controls.assembly = options.assembly;
  for (const RadiusOverride& o : b.overrides) {
    controls.radius_edits.set({o.residue, o.atom, std::string(element_symbol(o.element))},
                              o.microangstrom / 1e6);
  }
  return controls;
}

ExpressionError check_expression(const std::string& expression) {
  try {
    SelectionExpression::parse(expression);
    return {};
  } catch (const SelectionError& error) {
    return {error.what(), error.column()};
  }
}

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// Makes balls of the selected atoms, and counts all that was dropped, guessed or rounded.
#include "core/selection/prepare_balls.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "core/geometry/lattice_alpha.hpp"
#include "core/neighbours/coincident.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/radii/given_radius.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/atom_filter.hpp"
#include "core/selection/atom_groups.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kAtomsBetweenReports = 1 << 16;

AtomRange chosen_atoms(const Molecule& molecule, int model) {
  if (molecule.atoms.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument("the molecule has more than 4,294,967,295 atoms");
  }
  if (model == kAllModels) return {0, molecule.atoms.size()};
  if (model < 0 || static_cast<std::size_t>(model) >= molecule.models.size()) {
    throw std::invalid_argument("there is no model " + std::to_string(model + 1) +
                                ": the file has " + std::to_string(molecule.models.size()));
  }
  return {molecule.models[model].begin, molecule.models[model].end};
}

// Counts dropped atoms by reason, and by residue name for the list.
class DropCounter {
 public:
  DropCounter(const Molecule& molecule, SelectionReport& report)
      : molecule_(molecule), report_(report) {}

  void add(const Atom& atom, DropReason reason) {
    ++counter(reason);
    report_.dropped_water_hydrogens += reason == DropReason::water && atom.element == kHydrogen;
    ++by_residue_[{reason, atom.residue_name}];
  }

  void finish() {
    for (const auto& [key, count] : by_residue_) {
      report_.dropped.push_back({key.first, std::string(molecule_.text(key.second)), count});
    }
    std::stable_sort(report_.dropped.begin(), report_.dropped.end(),
                     [](const DroppedAtoms& a, const DroppedAtoms& b) {
                       return a.reason != b.reason ? a.reason < b.reason : a.count > b.count;
                     });
  }

 private:
  std::size_t& counter(DropReason reason) {
    switch (reason) {
      case DropReason::chain:
        return report_.dropped_chains;
      case DropReason::selection:
        return report_.dropped_selection;
      case DropReason::dummy:
        return report_.dropped_dummies;
      case DropReason::water:
        return report_.dropped_waters;
      case DropReason::ion:
        return report_.dropped_ions;
      case DropReason::ligand:
        return report_.dropped_ligands;
      case DropReason::polymer:
        return report_.dropped_polymers;
      case DropReason::hydrogen:
        return report_.dropped_hydrogens;
      case DropReason::altloc:
        return report_.dropped_altlocs;
      case DropReason::zero_radius:
        return report_.dropped_zero_radius;
      case DropReason::without_radius:
        break;
    }
    return report_.dropped_without_radius;
  }

  const Molecule& molecule_;
  SelectionReport& report_;
  std::map<std::pair<DropReason, NameId>, std::size_t> by_residue_;
};

// Looks up radii in lattice units, and lists the guessed, overridden and missing ones.
class RadiusSource {
 public:
  RadiusSource(const Molecule& molecule, const BallOptions& options, SelectionReport& report)
      : molecule_(molecule),
        set_(report.radii),
        lookup_(molecule, report.radii, options.user_radii),
        report_(report) {
    for (const RadiusOverride& o : options.overrides) add_override(o);
  }

  // The radius (10^-6 Å) that the set, table or user gives, if the last result of radius() is that
  // radius rounded to the lattice; 0: it is exact.
  std::int32_t rounded_from() const { return rounded_from_; }

  // The radius in lattice units; 0: the atom has no ball, and `missing` is set to the reason.
  std::int32_t radius(std::size_t index, DropReason& missing) {
    rounded_from_ = 0;
    const Atom& atom = molecule_.atoms[index];
    if (!overrides_.empty()) {
      const auto found = overrides_.find(key(atom));
      if (found != overrides_.end()) {
        ++report_.overridden_atoms;
        note(report_.overridden, override_index_, atom, found->second / 1e6, "set by hand");
        return units_of(found->second);
      }
    }
    if (set_ == RadiiSet::file) {
      if (atom.file_radius > 0) return atom.file_radius;
      missing = atom.file_radius == 0 ? DropReason::zero_radius : DropReason::without_radius;
      note(report_.unsized, unsized_index_, atom, 0, "");
      return 0;
    }
    const AssignedRadius assigned = lookup_.radius(index);
    if (assigned.guessed || atom.element_guessed) {
      ++report_.guessed_atoms;
      note(report_.guessed, guess_index_, atom, assigned.microangstrom / 1e6,
           source_of_guess(assigned, atom));
    }
    return units_of(assigned.microangstrom);
  }

 private:
  using Index = std::unordered_map<std::uint64_t, std::size_t>;

  static std::string source_of_guess(const AssignedRadius& assigned, const Atom& atom) {
    std::string text(assigned.source);
    if (!atom.element_guessed || atom.element == kUnknownElement) return text;
    return text + (text.empty() ? "" : "; ") + "element guessed from the atom's name";
  }

  // A key of three parts. Names are numbered from 0 without gaps, far below 2^28 even in the
  // largest files.
  static std::uint64_t key(NameId residue, NameId name, Element element) {
    return (std::uint64_t{residue} << 36) ^ (std::uint64_t{name} << 8) ^ element;
  }
  static std::uint64_t key(const Atom& atom) {
    return key(atom.residue_name, atom.name, atom.element);
  }

  void add_override(const RadiusOverride& o) {
    const auto& [residue_text, atom_text, element] = o.atoms;
    const NameId residue = molecule_.names.find(residue_text),
                 name = molecule_.names.find(atom_text);
    // Names that this molecule lacks must not match its atoms without a name (id 0).
    if ((residue == 0 && !residue_text.empty()) || (name == 0 && !atom_text.empty())) return;
    overrides_[key(residue, name, element)] = o.microangstrom;
  }

  std::int32_t units_of(std::int32_t microangstrom) {
    const LatticeRadius radius = on_lattice(microangstrom, molecule_.lattice);
    if (radius.rounding_angstrom > 0) rounded_from_ = microangstrom;
    return radius.units;
  }

  void note(std::vector<GuessedRadius>& list, Index& index, const Atom& atom, double angstrom,
            std::string_view source) {
    const auto [entry, inserted] = index.try_emplace(key(atom), list.size());
    if (inserted) {
      AtomGroup group{std::string(molecule_.text(atom.residue_name)),
                      std::string(molecule_.text(atom.name)), atom.element};
      std::string text =
          group.atom.empty() ? std::string(element_symbol(atom.element)) : group.atom;
      if (!group.residue.empty()) text += " in " + group.residue;
      list.push_back({std::move(text), 0, angstrom, std::string(source), std::move(group)});
    }
    ++list[entry->second].count;
  }

  const Molecule& molecule_;
  RadiiSet set_;
  RadiiLookup lookup_;
  SelectionReport& report_;
  std::unordered_map<std::uint64_t, std::int32_t> overrides_;
  std::int32_t rounded_from_ = 0;
  Index guess_index_, override_index_, unsized_index_;
};

// Counts balls by element and radius.
class SizeCounter {
 public:
  void add(const Atom& atom, std::int32_t radius) {
    const std::uint64_t key =
        (std::uint64_t{atom.element} << 32) | static_cast<std::uint32_t>(radius);
    // Neighbours in a file often have one size, so the last entry is tried first.
    if (key != last_key_ || last_ == nullptr) {
      last_ = &counts_[key];
      last_key_ = key;
    }
    ++last_->count;
    // Keeps one name more than is listed, to see whether there are more.
    std::vector<NameId>& names = last_->names;
    if (names.size() > kNamesTold) return;
    if (std::find(names.begin(), names.end(), atom.name) == names.end()) {
      names.push_back(atom.name);
    }
  }
  std::vector<BallSize> sizes(const NameTable& table) const {
    std::vector<BallSize> list;
    for (const auto& [key, counted] : counts_) {
      list.push_back({static_cast<Element>(key >> 32), static_cast<std::int32_t>(key & 0xffffffffu),
                      counted.count, names_text(counted.names, table)});
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const BallSize& a, const BallSize& b) { return a.count > b.count; });
    return list;
  }

 private:
  static constexpr std::size_t kNamesTold = 6;
  struct Counted {
    std::size_t count = 0;
    std::vector<NameId> names;
  };

  static std::string names_text(const std::vector<NameId>& names, const NameTable& table) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string_view name = i < kNamesTold ? table.text(names[i]) : "…";
      if (!name.empty()) text += (text.empty() ? "" : ", ") + std::string(name);
    }
    return text;
  }

  std::map<std::uint64_t, Counted> counts_;  // entries of a map keep their addresses
  std::uint64_t last_key_ = 0;
  Counted* last_ = nullptr;
};

// Returns whether the ProtOr radii suit the atoms: polymers without hydrogens, of which ProtOr
// knows at least one atom.
bool suits_protor(const Molecule& molecule, AtomRange range) {
  bool typed = false;
  RadiiLookup protor(molecule, RadiiSet::protor, nullptr);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Atom& atom = molecule.atoms[i];
    if (atom.kind != ResidueKind::polymer) continue;
    if (atom.element == kHydrogen) return false;
    typed = typed || !protor.radius(i).guessed;
  }
  return typed;
}

bool is_drawn_beside_balls(DropReason reason) {
  return reason == DropReason::water || reason == DropReason::ion || reason == DropReason::ligand ||
         reason == DropReason::hydrogen;
}

RadiiSet resolve(const BallOptions& options, const Molecule& molecule, AtomRange range) {
  if (options.radii == RadiiSet::file && !molecule.has_file_radii) {
    throw std::invalid_argument("the file has no radii of its own; choose a radii set");
  }
  if (options.radii == RadiiSet::user && !options.user_radii) {
    throw std::invalid_argument("no table of radii is loaded; open one or choose a radii set");
  }
  if (options.radii != RadiiSet::automatic) return options.radii;
  if (molecule.has_file_radii) return RadiiSet::file;
  return suits_protor(molecule, range) ? RadiiSet::protor : RadiiSet::bondi;
}

}  // namespace

PreparedBalls prepare_balls(const Molecule& molecule, const BallOptions& options,
                            const RunContext& context) {
  const AtomRange range = chosen_atoms(molecule, options.model);
  PreparedBalls result;
  SelectionReport& report = result.report;
  report.total = range.end - range.begin;
  report.radii = resolve(options, molecule, range);
  report.radii_name = radii_set_info(report.radii).name;
  report.radii_citation = radii_set_info(report.radii).citation;
  if (report.radii == RadiiSet::user) report.radii_citation = options.user_radii->source;
  const bool drop_hydrogens =
      options.hydrogens == HydrogenRule::drop ||
      (options.hydrogens == HydrogenRule::automatic && radii_set_info(report.radii).united_atom);

  const AtomFilter filter(molecule, options, range, drop_hydrogens);
  DropCounter dropped(molecule, report);
  RadiusSource radii(molecule, options, report);
  std::vector<RoundedBall> rounded;
  const Atom* guessed = nullptr;  // the last atom of a guessed residue
  auto balls = std::make_shared<BallSet>();
  balls->lattice = molecule.lattice;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    if (i % kAtomsBetweenReports == 0) {
      context.cancel.throw_if_cancelled();
      context.report("selection and radii",
                     static_cast<double>(i - range.begin) / static_cast<double>(report.total));
    }
    const Atom& atom = molecule.atoms[i];
    std::optional<DropReason> reason = filter.reason_to_drop(i);
    if (is_guess(atom.why) && reason != DropReason::chain && reason != DropReason::selection) {
      const bool same = guessed != nullptr && same_residue(*guessed, atom);
      report.guessed_residues += !same;
      guessed = &atom;
    }
    DropReason missing{};
    const std::int32_t radius = reason ? 0 : radii.radius(i, missing);
    if (radius == 0) {
      dropped.add(atom, reason.value_or(missing));
      if (reason && is_drawn_beside_balls(*reason) && !filter.is_minor_location(i)) {
        result.left_out.push_back({static_cast<std::uint32_t>(i), *reason});
      }
      continue;
    }
    balls->centres.push_back(atom.position);
    if (radii.rounded_from() > 0) {
      rounded.push_back({static_cast<BallIndex>(balls->size() - 1), radii.rounded_from()});
    }
    balls->radii.push_back(radius);
    result.atom_of_ball.push_back(static_cast<std::uint32_t>(i));
  }
  dropped.finish();
  const RadiusRounding rounding = fit_lattice(*balls, rounded);
  report.rounded_radii = rounding.balls;
  report.radius_rounding_angstrom = rounding.largest_angstrom;
  report.lattice = balls->lattice;
  SizeCounter sizes;
  for (std::size_t k = 0; k < balls->size(); ++k) {
    sizes.add(molecule.atoms[result.atom_of_ball[k]], balls->radii[k]);
  }
  report.sizes = sizes.sizes(molecule.names);
  report.used = balls->size();
  const std::vector<bool> hidden = coincident_hidden(*balls);
  report.coincident_centres =
      static_cast<std::size_t>(std::count(hidden.begin(), hidden.end(), true));
  result.balls = std::move(balls);
  return result;
}

ModelRange models_of_balls(const Molecule& molecule, const PreparedBalls& prepared) {
  ModelRange range = molecule.models.front();
  const auto& atoms = prepared.atom_of_ball;
  if (atoms.empty()) return range;
  for (const ModelRange& model : molecule.models) {
    const auto has = [&](std::uint32_t atom) { return model.begin <= atom && atom < model.end; };
    if (has(atoms.front())) range = model;
    if (has(atoms.back())) range.end = model.end;
  }
  return range;
}

}  // namespace alphascope

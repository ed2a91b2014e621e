#include "core/molecule/prepare_balls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "core/molecule/altlocs.hpp"
#include "core/molecule/selection_expression.hpp"

namespace alphascope {
namespace {

struct AtomRange {
  std::size_t begin, end;
};

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

// Decides atom by atom; what a whole residue decides (altlocs) is worked out at the start.
class AtomFilter {
 public:
  AtomFilter(const Molecule& molecule, const BallOptions& options, AtomRange range,
             bool drop_hydrogens)
      : molecule_(molecule), options_(options), range_(range), drop_hydrogens_(drop_hydrogens) {
    if (options.selection.find_first_not_of(" \t\r\n") != std::string::npos) {
      selection_ = SelectionExpression::parse(options.selection).bind(molecule);
    }
    for (const std::string& chain : options.chains) {
      chains_.push_back(chain.empty() ? 0 : molecule.names.find(chain));
      // A chain that is not there must not match the atoms without chain (id 0).
      if (!chain.empty() && chains_.back() == 0) chains_.pop_back();
    }
    if (options.altlocs == AltlocRule::best && options.model != kAllModels) {
      minor_ = minor_altlocs(molecule, range.begin, range.end);
    } else if (options.altlocs == AltlocRule::best) {
      for (const ModelRange& model : molecule.models) {
        const std::vector<bool> part = minor_altlocs(molecule, model.begin, model.end);
        minor_.insert(minor_.end(), part.begin(), part.end());
      }
    }
  }

  // The counter of the reason to leave this atom out, or null to keep it.
  std::size_t* reason_to_drop(std::size_t i, SelectionReport& report) const {
    const Atom& atom = molecule_.atoms[i];
    if (!options_.chains.empty() &&
        std::find(chains_.begin(), chains_.end(), atom.chain) == chains_.end()) {
      return &report.dropped_chains;
    }
    if (selection_ && !(*selection_)(atom)) return &report.dropped_selection;
    switch (atom.kind) {
      case AtomKind::dummy:
        if (!options_.dummies) return &report.dropped_dummies;
        break;
      case AtomKind::water:
        if (!options_.waters) return &report.dropped_waters;
        break;
      case AtomKind::ion:
        if (!options_.ions) return &report.dropped_ions;
        break;
      case AtomKind::ligand:
        if (!options_.ligands) return &report.dropped_ligands;
        break;
      case AtomKind::polymer:
        if (!options_.polymers) return &report.dropped_polymers;
        break;
    }
    if (drop_hydrogens_ && atom.element == kHydrogen) {
      return &report.dropped_hydrogens;
    }
    if (!minor_.empty() && minor_[i - range_.begin]) return &report.dropped_altlocs;
    return nullptr;
  }

 private:
  const Molecule& molecule_;
  const BallOptions& options_;
  AtomRange range_;
  bool drop_hydrogens_;
  std::vector<NameId> chains_;
  std::optional<SelectionExpression::Bound> selection_;
  std::vector<bool> minor_;
};

// Radii in lattice units, with the list of the guessed ones.
class RadiusSource {
 public:
  RadiusSource(const Molecule& molecule, const BallOptions& options, SelectionReport& report)
      : molecule_(molecule),
        set_(report.radii),
        lookup_(molecule, report.radii, options.user_radii),
        report_(report) {
    scale_ = molecule.lattice.units_per_angstrom() / 1e6;
  }

  // 0 when the atom has no ball; the reason is then counted.
  std::int32_t radius(const Atom& atom) {
    if (set_ == RadiiSet::file) {
      if (atom.file_radius > 0) return atom.file_radius;
      ++(atom.file_radius == 0 ? report_.dropped_zero_radius : report_.dropped_without_radius);
      return 0;
    }
    const AssignedRadius assigned = lookup_.radius(atom);
    const double exact = assigned.microangstrom * scale_;
    // A lattice of whole ångströms must not make a ball vanish.
    const double units = std::clamp(std::round(exact), 1.0, double{kMaxLatticeRadius});
    report_.radius_rounding_angstrom = std::max(
        report_.radius_rounding_angstrom, molecule_.lattice.angstrom(std::fabs(units - exact)));
    if (assigned.guessed) note_guess(atom, assigned);
    return static_cast<std::int32_t>(units);
  }

 private:
  void note_guess(const Atom& atom, const AssignedRadius& assigned) {
    ++report_.guessed_atoms;
    const std::uint64_t key = (std::uint64_t{atom.name} << 32) | atom.residue_name;
    const auto [entry, inserted] = guess_index_.try_emplace(key, report_.guessed.size());
    if (inserted) {
      std::string name(molecule_.text(atom.name));
      if (name.empty()) name = std::string(element_symbol(atom.element));
      if (atom.residue_name != 0) name += " in " + std::string(molecule_.text(atom.residue_name));
      report_.guessed.push_back(
          {std::move(name), 0, assigned.microangstrom / 1e6, std::string(assigned.source)});
    }
    ++report_.guessed[entry->second].count;
  }

  const Molecule& molecule_;
  RadiiSet set_;
  RadiiLookup lookup_;
  SelectionReport& report_;
  double scale_ = 1;  // lattice units per 10^-6 Å
  std::unordered_map<std::uint64_t, std::size_t> guess_index_;
};

// ProtOr is meant for proteins and nucleic acids without hydrogens, and says nothing of others.
bool suits_protor(const Molecule& molecule, AtomRange range) {
  bool typed = false;
  RadiiLookup protor(molecule, RadiiSet::protor, nullptr);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Atom& atom = molecule.atoms[i];
    if (atom.kind != AtomKind::polymer) continue;
    if (atom.element == kHydrogen) return false;
    typed = typed || !protor.radius(atom).guessed;
  }
  return typed;
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

std::size_t count_coincident(const std::vector<LatticePoint>& points) {
  std::size_t capacity = 16;
  while (capacity < 2 * points.size()) capacity *= 2;
  constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> table(capacity, kFree);
  std::size_t coincident = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LatticePoint& p = points[i];
    std::uint64_t hash = static_cast<std::uint32_t>(p.x) * 0x9E3779B97F4A7C15u;
    hash = (hash ^ (hash >> 29) ^ static_cast<std::uint32_t>(p.y)) * 0xBF58476D1CE4E5B9u;
    hash = (hash ^ (hash >> 32) ^ static_cast<std::uint32_t>(p.z)) * 0x94D049BB133111EBu;
    std::size_t slot = (hash ^ (hash >> 31)) & (capacity - 1);
    while (table[slot] != kFree && points[table[slot]] != p) slot = (slot + 1) & (capacity - 1);
    if (table[slot] == kFree) {
      table[slot] = static_cast<std::uint32_t>(i);
    } else {
      ++coincident;
    }
  }
  return coincident;
}

}  // namespace

PreparedBalls prepare_balls(const Molecule& molecule, const BallOptions& options) {
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
  RadiusSource radii(molecule, options, report);
  auto balls = std::make_shared<BallSet>();
  balls->lattice = molecule.lattice;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    if (std::size_t* const counter = filter.reason_to_drop(i, report)) {
      ++*counter;
      report.dropped_water_hydrogens +=
          counter == &report.dropped_waters && molecule.atoms[i].element == kHydrogen;
      continue;
    }
    const std::int32_t radius = radii.radius(molecule.atoms[i]);
    if (radius == 0) continue;
    balls->centres.push_back(molecule.atoms[i].position);
    balls->radii.push_back(radius);
    result.atom_of_ball.push_back(static_cast<std::uint32_t>(i));
  }
  report.used = balls->size();
  report.coincident_centres = count_coincident(balls->centres);
  result.balls = std::move(balls);
  return result;
}

}  // namespace alphascope

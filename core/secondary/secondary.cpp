// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the source of secondary structure, and gives it to all copies.
#include "core/secondary/secondary.hpp"

#include <algorithm>
#include <utility>

#include "core/secondary/dssp.hpp"
#include "core/secondary/hydrogen_bonds.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

using Kind = SecondaryStructure;

// For each kind the file's stretches of atoms, sorted and without overlaps.
using Stretches = std::array<std::vector<SecondaryRange>, kSecondaryStructures>;

Stretches stretches_of(const Molecule& molecule) {
  Stretches stretches;
  for (const SecondaryRange& range : molecule.stated_secondary) {
    stretches[static_cast<std::size_t>(range.kind)].push_back(range);
  }
  for (std::vector<SecondaryRange>& list : stretches) {
    std::sort(list.begin(), list.end(),
              [](const SecondaryRange& a, const SecondaryRange& b) { return a.begin < b.begin; });
    std::size_t kept = 0;
    for (const SecondaryRange& range : list) {
      if (kept > 0 && range.begin < list[kept - 1].end) {
        list[kept - 1].end = std::max(list[kept - 1].end, range.end);
      } else {
        list[kept++] = range;
      }
    }
    list.resize(kept);
  }
  return stretches;
}

bool covers(const std::vector<SecondaryRange>& list, std::size_t deposited) {
  const auto behind = std::upper_bound(
      list.begin(), list.end(), deposited,
      [](std::size_t atom, const SecondaryRange& range) { return atom < range.begin; });
  return behind != list.begin() && deposited < (behind - 1)->end;
}

// Helices count before strands, and both before other kinds.
Kind kind_in_file(const Stretches& stretches, std::size_t deposited) {
  constexpr Kind kOrder[] = {Kind::alpha_helix, Kind::three_ten_helix, Kind::pi_helix,
                             Kind::strand,      Kind::polyproline,     Kind::turn,
                             Kind::bend};
  for (const Kind kind : kOrder) {
    if (covers(stretches[static_cast<std::size_t>(kind)], deposited)) return kind;
  }
  return Kind::coil;
}

class SecondaryFinder {
 public:
  SecondaryFinder(const Molecule& molecule, const ModelRange& model, const RunContext& context)
      : molecule_(molecule), context_(context), units_(copy_units(molecule, model)) {
    for (const CopyUnit& unit : units_) residues_.push_back(find_backbone(molecule, unit));
  }

  SecondaryModel find(SecondaryChoice choice) {
    kinds_.clear();
    for (const auto& residues : residues_) kinds_.emplace_back(residues.size(), Kind::coil);
    const bool any = std::any_of(residues_.begin(), residues_.end(),
                                 [](const auto& residues) { return !residues.empty(); });
    if (!any) return {};
    if (choice == SecondaryChoice::automatic && take_from_file()) {
      result_.source = SecondarySource::file;
    } else {
      result_.source = SecondarySource::hydrogen_bonds;
      for (std::size_t u = 0; u < units_.size(); ++u) take_from_bonds(u);
    }
    copy();
    count_runs();
    return std::move(result_);
  }

 private:
  bool take_from_file() {
    if (molecule_.stated_secondary.empty()) return false;
    const Stretches stretches = stretches_of(molecule_);
    bool any = false;
    for (std::size_t u = 0; u < units_.size(); ++u) {
      for (std::size_t k = 0; k < residues_[u].size(); ++k) {
        const std::size_t ca = residues_[u][k].ca;
        kinds_[u][k] = kind_in_file(stretches, CopyUnit::deposited(units_[u].part_of(ca), ca));
        any = any || kinds_[u][k] != Kind::coil;
      }
    }
    return any;
  }

  void take_from_bonds(std::size_t u) {
    std::vector<BackboneResidue> complete;
    std::vector<std::size_t> index;
    for (std::size_t k = 0; k < residues_[u].size(); ++k) {
      if (!residues_[u][k].complete()) continue;
      complete.push_back(residues_[u][k]);
      index.push_back(k);
    }
    find_chain_breaks(molecule_, complete);
    const HydrogenBondList bonds = find_hydrogen_bonds(molecule_, complete, context_);
    result_.crowded += bonds.crowded * units_[u].copies;
    const std::vector<Kind> kinds = dssp(molecule_, complete, bonds.of_donor);
    for (std::size_t k = 0; k < kinds.size(); ++k) kinds_[u][index[k]] = kinds[k];
  }

  void copy() {
    std::size_t count = 0;
    for (std::size_t u = 0; u < units_.size(); ++u) count += residues_[u].size() * units_[u].copies;
    result_.residues.reserve(count);
    result_.kinds.reserve(count);
    for (std::size_t u = 0; u < units_.size(); ++u) {
      for (std::size_t copy = 0; copy < units_[u].copies; ++copy) {
        context_.cancel.throw_if_cancelled();
        for (const BackboneResidue& residue : residues_[u]) add_copy(units_[u], residue, copy);
        result_.kinds.insert(result_.kinds.end(), kinds_[u].begin(), kinds_[u].end());
      }
    }
  }

  void add_copy(const CopyUnit& unit, BackboneResidue residue, std::size_t copy) {
    const UnitPart& part = unit.part_of(residue.ca);
    for (std::uint32_t* atom : {&residue.first, &residue.ca, &residue.n, &residue.c, &residue.o}) {
      if (*atom != kNoAtom) *atom = static_cast<std::uint32_t>(part.of_copy(*atom, copy));
    }
    result_.incomplete += !residue.complete();
    result_.residues.push_back(residue);
  }

  void count_runs() {
    for (std::size_t k = 0; k < result_.kinds.size(); ++k) {
      const bool goes_on = k > 0 && result_.residues[k - 1].bound_to_next &&
                           result_.kinds[k - 1] == result_.kinds[k];
      if (!goes_on) ++result_.runs[static_cast<std::size_t>(result_.kinds[k])];
    }
  }

  const Molecule& molecule_;
  const RunContext& context_;
  std::vector<CopyUnit> units_;
  std::vector<std::vector<BackboneResidue>> residues_;  // of the first copy of each unit
  std::vector<std::vector<Kind>> kinds_;                // of the same residues
  SecondaryModel result_;
};

std::string count_text(std::size_t count, const char* one, const char* many) {
  return grouped(count) + ' ' + (count == 1 ? one : many);
}

}  // namespace

SecondaryModel find_secondary(const Molecule& molecule, const ModelRange& model,
                              SecondaryChoice choice, const RunContext& context) {
  return SecondaryFinder(molecule, model, context).find(choice);
}

SecondaryModel find_secondary_of_models(const Molecule& molecule, const ModelRange& models,
                                        const RunContext& context) {
  SecondaryModel all;
  for (const ModelRange& model : molecule.models) {
    if (model.begin < models.begin || model.end > models.end) continue;
    const SecondaryModel found =
        find_secondary(molecule, model, SecondaryChoice::automatic, context);
    all.source = found.source;
    all.residues.insert(all.residues.end(), found.residues.begin(), found.residues.end());
    all.kinds.insert(all.kinds.end(), found.kinds.begin(), found.kinds.end());
  }
  return all;
}

std::string summary(const SecondaryModel& secondary) {
  if (secondary.source == SecondarySource::none) return {};
  const auto runs = [&](Kind kind) { return secondary.runs[static_cast<std::size_t>(kind)]; };
  const std::size_t alpha = runs(Kind::alpha_helix), three_ten = runs(Kind::three_ten_helix),
                    pi = runs(Kind::pi_helix);
  std::string text = count_text(alpha + three_ten + pi, "helix", "helices");
  std::string kinds;
  for (const auto& [count, name] :
       {std::pair(alpha, "alpha"), std::pair(three_ten, "3-10"), std::pair(pi, "pi")}) {
    if (count > 0) kinds += (kinds.empty() ? "" : ", ") + grouped(count) + ' ' + name;
  }
  if (!kinds.empty()) text += " (" + kinds + ")";
  text += ", " + count_text(runs(Kind::strand), "strand", "strands");
  const bool from_file = secondary.source == SecondarySource::file;
  text += from_file ? "; from the file's records" : "; from hydrogen bonds (DSSP)";
  if (!from_file && secondary.incomplete > 0) {
    text +=
        "; " + count_text(secondary.incomplete, "residue lacks", "residues lack") + " N, C or O";
  }
  if (secondary.crowded > 0) {
    text += "; " + count_text(secondary.crowded, "residue has", "residues have") +
            " too many others at one place";
  }
  return text;
}

const char* secondary_id(SecondaryStructure kind) {
  constexpr const char* kIds[kSecondaryStructures] = {
      "coil",     "bend",        "turn",   "polyproline", "three_ten_helix",
      "pi_helix", "alpha_helix", "bridge", "strand"};
  return kIds[static_cast<std::size_t>(kind)];
}

const char* secondary_source_id(SecondarySource source) {
  constexpr const char* kIds[] = {"none", "file", "hydrogen_bonds"};
  return kIds[static_cast<std::size_t>(source)];
}

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// Reads, expands and prepares a molecule, and repeats only the changed steps under other options.
#include "app/session/open_molecule.hpp"

#include <utility>

#include "core/molecule/assembly.hpp"
#include "core/read/read_molecule.hpp"
#include "core/read/user_radii.hpp"
#include "core/selection/residue_groups.hpp"
#include "core/selection/treatments.hpp"

namespace alphascope {
namespace {

std::shared_ptr<const PreparedBalls> prepare(const Molecule& molecule, const OpenOptions& options,
                                             const RunContext& context) {
  context.report("selection and radii", 0);
  BallOptions balls = options.balls;
  if (options.sandbox) {
    balls = {};
    balls.radii = RadiiSet::file;
  }
  if (balls.radii == RadiiSet::user && !balls.user_radii && !options.radii_table.empty()) {
    balls.user_radii = read_user_radii(options.radii_table, context);
  }
  return std::make_shared<const PreparedBalls>(prepare_balls(molecule, balls, context));
}

void expand(OpenedMolecule& opened, const OpenOptions& options, const RunContext& context) {
  opened.molecule = opened.deposited;
  if (options.sandbox) {
    opened.molecule =
        std::make_shared<const Molecule>(sandbox_molecule(*opened.deposited, *options.sandbox));
  } else if (!options.assembly.empty()) {
    context.report("assembly", 0);
    opened.molecule = std::make_shared<const Molecule>(
        expand_assembly(*opened.deposited, options.assembly, context));
  }
  TreatedAtoms atoms;
  if (!options.sandbox && !options.balls.treated.empty()) {
    auto treated = std::make_shared<Molecule>(*opened.molecule);
    atoms = apply_treatments(*treated, options.balls.treated);
    opened.molecule = std::move(treated);
  }
  opened.treated = std::make_shared<const TreatedAtoms>(std::move(atoms));
  opened.contents = std::make_shared<const MoleculeContents>(contents_of(*opened.molecule));
}

// Lists the residues of the chosen model. To be called after prepare(), which refuses a model that
// does not exist.
void list_residues_of_model(OpenedMolecule& opened, const OpenOptions& options) {
  const Molecule& molecule = *opened.molecule;
  std::size_t begin = 0, end = molecule.atoms.size();
  if (!options.sandbox && options.balls.model != kAllModels) {
    const ModelRange& model = molecule.models[static_cast<std::size_t>(options.balls.model)];
    begin = model.begin, end = model.end;
  }
  opened.residues = std::make_shared<const ResidueGroups>(residue_groups(
      *opened.deposited, molecule, begin, end, options.balls.treated, *opened.treated));
}

}  // namespace

OpenedMolecule open_molecule(const std::filesystem::path& path, const OpenOptions& options,
                             const RunContext& context) {
  OpenedMolecule opened;
  opened.deposited = std::make_shared<const Molecule>(read_molecule(path, options.read, context));
  context.cancel.throw_if_cancelled();
  opened.assemblies = list_assemblies(*opened.deposited);
  expand(opened, options, context);
  opened.prepared = prepare(*opened.molecule, options, context);
  list_residues_of_model(opened, options);
  opened.options = options;
  return opened;
}

OpenedMolecule reopen_molecule(const OpenedMolecule& opened, const OpenOptions& options,
                               const RunContext& context) {
  OpenedMolecule result = opened;
  const bool other_atoms = options.assembly != opened.options.assembly ||
                           options.sandbox != opened.options.sandbox ||
                           options.balls.treated != opened.options.balls.treated;
  if (other_atoms) expand(result, options, context);
  result.prepared = prepare(*result.molecule, options, context);
  if (other_atoms || options.balls.model != opened.options.balls.model) {
    list_residues_of_model(result, options);
  }
  result.options = options;
  return result;
}

bool same_atoms(const OpenedMolecule& a, const OpenedMolecule& b) {
  if (a.molecule == b.molecule) return true;
  return a.deposited == b.deposited && a.options.assembly == b.options.assembly &&
         !a.options.sandbox && !b.options.sandbox;
}

}  // namespace alphascope

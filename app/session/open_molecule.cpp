#include "app/session/open_molecule.hpp"

#include <utility>

#include "core/molecule/assembly.hpp"

namespace alphascope {

OpenedMolecule open_molecule(const std::filesystem::path& path, const OpenOptions& options,
                             const RunContext& context) {
  auto molecule = std::make_shared<Molecule>(read_molecule(path, options.read, context));
  context.cancel.throw_if_cancelled();
  if (!options.assembly.empty()) {
    context.report("assembly", 0);
    *molecule = expand_assembly(*molecule, options.assembly, context);
  }
  context.report("selection and radii", 0);
  auto prepared = std::make_shared<PreparedBalls>(prepare_balls(*molecule, options.balls));
  return {std::move(molecule), std::move(prepared)};
}

}  // namespace alphascope

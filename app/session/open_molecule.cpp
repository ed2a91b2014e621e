#include "app/session/open_molecule.hpp"

#include <utility>

namespace alphascope {

OpenedMolecule open_molecule(const std::filesystem::path& path, const OpenOptions& options,
                             const RunContext& context) {
  auto molecule = std::make_shared<Molecule>(read_molecule(path, options.read, context));
  context.cancel.throw_if_cancelled();
  context.report("selection and radii", 0);
  auto prepared = std::make_shared<PreparedBalls>(prepare_balls(*molecule, options.balls));
  return {std::move(molecule), std::move(prepared)};
}

}  // namespace alphascope

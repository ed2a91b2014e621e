// Any bytes as a file of one format: a molecule that keeps its promises, or a ReadError.
#include <cstdlib>

#include "core/io/read_error.hpp"
#include "core/io/readers.hpp"
#include "core/molecule/prepare_balls.hpp"

namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

void check(const alphascope::Molecule& m) {
  require(!m.atoms.empty() && !m.models.empty());
  std::size_t next = 0;
  for (const alphascope::ModelRange& model : m.models) {
    require(model.begin == next && model.end > model.begin);
    next = model.end;
  }
  require(next == m.atoms.size());
  const auto inside = [](std::int32_t c) {
    return c >= -alphascope::kMaxLatticeCoordinate && c <= alphascope::kMaxLatticeCoordinate;
  };
  for (const alphascope::Atom& a : m.atoms) {
    require(inside(a.position.x) && inside(a.position.y) && inside(a.position.z));
    require(a.name < m.names.size() && a.residue_name < m.names.size() && a.chain < m.names.size());
  }
  alphascope::BallOptions all;
  all.model = alphascope::kAllModels;
  const alphascope::PreparedBalls prepared = alphascope::prepare_balls(m, all);
  for (const std::int32_t radius : prepared.balls->radii) {
    require(radius > 0 && radius <= alphascope::kMaxLatticeRadius);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const alphascope::Molecule m = alphascope::ALPHASCOPE_FUZZ_READER({"fuzz", text, {}});
    check(m);
    for (const alphascope::AssemblyInfo& info : alphascope::list_assemblies(m)) {
      if (info.atoms > 0 && info.atoms < 10000) check(alphascope::expand_assembly(m, info.id));
    }
  } catch (const alphascope::ReadError& error) {
    require(!error.reason().empty() && !error.remedy().empty());
  } catch (const std::invalid_argument&) {
    // An assembly that leaves the lattice.
  }
  return 0;
}

// What alphascope-cli leaves behind: files, standard output, exit codes, signals.
#include <csignal>

#include "tests/app/cli_fixture.hpp"

namespace alphascope::testing {
namespace {

TEST_F(Cli, NoOutputSaysInfAtTheLargestAlpha) {
  // Four nearly coplanar centres on the finest lattice: one sphere through them of some 10^7 Å.
  const fs::path flat =
      write("flat.xyzr", "0 0 0 1\n500 0 0 1.000001\n0 500 0 1\n400 400 0.000001 1\n9 -9 0 0.5\n");
  const fs::path out = folder_ / "flat.alpha", table = folder_ / "flat.csv";
  for (const char* engine : {"cpu", "cgal", "tuples-cpu"}) {
    const Outcome outcome =
        run("compute '" + flat.string() + "' --alpha 1e24 --engine " + engine + " --out '" +
            out.string() + "' --csv '" + table.string() + "' --json -");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(result["request"]["alpha_used_square_lattice_units"], 1e36);
    EXPECT_GT(result["counts"]["tetrahedra"], 0);
    for (const std::string& text : {outcome.out, contents(out), contents(table)}) {
      EXPECT_FALSE(contains(text, "inf")) << text;
      EXPECT_FALSE(contains(text, "nan")) << text;
    }
  }
  for (const char* alpha : {"1.1e24", "-1.1e24", "3.5e32", "1e308", "nan", "1e999"}) {
    for (const char* command : {"compute", "verify", "bench"}) {
      const Outcome outcome =
          run(std::string(command) + " '" + flat.string() + "' --alpha " + alpha);
      EXPECT_EQ(outcome.code, 2) << command << " " << alpha;
      EXPECT_TRUE(contains(outcome.err, "is not a number from -1e+24 to 1e+24")) << outcome.err;
    }
  }
}

}  // namespace
}  // namespace alphascope::testing

// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the file that is read while the window is being made: it is read once, and nobody else gets
// it.
#include "app/viewer/read_ahead.hpp"

#include <atomic>

#include "app/session/open_molecule.hpp"
#include "core/read/read_molecule.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

struct Counted {
  std::atomic<int> reads = 0;
  Session::Opener opener() {
    return [this](const fs::path& path, const OpenOptions& options, const RunContext& context) {
      ++reads;
      return open_molecule(path, options, context);
    };
  }
};

TEST(ReadAhead, IsTakenOverOnce) {
  Counted counted;
  const Session::Opener open = read_ahead(crambin(), counted.opener());
  EXPECT_EQ(open(crambin(), OpenOptions(), {}).molecule->atoms.size(), 327u);
  EXPECT_EQ(counted.reads, 1);
  EXPECT_EQ(open(crambin(), OpenOptions(), {}).molecule->atoms.size(), 327u);
  EXPECT_EQ(counted.reads, 2) << "the file may have changed since";
}

TEST(ReadAhead, IsForUsualOptionsOfThatFile) {
  Counted counted;
  const Session::Opener open = read_ahead(crambin(), counted.opener());
  OpenOptions others;
  others.balls.without_chains = {"B"};
  EXPECT_EQ(open(crambin(), others, {}).options, others);
  EXPECT_THROW(open("/nonexistent/a.pdb", OpenOptions(), {}), std::exception);
  // The read ahead counts only if it began before it was cancelled.
  EXPECT_GE(counted.reads, 2);
}

TEST(ReadAhead, FaultsAndCancellingReachTheOneWhoOpens) {
  const fs::path bad = fs::temp_directory_path() / ("ahead_" + std::to_string(getpid()) + ".pdb");
  std::ofstream(bad) << "no atoms\n";
  Counted counted;
  EXPECT_THROW(read_ahead(bad, counted.opener())(bad, OpenOptions(), {}), ReadError);
  fs::remove(bad);
  const auto waits = [](const fs::path&, const OpenOptions&,
                        const RunContext& context) -> OpenedMolecule {
    for (;;) context.cancel.throw_if_cancelled();
  };
  RunContext cancelled;
  cancelled.cancel.cancel();
  EXPECT_THROW(read_ahead(crambin(), waits)(crambin(), OpenOptions(), cancelled), Cancelled);
  read_ahead(crambin(), waits);  // nobody takes it over: its thread ends
}

}  // namespace
}  // namespace alphascope::testing

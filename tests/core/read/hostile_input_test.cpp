// SPDX-License-Identifier: GPL-3.0-or-later
// Tests damaged, absurd or malicious input. The result is a message or the right molecule, never a
// crash, a hang or a silently different molecule.
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

std::string gzip(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, text.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

struct Sample {
  const char* name;
  std::string text;
};

std::vector<Sample> samples() {
  return {
      {"a.pdb",
       "TITLE     SMALL\nREMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
       "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
       "MODEL        1\n"
       "ATOM      1  N   MET A   1      27.340  24.430   2.614  1.00  9.67           N  \n"
       "HETATM    2 ZN    ZN A   3       1.266  25.413   8.842  1.00 10.38          ZN  "
       "\nENDMDL\n"},
      {"a.cif",
       "data_X\n_struct.title\n;two\nlines\n;\nloop_\n_pdbx_struct_oper_list.id\n"
       "_pdbx_struct_oper_list.matrix[1][1]\n1 1.0\nloop_\n_atom_site.id\n_atom_site.type_symbol\n"
       "_atom_site.label_atom_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
       "1 C \"C5'\" 1.25 2.5 3.75\n2 O 'O x' 4.25 5.5 6.75\n"},
      {"a.pqr",
       "REMARK 1 PQR file\nATOM 1 N ILE A 16 5.25 -9.5 18.75 -0.3 1.85\n"
       "ATOM      2  CA  ALA A   1    1999.3232998.770-900.490  0.1414 1.8240\n"},
      {"a.xyz", "2\nProperties=species:S:1:pos:R:3\nC 1.25 2.5 3.75\nO 4.25 5.5 6.75\n"},
      {"t.xyz", " 2 water\n 1 O 1.25 2.5 3.75 1 2\n 2 H 4.25 5.5 6.75 2 1\n"},
      {"a.xyzr", "# balls\nA 1 CA 1.25 2.5 3.75 1.5\nA 2 CB 4.25 5.5 6.75 1.75\n"},
      {"a.crd", "2\n\n1.25 2.5 3.75 1.5\n4.25 5.5 6.75 1.75\n"},
      {"c.crd",
       "* T\n    2\n    1    1 LYS  N    -14.05410-114.28359  43.57444 G    1      0.00000\n"
       "    2    2 ZN2  ZN     1.00000   2.00000   3.00000 HET  12A    0.00000\n"},
      {"a.gro",
       "T\n    2\n    1SOL     OW    1   0.126   1.624   1.679\n"
       "    1SOL    HW1    2   0.190   1.661   1.747  0.1227 -0.0580  0.0434\n"
       "   1.86824   1.86824   1.86824\n"},
      {"a.mol2",
       "@<TRIPOS>MOLECULE\nx\n2 1 1\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n"
       "1 C1 1.25 2.5 3.75 C.3 1 LIG1 0.1\n2 O1 4.25 5.5 6.75 O.3 1 LIG1 -0.1\n"
       "@<TRIPOS>BOND\n1 1 2 1\n@<TRIPOS>SUBSTRUCTURE\n1 LIG1 1 GROUP 0 A LIG\n"}};
}

TEST(HostileInput, TruncationAtEveryByte) {
  for (const Sample& sample : samples()) {
    const Molecule whole = read_text(sample.name, sample.text);
    ASSERT_EQ(whole.atoms.size(), 2u) << sample.name;
    for (std::size_t length = 0; length < sample.text.size(); ++length) {
      SCOPED_TRACE(std::string(sample.name) + " cut to " + std::to_string(length) + " bytes");
      try {
        const Molecule m = read_text(sample.name, sample.text.substr(0, length));
        ASSERT_LE(m.atoms.size(), 2u);
        // Only an atom in the cut line may differ. A note then says so.
        const bool cut = sample.text[length - 1] != '\n' && m.format != "PDB";
        if (cut) {
          ASSERT_FALSE(m.notes.empty());
        }
        for (std::size_t i = 0; i + (cut ? 1 : 0) < m.atoms.size(); ++i) {
          const double there = whole.lattice.angstrom(whole.atoms[i].position.x);
          ASSERT_EQ(m.lattice.angstrom(m.atoms[i].position.x), there);
        }
      } catch (const ReadError& error) {
        ASSERT_FALSE(error.reason().empty());
        ASSERT_FALSE(error.remedy().empty());
      }
    }
  }
}

TEST(HostileInput, EveryByteReplaced) {
  for (const Sample& sample : samples()) {
    for (std::size_t at = 0; at < sample.text.size(); ++at) {
      for (const char c : {'\0', '\n', ' ', '9', '-', '"', ';', '\xff'}) {
        std::string text = sample.text;
        text[at] = c;
        try {
          prepare_balls(read_text(sample.name, text));
        } catch (const ReadError&) {
        }
      }
    }
  }
}

TEST(HostileInput, GzipTruncatedDamagedAndEndless) {
  std::string text;
  for (int k = 0; k < 2000; ++k) text += std::to_string(k * 7919 % 1000) + " 2 3 1.5\n";
  const std::string packed = gzip(text);
  EXPECT_EQ(read_text("a.xyzr.gz", packed).atoms.size(), 2000u);
  EXPECT_EQ(read_text("a.xyzr", packed).atoms.size(), 2000u) << "by content, not by name";
  EXPECT_EQ(read_text("a.xyzr.gz", packed + packed).atoms.size(), 4000u) << "two members";
  for (std::size_t length = 2; length < packed.size(); length += 13) {
    const ReadError error = refusal("a.xyzr.gz", packed.substr(0, length));
    EXPECT_EQ(error.reason(), "the gzip data end too early: the file is truncated") << length;
  }
  std::string damaged = packed;
  damaged[damaged.size() / 2] ^= '\x55';
  EXPECT_NE(refusal("a.xyzr.gz", damaged).reason().find("gzip"), std::string::npos);
  ReadOptions small;
  small.max_bytes = 1 << 20;
  const std::string bomb = gzip(std::string(std::size_t{64} << 20, '\n'));
  EXPECT_LT(bomb.size(), 100000u);
  EXPECT_NE(refusal("a.pdb.gz", bomb, small).reason().find("limit of 1 MiB"), std::string::npos);
}

// Small limits are those of lessons, sessions and tables, for which the remedy of a molecule would
// mislead.
TEST(HostileInput, ASmallLimitIsSaidInItsUnit) {
  ReadOptions small;
  for (const auto& [bytes, said] :
       {std::pair<std::uint64_t, const char*>{500, "of 500 bytes"}, {3 << 10, "of 3 KiB"}}) {
    small.max_bytes = bytes;
    const ReadError error = refusal("a.pdb", std::string(5000, '\n'), small);
    EXPECT_TRUE(error.reason().ends_with(said)) << error.reason();
    EXPECT_EQ(error.remedy().find("atoms"), std::string::npos) << error.remedy();
  }
}

TEST(HostileInput, WhatIsInTheWayOfOpeningIsSaid) {
  const TemporaryFile file("a.pdb", "x");
  const std::filesystem::path loop = file.path().parent_path() / "loop.pdb";
  const std::filesystem::path link = file.path().parent_path() / "link.pdb";
  std::filesystem::create_symlink("loop.pdb", loop);
  std::filesystem::create_symlink("nowhere.pdb", link);
  const auto reason = [](const std::filesystem::path& path) {
    try {
      read_molecule(path);
    } catch (const ReadError& error) {
      return error.reason();
    }
    return std::string();
  };
  EXPECT_EQ(reason(loop), "the file cannot be opened: Too many levels of symbolic links");
  EXPECT_EQ(reason(link), "this is a link to a file that does not exist");
  EXPECT_EQ(reason(file.path() / "x.pdb"), "the file cannot be opened: Not a directory");
  EXPECT_EQ(reason(file.path().parent_path() / std::string(300, 'x')),
            "the file cannot be opened: File name too long");
  EXPECT_EQ(reason(file.path().parent_path() / "none.pdb"), "there is no such file");
}

TEST(HostileInput, WhatFollowsGzipDataIsNeverLost) {
  const std::string packed = gzip("1 2 3 1.5\n");
  EXPECT_EQ(read_text("a.xyzr.gz", packed + std::string(600, '\0')).atoms.size(), 1u) << "padding";
  EXPECT_EQ(read_text("a.xyzr.gz", packed + packed + std::string(1, '\0')).atoms.size(), 2u);
  const ReadError text = refusal("a.xyzr.gz", packed + "4 5 6 1.5\n");
  EXPECT_NE(text.reason().find("byte " + std::to_string(packed.size())), std::string::npos);
  EXPECT_NE(text.reason().find("\"4 5 6 1.5\""), std::string::npos) << text.what();
  EXPECT_NE(text.remedy().find("append"), std::string::npos);
  for (const std::string& rest : {std::string("\x01\x02"), std::string(9, '\0') + "x",
                                  std::string(1, '\0') + packed, std::string("\x8b\x1f")}) {
    EXPECT_NE(refusal("a.xyzr.gz", packed + rest).reason().find("other data follow"),
              std::string::npos);
  }
  for (const std::size_t length : {1, 2, 9}) {
    EXPECT_EQ(refusal("a.xyzr.gz", packed + packed.substr(0, length)).reason(),
              "the gzip data end too early: the file is truncated");
  }
}

TEST(HostileInput, PipesAndForbiddenFilesAreNamed) {
  const TemporaryFile file("a.pdb", "x");
  const std::filesystem::path pipe = file.path().parent_path() / "pipe.pdb";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(read_molecule(pipe), ReadError) << "and does not wait for a writer";
  EXPECT_THROW(read_molecule("/dev/zero"), ReadError);
  EXPECT_THROW(read_molecule(file.path() / "x.pdb"), ReadError) << "a file is no folder";
}

// Root may read all files, so a child process drops that right first.
TEST(HostileInput, AFileWithoutPermissionIsNamed) {
  const TemporaryFile file("a.pdb", "x");
  std::filesystem::permissions(file.path(), std::filesystem::perms::none);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);
    try {
      read_molecule(file.path());
    } catch (const ReadError& error) {
      _exit(error.reason() == "the file cannot be opened: Permission denied" ? 0 : 1);
    }
    _exit(1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

long peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss >> 10;
}

TEST(HostileInput, ALineOfTwoGigabytesIsRefusedBeforeItIsRead) {
  const TemporaryFile file("a.pdb", "REMARK 1\nATOM  ");
  std::filesystem::resize_file(file.path(), std::uintmax_t{2} << 30);  // zeros; takes no disk
  const long before = peak_mebibytes();
  try {
    read_molecule(file.path());
    ADD_FAILURE();
  } catch (const ReadError& error) {
    EXPECT_EQ(error.reason(), "this line is longer than 16 MiB");
    EXPECT_EQ(error.line(), 2u);
  }
  EXPECT_LT(peak_mebibytes() - before, 512);
}

TEST(HostileInput, ABombIsRefusedWithoutTheMemoryThatItAsksFor) {
  const std::string member = gzip(std::string(std::size_t{64} << 20, '\n'));
  std::string bomb;
  for (int k = 0; k < 100; ++k) bomb += member;  // 6.25 GiB
  const TemporaryFile file("a.pdb.gz", bomb);
  try {
    read_molecule(file.path());
    ADD_FAILURE();
  } catch (const ReadError& error) {
    EXPECT_NE(error.reason().find("more than 200 times"), std::string::npos) << error.what();
    EXPECT_EQ(error.line(), 0u) << "of the whole file";
  }
  // A long line, packed.
  const std::string line = gzip(std::string(std::size_t{64} << 20, 'x'));
  EXPECT_EQ(refusal("a.pdb.gz", line).reason(), "this line is longer than 16 MiB");
}

TEST(HostileInput, HugeLinesAndCounts) {
  const std::string line(std::size_t{15} << 20, 'x');
  EXPECT_LT(refusal("a.pdb", line).reason().size(), 300u) << "the message stays short";
  EXPECT_LT(refusal("a.pdb", "ATOM  " + line).reason().size(), 300u);
  EXPECT_LT(refusal("a.xyzr", "1 2 3 " + line).reason().size(), 300u);
  EXPECT_LT(refusal("a.cif", "data_" + line).reason().size(), 300u);
  EXPECT_EQ(refusal("a.crd", "4000000000\n\n1 2 3 1.5\n").line(), 1u);
  EXPECT_EQ(refusal("a.crd", "* T\n4000000000\n").line(), 2u);
}

TEST(HostileInput, AbsurdNumbers) {
  for (const char* number : {"1e300", "-1e300", "1e99999999999999999999", "nan", "inf", "0x1p4"}) {
    EXPECT_EQ(refusal("a.xyzr", std::string("1 2 3 1\n") + number + " 2 3 1\n").line(), 2u)
        << number;
  }
  // A number far below the lattice becomes zero, and the rounding is reported.
  const Molecule tiny = read_text("a.xyzr", "1e-300 2 3 1\n");
  EXPECT_EQ(tiny.atoms[0].position.x, 0);
  EXPECT_EQ(tiny.notes.size(), 1u);
  EXPECT_EQ(refusal("a.xyzr", "1 2 3 1\n1 2 3 1e-300\n").line(), 2u) << "a radius must not vanish";
  EXPECT_EQ(read_text("a.xyzr", "536870911 0 0 1\n").lattice.digits, 0);
  EXPECT_EQ(refusal("a.xyzr", "536870912 0 0 1\n").line(), 1u);
}

// A file of each format with one atom. Its y is @, and its radius, if any, is %.
const Sample kTemplates[] = {
    {"a.pdb", "ATOM      1  N   MET A   1      27.340@   2.614\n"},
    {"a.cif",
     "data_X\nloop_\n_atom_site.id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
     "1 1.25 @ 3.75\n"},
    {"a.pqr", "REMARK 1 PQR file\nATOM 1 N ILE A 16 5.25 @ 18.75 -0.3 %\n"},
    {"a.xyz", "1\nProperties=species:S:1:pos:R:3:radius:R:1\nC 1.25 @ 3.75 %\n"},
    {"t.xyz", " 1 water\n 1 O 1.25 @ 3.75 1\n"},
    {"a.xyzr", "1.25 @ 3.75 %\n"},
    {"b.xyzr", "A 1 CA 1.25 @ 3.75 %\n"},
    {"a.crd", "1\n\n1.25 @ 3.75 %\n"},
    {"c.crd", "* T\n    1\n    1    1 LYS  N    -14.05410@  43.57444 G    1      0.00000\n"}};

// Columns of PDB files are 8 wide, those of CHARMM files 10.
std::string filled(const Sample& sample, std::string number, const std::string& radius) {
  std::string text = sample.text;
  const std::string_view name = sample.name;
  const std::size_t width = name == "a.pdb" ? 8 : name == "c.crd" ? 10 : 0;
  if (number.size() < width) number.insert(0, width - number.size(), ' ');
  text.replace(text.find('@'), 1, number);
  const std::size_t at = text.find('%');
  if (at != std::string::npos) text.replace(at, 1, radius);
  return text;
}

TEST(HostileInput, EveryFormatRefusesNumbersThatAreNone) {
  for (const Sample& sample : kTemplates) {
    const std::size_t lines =
        static_cast<std::size_t>(std::count(sample.text.begin(), sample.text.end(), '\n'));
    ASSERT_EQ(read_text(sample.name, filled(sample, "2.5", "1.5")).atoms.size(), 1u) << sample.name;
    for (const char* number : {"nan", "inf", "-inf", "NaN", "1e300", "-1e300", "0x1p4", "1,5"}) {
      SCOPED_TRACE(std::string(sample.name) + " " + number);
      const ReadError error = refusal(sample.name, filled(sample, number, "1.5"));
      EXPECT_EQ(error.line(), lines) << error.what();
      EXPECT_FALSE(error.remedy().empty());
    }
    if (sample.text.find('%') == std::string::npos) continue;
    for (const char* radius : {"nan", "inf", "1e300", "-1.5", "-1e-9", "1e-300"}) {
      SCOPED_TRACE(std::string(sample.name) + " radius " + radius);
      const ReadError error = refusal(sample.name, filled(sample, "2.5", radius));
      EXPECT_EQ(error.line(), lines) << error.what();
      EXPECT_FALSE(error.remedy().empty());
    }
    // A file may give the radius 0. Such an atom is counted in the report, and is never silently a
    // ball.
    const Molecule zero = read_text(sample.name, filled(sample, "2.5", "0"));
    EXPECT_FALSE(zero.has_file_radii);
    const auto says_zero = [](const std::string& note) {
      return note.starts_with("Every radius in the file is 0");
    };
    EXPECT_EQ(std::count_if(zero.notes.begin(), zero.notes.end(), says_zero), 1) << sample.name;
    EXPECT_GT(prepare_balls(zero).balls->radii.at(0), 0);
  }
}

TEST(HostileInput, AMillionCoincidentAtoms) {
  std::string text;
  for (int k = 0; k < 1000000; ++k) text += "1 2 3 1.5\n";
  const PreparedBalls prepared = prepare_balls(read_text("a.xyzr", text));
  EXPECT_EQ(prepared.report.used, 1000000u);
  EXPECT_EQ(prepared.report.coincident_centres, 999999u);
}

TEST(HostileInput, CancellingStopsTheReader) {
  const TemporaryFile file("a.xyzr", "1 2 3 1.5\n");
  RunContext context;
  context.cancel.cancel();
  EXPECT_THROW(read_molecule(file.path(), {}, context), Cancelled);
}

TEST(HostileInput, LineEndsOfAllSystems) {
  EXPECT_EQ(read_text("a.xyzr", "1 2 3 1.5\r\n4 5 6 1.5\r\n").atoms.size(), 2u);
  EXPECT_EQ(read_text("a.xyzr", "1 2 3 1.5\r4 5 6 1.5\r").atoms.size(), 2u);
  EXPECT_EQ(read_text("a.xyzr",
                      "\xEF\xBB\xBF"
                      "1 2 3 1.5\n")
                .atoms.size(),
            1u);
}

}  // namespace
}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// Tests references under changes of all options. An atom keeps its name, comes back when the
// options include it again, and never turns into another atom.
#include "core/document/reference/reference.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/radii/radii_choice.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/prepare_balls.hpp"
#include "tests/core/files/temporary_file.hpp"

namespace alphascope {
namespace {

// Two assemblies: two copies of chains A and B, or one of A and two more of A by another generator.
constexpr const char* kFile =
    "REMARK 350 BIOMOLECULE: 1\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A, B\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000       90.00000\n"
    "REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350 BIOMOLECULE: 2\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A, B\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
    "REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000       90.00000\n"
    "REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350   BIOMT1   3 -1.000000  0.000000  0.000000       50.00000\n"
    "REMARK 350   BIOMT2   3  0.000000 -1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   3  0.000000  0.000000  1.000000        0.00000\n"
    "ATOM      1  N   SER A   1       1.000   2.000   3.000  1.00  9.67           N  \n"
    "ATOM      2  H   SER A   1       1.500   2.900   3.000  1.00  9.67           H  \n"
    "ATOM      3  CB ASER A   1       3.000   2.000   3.000  0.60  9.67           C  \n"
    "ATOM      4  CB BSER A   1       3.000   3.000   3.000  0.40  9.67           C  \n"
    "ATOM      5  O   SER A   1       5.000   2.000   3.000  1.00  9.67           O  \n"
    "ATOM      6  CA  GLY B   2      11.000   2.000   3.000  1.00  9.67           C  \n"
    "HETATM    7  O   HOH B   3      15.000   2.000   3.000  1.00  9.67           O  \n";

struct Options {
  std::string assembly;
  HydrogenRule hydrogens = HydrogenRule::keep;
  AltlocRule altlocs = AltlocRule::best;
  bool waters = false;
};

BallReferences with(const Options& options) {
  static const Molecule deposited = read_text("a.pdb", kFile);
  auto molecule = std::make_shared<const Molecule>(
      options.assembly.empty() ? deposited : expand_assembly(deposited, options.assembly));
  BallOptions balls;
  balls.radii = RadiiSet::bondi;
  balls.hydrogens = options.hydrogens;
  balls.altlocs = options.altlocs;
  balls.waters = options.waters;
  auto prepared = std::make_shared<const PreparedBalls>(prepare_balls(*molecule, balls));
  return {molecule, prepared};
}

std::string name(const BallReferences& references, BallIndex ball) {
  return atom_address(references.molecule(), references.prepared().atom_of_ball[ball]);
}

AtomRef ref(const BallReferences& references, const std::string& address) {
  const NamedAtoms named = named_atoms(references, address);
  EXPECT_EQ(named.balls.size(), 1u) << address;
  return named.balls.empty() ? AtomRef{99, 99} : std::get<AtomRef>(named.balls.front());
}

TEST(Reference, EveryBallComesBackUnderEveryOption) {
  for (const char* assembly : {"", "1", "2"}) {
    for (const HydrogenRule hydrogens : {HydrogenRule::keep, HydrogenRule::drop}) {
      for (const AltlocRule altlocs : {AltlocRule::best, AltlocRule::all}) {
        for (const bool waters : {false, true}) {
          const BallReferences r = with({assembly, hydrogens, altlocs, waters});
          std::set<AtomRef> seen;
          for (BallIndex ball = 0; ball < r.prepared().balls->size(); ++ball) {
            EXPECT_EQ(r.ball(r.atom(ball)), ball) << assembly << ' ' << ball;
            seen.insert(r.atom(ball));
          }
          EXPECT_EQ(seen.size(), r.prepared().balls->size()) << "each atom has its own";
        }
      }
    }
  }
}

TEST(Reference, AnAtomKeepsItsNameAsOthersComeAndGo) {
  const BallReferences all = with({"", HydrogenRule::keep, AltlocRule::all, true});
  const BallReferences few = with({"", HydrogenRule::drop, AltlocRule::best, false});
  const AtomRef oxygen = ref(all, "A:SER 1:O"), hydrogen = ref(all, "A:SER 1:H"),
                minor = ref(all, "A:SER 1:CB:B"), water = ref(all, "B:HOH 3:O");
  ASSERT_TRUE(few.ball(oxygen));
  EXPECT_NE(few.ball(oxygen), all.ball(oxygen)) << "or this would show nothing";
  EXPECT_EQ(name(few, *few.ball(oxygen)), "A:SER 1:O");
  EXPECT_FALSE(few.ball(hydrogen));
  EXPECT_FALSE(few.ball(minor));
  EXPECT_FALSE(few.ball(water));
  for (const AtomRef& atom : {oxygen, hydrogen, minor, water}) EXPECT_TRUE(all.ball(atom));
}

TEST(Reference, CopiesOfAnAssembly) {
  const BallReferences deposited = with({""}), first = with({"1"}), second = with({"2"});
  const AtomRef nitrogen = ref(deposited, "A:SER 1:N");
  EXPECT_EQ(nitrogen, (AtomRef{0, 0}));
  const AtomRef copied = ref(first, "A-2:SER 1:N");
  EXPECT_EQ(copied, (AtomRef{0, 1}));
  EXPECT_EQ(name(first, *first.ball(nitrogen)), "A:SER 1:N");
  EXPECT_FALSE(deposited.ball(copied)) << "there is one copy only";
  // Copies are numbered on through the second generator.
  EXPECT_EQ(ref(second, "A-3:SER 1:N"), (AtomRef{0, 2}));
  EXPECT_EQ(name(second, *second.ball({0, 1})), "A-2:SER 1:N");
  EXPECT_FALSE(second.ball({0, 3}));
  EXPECT_FALSE(second.ball({5, 1})) << "chain B is there once";
  EXPECT_EQ(name(second, *second.ball({5, 0})), "B:GLY 2:CA");
  EXPECT_FALSE(second.ball({7, 0})) << "beyond the file";
}

TEST(Reference, ASimplexIsThereWhenAllItsAtomsAre) {
  const BallReferences all = with({"", HydrogenRule::keep}), few = with({"", HydrogenRule::drop});
  const BallIndex corners[] = {3, 0, 1};
  const Ref triangle = all.reference(corners);
  EXPECT_EQ(triangle, Ref(SimplexRef({{0, 0}, {1, 0}, {4, 0}})));
  EXPECT_EQ(all.balls(triangle), (std::vector<BallIndex>{0, 1, 3}));
  EXPECT_FALSE(few.balls(triangle));
  const BallIndex heavy[] = {0, 3};
  ASSERT_TRUE(few.balls(all.reference(heavy)));
  EXPECT_EQ(few.balls(all.reference(heavy)), (std::vector<BallIndex>{0, 2}));
  EXPECT_EQ(all.reference(std::span(corners).subspan(2)), Ref(AtomRef{1, 0}));
}

TEST(Reference, FilesWithoutNames) {
  const auto molecule =
      std::make_shared<const Molecule>(read_text("a.xyzr", "0 0 0 1\n5 0 0 1.5\n9 0 0 2\n"));
  const BallReferences r(molecule, std::make_shared<const PreparedBalls>(prepare_balls(*molecule)));
  EXPECT_EQ(r.atom(1), (AtomRef{1, 0}));
  EXPECT_EQ(name(r, 1), "#2");
  EXPECT_EQ(ref(r, "#2"), (AtomRef{1, 0}));
  EXPECT_EQ(r.ball({2, 0}), 2u);
}

TEST(Reference, NamedAtomsThatAreNoBallsAreCounted) {
  const BallReferences few = with({"", HydrogenRule::drop});
  const NamedAtoms serine = named_atoms(few, "A:SER 1");
  EXPECT_EQ(serine.balls.size(), 3u);
  EXPECT_EQ(serine.others, 2u) << "the hydrogen and the other location";
  EXPECT_EQ(named_atoms(few, "water").balls.size(), 0u);
  EXPECT_EQ(named_atoms(few, "water").others, 1u);
}

TEST(RefSet, IsASetThatCopiesShare) {
  const Ref a = AtomRef{1, 0}, b = AtomRef{0, 1}, edge = SimplexRef{{0, 0}, {1, 0}};
  const RefSet both(std::vector<Ref>{a, b, a});
  EXPECT_EQ(both.size(), 2u);
  EXPECT_EQ(both, RefSet(std::vector<Ref>{b, a}));
  EXPECT_TRUE(both.contains(a));
  EXPECT_FALSE(both.contains(edge));
  EXPECT_EQ(both.toggled(edge).size(), 3u);
  EXPECT_EQ(both.toggled(edge).toggled(edge), both);
  EXPECT_EQ(both.toggled(a).toggled(b), RefSet());
  EXPECT_NE(both, RefSet());
}

}  // namespace
}  // namespace alphascope

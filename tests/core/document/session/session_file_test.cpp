// SPDX-License-Identifier: GPL-3.0-or-later
// Tests session files. Every setting comes back, invalid values are reported with their line, and
// no text crashes the reader.
#include "core/document/session/session_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/document/session/json_fields.hpp"
#include "core/document/session/settings_fields.hpp"
#include "core/files/file_hash.hpp"
#include "core/files/read_error.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "tests/core/files/temporary_file.hpp"
#include "ui/panels/view_info.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

const std::string kHash(64, 'a');

// Counts the fields that visit_fields() lists for a struct.
struct Counter {
  std::size_t count = 0;
  template <class... Anything>
  void operator()(Anything&&...) {
    ++count;
  }
  template <class T>
  void object(const char*, T&) {
    ++count;
  }
  template <class T>
  void objects(const char*, std::vector<T>&) {
    ++count;
  }
  void model(const char*, int) { ++count; }
  void formerly(const char*, const char*) {}
};

template <class T>
std::size_t named_fields() {
  Counter counter;
  T value;
  visit_fields(counter, value);
  return counter.count;
}

// Counts the members of a struct: it can be initialised with that many values, and not with more.
struct Any {
  template <class T>
  operator T() const;  // NOLINT: in unevaluated contexts only
};
template <class T, class... Values>
constexpr std::size_t members() {
  if constexpr (requires { T{Values{}..., Any{}}; }) {
    return members<T, Values..., Any>();
  } else {
    return sizeof...(Values);
  }
}

SessionDocument unusual() {
  SessionDocument s;
  s.written_by = "alphascope 9";
  s.molecule = {"data/1crn.pdb", "/home/a/data/1crn.pdb", kHash};
  s.radii_table = {"radii.txt", "/home/a/radii.txt", std::string(64, 'b')};
  BallOptions& b = s.settings.open.balls;
  s.settings.open.read.format = format_from_id("tinker");
  s.settings.open.assembly = "2";
  b = {.radii = RadiiSet::user,
       .user_radii = nullptr,
       .model = 3,
       .altlocs = AltlocRule::all,
       .hydrogens = HydrogenRule::drop,
       .polymers = false,
       .ligands = false,
       .ions = false,
       .waters = true,
       .dummies = true,
       .chains = {"A", "\xff\xfe no UTF-8", "\"quoted\"\n"},
       .without_chains = {"ä"},
       .selection = "resi 1-20 and not name CA",
       .overrides = {{{"HEM", "FE", 26}, 1234567}, {{"", "Q", kUnknownElement}, 1000}},
       .treated = {"A:PU8 301=ligand", "QQ1=polymer"}};
  s.settings.request = {.alpha_angstrom2 = 0.1 + 0.2,
                        .solvent_radius_angstrom = 1.4,
                        .tetrahedra_only = true,
                        .engine = EngineChoice::tuples_cpu,
                        .threads = 3,
                        .tuples = {TupleGridKind::thesis, false, false, false, 5, false, 77}};
  DisplaySettings& d = s.settings.display;
  d = {.balls = false,
       .tetrahedra = false,
       .boundary = true,
       .triangles = true,
       .edges = true,
       .singular_only = false,
       .grown_balls = true,
       .ball_scale = 0.07f,
       .ball_opacity = 0.31f,
       .complex_opacity = 0.33f,
       .cavity_opacity = 0.61f,
       .shrink = 0.1f,
       .edge_thickness = 0.34f,
       .smooth_boundary = true,
       .ball_paint = {ColourBy::b_factor, ColourMap::cividis, ColourRange{-2.5, 61}, {}},
       .complex_paint = {ColourBy::single, {}, {}, Rgb8{1, 2, 250}},
       .ambient_occlusion = false,
       .shadow_strength = 0.21f,
       .depth_cue = 0.17f,
       .outlines = 2.25f,
       .face_lines = 0.75f,
       .samples = 5,
       .beside = {false, false, true, true}};
  s.settings.selection.items =
      RefSet({AtomRef{4, 0}, AtomRef{5, 2}, SimplexRef{{1, 0}, {2, 0}, {3, 7}}});
  s.settings.selection.cavities = RefSet({SimplexRef{{1, 0}, {2, 0}, {3, 0}, {4, 0}}});
  s.settings.cavity_settings.split_networks = true;
  s.settings.annotations = {
      {{LabelText::b_factor, AtomSet({{0, 3, 9}, {2, 1, 1}})},
       {LabelText::name, AtomSet({{0, 1, 1}})}},
      {{{{7, 0}, {3, 1}}}, {{{1, 0}, {9, 0}, {2, 0}, {2, 5}}}},
      {{{1, -2.5, 1e-9}, {1, -2.5, 1e-9}, "5 Å²"}, {{0, 0, 0}, {1, 2, 3}, ""}},
      true};
  s.view.light_theme = true;
  s.view.camera = {{7, 8, 9.5}, {1.0 / 3, -2e5, 1e-9}, {4, 5, 6}, {0, 0, 1}, 1.25};
  s.view.panels = {
      "cavities", 301.5, {"engine", "display"}, {AlphaScaling::root, -2, 1e6, true, 2.5}};
  s.view.picture = {.width = 640,
                    .height = 481,
                    .dpi = 150,
                    .background = read_background("transparent").value(),
                    .letters = 1.5,
                    .legend = false,
                    .scale_bar = true,
                    .caption = read_caption_parts("alpha,hash")};
  s.view.recording = {{RecordingKind::turntable, AlphaScaling::logarithm, 0.5, 3.25, -90.5,
                       TurnAxis::y, 7, true, 12.5},
                      true,
                      3.5,
                      {.width = 800,
                       .height = 600,
                       .legend = true,
                       .scale_bar = true,
                       .caption = read_caption_parts("file")}};
  return s;
}

void expect_same(const SessionDocument& a, const SessionDocument& b) {
  EXPECT_EQ(a.written_by, b.written_by);
  EXPECT_EQ(a.molecule, b.molecule);
  EXPECT_EQ(a.radii_table, b.radii_table);
  EXPECT_EQ(difference_text(a.settings, b.settings), "");
  EXPECT_EQ(a.settings, b.settings);
  EXPECT_EQ(a.view, b.view);
}

// A session with a molecule and this additional text.
std::string with(const std::string& more) {
  return "{ \"alphascope_session\": 1,\n \"molecule\": { \"path\": \"a.pdb\", \"sha256\": \"" +
         kHash + "\" }" + more + "\n}\n";
}

// The message for such a text; empty: none.
std::string fault(const std::string& text) {
  try {
    parse_session("S.json", text);
    return {};
  } catch (const ReadError& error) {
    return error.what();
  }
}

TEST(SessionFile, EveryMemberOfEverySettingIsNamed) {
  EXPECT_EQ(named_fields<DisplaySettings>(), members<DisplaySettings>());
  EXPECT_EQ(named_fields<AtomsBesideBody>(), members<AtomsBesideBody>());
  EXPECT_EQ(named_fields<Request>(), members<Request>());
  EXPECT_EQ(named_fields<TupleOptions>(), members<TupleOptions>());
  // The selection is one member and two fields: its items and its cavities.
  EXPECT_EQ(named_fields<Settings>(), members<Settings>() + 1);
  EXPECT_EQ(named_fields<Annotations>(), members<Annotations>());
  EXPECT_EQ(named_fields<AtomLabels>(), members<AtomLabels>());
  EXPECT_EQ(named_fields<Measurement>(), members<Measurement>());
  EXPECT_EQ(named_fields<NamedView>(), members<NamedView>());
  EXPECT_EQ(named_fields<CameraPlace>(), members<CameraPlace>());
  EXPECT_EQ(named_fields<AlphaSlider>(), members<AlphaSlider>());
  EXPECT_EQ(named_fields<PanelLayout>(), members<PanelLayout>());
  EXPECT_EQ(named_fields<SessionView>(), members<SessionView>());
  EXPECT_EQ(named_fields<PictureOptions>(), members<PictureOptions>());
  EXPECT_EQ(named_fields<Recording>(), members<Recording>());
  EXPECT_EQ(named_fields<RecordSettings>(), members<RecordSettings>());
  // Sessions store the options of balls but for a table in memory, the reader's format, the
  // assembly and the sandbox. Limit and descriptor belong to the program. The table of radii is a
  // FileReference of the session.
  EXPECT_EQ(members<ReadOptions>(), 3u);
  EXPECT_EQ(members<OpenOptions>(), 5u);
  EXPECT_EQ(named_fields<OpenOptions>(), members<BallOptions>() - 1 + 3);
}

TEST(SessionFile, EverySettingComesBack) {
  const SessionDocument s = unusual();
  const std::string text = session_text(s);
  const ReadSession read = parse_session("S.json", text);
  EXPECT_TRUE(read.notes.empty());
  expect_same(read.session, s);
  EXPECT_EQ(session_text(read.session), text);
}

// With default values, a field read from another's place would go unnoticed.
TEST(SessionFile, DefaultsComeBackAndUnusualValuesAreNone) {
  SessionDocument s;
  s.molecule = {"a", "/a", kHash};
  expect_same(parse_session("S.json", session_text(s)).session, s);
  expect_same(parse_session("S.json", with("")).session, [&] {
    SessionDocument least;
    least.molecule = {"a.pdb", "", kHash};
    return least;
  }());
  const SessionDocument u = unusual();
  EXPECT_NE(u.settings.display, s.settings.display);
  EXPECT_NE(u.settings.request, s.settings.request);
}

TEST(SessionFile, IsWrittenAndReadThroughTheDisk) {
  TemporaryFile file("S.json", "");
  write_session(unusual(), file.path());
  expect_same(read_session(file.path()).session, unusual());
  EXPECT_THROW(write_session(unusual(), "/no folder/S.json"), std::runtime_error);
}

// Alpha is a JSON number if a double has exactly its value. Otherwise it is a string, because JSON
// readers turn numbers into doubles.
TEST(SessionFile, AlphaKeepsItsDigits) {
  SessionDocument document = unusual();
  for (const char* text :
       {"1.4", "-0.74949975", "1.250001500000249999", "-1000000000000000.000001"}) {
    Alpha alpha;
    ASSERT_EQ(Alpha::read(text, alpha), Alpha::Reading::ok);
    document.settings.request.alpha_angstrom2 = alpha;
    TemporaryFile file("S.json", "");
    write_session(document, file.path());
    EXPECT_EQ(read_session(file.path()).session.settings.request.alpha_angstrom2, alpha) << text;
  }
  const auto read = [](const std::string& value) {
    return parse_session("S.json", with(",\"request\": { \"alpha_angstrom2\": " + value + " }"))
        .session.settings.request.alpha_angstrom2;
  };
  EXPECT_EQ(read("1.4"), read("\"1.4\""));
  EXPECT_LT(read("\"1.399999999999999999\""), read("1.4"));
}

TEST(SessionFile, AWrongValueIsToldWithItsLine) {
  const auto expect = [](const std::string& more, const std::string& line, const char* what) {
    const std::string told = fault(with(more));
    EXPECT_NE(told.find("S.json, line " + line + ": "), std::string::npos) << more << told;
    EXPECT_NE(told.find(what), std::string::npos) << more << told;
    EXPECT_NE(told.find("Write such a value"), std::string::npos) << told;
  };
  expect(",\n\"request\": {\n\"alpha_angstrom2\":\n \"soon\" }", "5",
         "\"request.alpha_angstrom2\" is \"soon\", and must be a number from");
  expect(",\n\"request\": {\n\"alpha_angstrom2\":\n \"0.1234567890123456789\" }", "5",
         "with at most 18 digits behind the point");
  expect(",\n\n\"display\": { \"ball_scale\": 7 }", "4",
         "is 7, and must be a number from 0.05 to 1");
  expect(",\"display\": { \"ball_colour\": \"green\" }", "2", "Write element, chain");
  expect(",\"display\": { \"balls\": 1 }", "2", "must be true or false");
  expect(",\"display\": [ ]", "2", "is a list, and must be an object");
  expect(",\"request\": { \"threads\": 1.5 }", "2", "a whole number");
  expect(",\"open\": { \"model\": 0 }", "2", "a whole number from 1");
  expect(",\"open\": { \"chains\": [\"A\",\n{}] }", "3", "\"open.chains.1\"");
  expect(",\"open\": { \"chains\": \"A\" }", "2", "a list, in square brackets, of at most");
  expect(",\"open\": { \"radius_edits\": {} }", "2", "a list, in square brackets, of at most");
  expect(",\"camera\": { \"target_angstrom\": [1, 2, 3,\n4] }", "2", "brackets, of at most 3");
  expect(",\"open\": { \"selection\": \"a\\u0000b\" }", "2", "must be text");
  expect(",\"open\": { \"radii\": \"user\" }", "2", "no \"radii_table\"");
  expect(",\"open\": { \"radius_edits\": [{\"radius_angstrom\": 99}] }", "2", "from 0.001 to 60");
  expect(",\"open\": { \"radius_edits\": [{\"element\": \"Zz\", \"radius_angstrom\": 9}] }", "2",
         "symbol of an element");
  expect(",\"selection\": [[1], [-1]]", "2", "\"selection.1\" is -1");
  expect(",\"selection\": [[1, 1]]", "2", "all different");
  expect(",\"selection\": [[1, 2, 3, 4, 5]]", "2", "one to four atoms");
  expect(",\"annotations\": { \"measurements\": [{ \"atoms\": [1] }] }", "2", "two to four atoms");
  expect(",\"annotations\": { \"measurements\": [{}] }", "2", "two to four atoms");
  expect(",\"annotations\": { \"measurements\": [{ \"atoms\": [1,\n-1] }] }", "3",
         "\"annotations.measurements.0.atoms.1\" is -1");
  expect(",\"annotations\": { \"labels\": [{ \"text\": \"mass\" }] }", "2", "\"residue\"");
  expect(",\"annotations\": { \"marks\": [{ \"to_angstrom\": [1, 2,\n2e9] }] }", "3",
         "from -1000000000 to 1000000000 Å");
  expect(",\"camera\": { \"position_angstrom\": [1, 2] }", "2", "three numbers");
  expect(",\"camera\": { \"position_angstrom\": [0, 1, 0] }", "2",
         "not parallel to its direction of view");
  expect(",\"panels\": { \"alpha_slider\": { \"low_angstrom2\": 99 } }", "2", "below its high end");
  expect(",\"picture\": { \"width\": 7 }", "2", "\"picture.width\" is 7");
  expect(",\"recording\": { \"content\": { \"kind\": \"film\" } }", "2", "\"turntable\"");
  expect(",\"radii_table\": { \"path\": \"r\", \"sha256\": \"1\" }", "2", "64 digits");
}

TEST(SessionFile, ManyFaultsAreCountedAndTheFirstLineIsTold) {
  const std::string told =
      fault(with(",\n\"display\": { \"balls\": 1 },\n\"request\": { \"threads\": -1 }"));
  EXPECT_NE(told.find("line 3: \"display.balls\""), std::string::npos) << told;
  EXPECT_NE(told.find("; 1 more of its values are invalid"), std::string::npos) << told;
}

TEST(SessionFile, WhatIsUnknownIsToldAndLeftOut) {
  const ReadSession read = parse_session(
      "S.json", with(",\n\"display\": { \"glow\": 1, \"balls\": false },\n\"x\": {}"));
  EXPECT_FALSE(read.session.settings.display.balls);
  ASSERT_EQ(read.notes.size(), 2u);
  EXPECT_NE(read.notes[0].find("Line 3"), std::string::npos) << read.notes[0];
  EXPECT_NE(read.notes[0].find("\"display.glow\""), std::string::npos) << read.notes[0];
  EXPECT_NE(read.notes[1].find("Line 4"), std::string::npos) << read.notes[1];
}

TEST(SessionFile, FormerNamesAreReadAndTold) {
  const ReadSession read = parse_session(
      "S.json",
      with(",\n\"display\": {\n\"silhouettes_pixels\": 3.5, \"face_edges_pixels\": 0.5 }"));
  EXPECT_EQ(read.session.settings.display.outlines, 3.5f);
  EXPECT_EQ(read.session.settings.display.face_lines, 0.5f);
  ASSERT_EQ(read.notes.size(), 2u);
  EXPECT_EQ(read.notes[0],
            "Line 4: \"display.silhouettes_pixels\" is called \"outlines_pixels\" now. The older "
            "name is still read in this version.");
  const std::string told = fault(with(",\n\"display\": {\n\"silhouettes_pixels\": 9 }"));
  EXPECT_NE(told.find("line 4: \"display.silhouettes_pixels\" is 9, and must be a number from 0 to "
                      "4 pixels"),
            std::string::npos)
      << told;
  // Beside the present name the former one is unknown.
  const ReadSession both = parse_session(
      "S.json", with(",\n\"display\": { \"outlines_pixels\": 1, \"silhouettes_pixels\": 3.5 }"));
  EXPECT_EQ(both.session.settings.display.outlines, 1);
  ASSERT_EQ(both.notes.size(), 1u);
  EXPECT_NE(both.notes[0].find("does not know \"display.silhouettes_pixels\""), std::string::npos);
}

TEST(SessionFile, FormerNamesOfObjectsListsAndSchemesAreReadAndTold) {
  const ReadSession read = parse_session(
      "S.json", with(",\n\"compute\": { \"threads\": 3 },\n\"open\": { \"treat\": "
                     "[\"PU8=ligand\"] },\n\"cavity_table\": { \"split_networks\": true },\n"
                     "\"display\": { \"ball_colour\": \"residue_kind\" }"));
  const Settings& s = read.session.settings;
  EXPECT_EQ(s.request.threads, 3);
  EXPECT_EQ(s.open.balls.treated, std::vector<std::string>{"PU8=ligand"});
  EXPECT_TRUE(s.cavity_settings.split_networks);
  EXPECT_EQ(s.display.ball_paint, (Paint{.by = ColourBy::residue_class}));
  std::vector<std::string> notes = read.notes;
  std::sort(notes.begin(), notes.end());
  const std::string still = " now. The older name is still read in this version.";
  EXPECT_EQ(notes, (std::vector<std::string>{
                       "Line 3: \"compute\" is called \"request\"" + still,
                       "Line 4: \"open.treat\" is called \"treatments\"" + still,
                       "Line 5: \"cavity_table\" is called \"cavity_settings\"" + still,
                       "Line 6: \"display.ball_colour\": \"residue_kind\" is called "
                       "\"residue_class\"" +
                           still}));
  const std::string told = fault(with(",\n\"compute\": { \"threads\": -1 }"));
  EXPECT_NE(told.find("line 3: \"compute.threads\" is -1"), std::string::npos) << told;
  const std::string wrong = fault(with(",\n\"open\": {\n\"treat\": [\"PU8=metal\"] }"));
  EXPECT_NE(wrong.find("line 4: \"open.treat.0\" cannot be understood"), std::string::npos)
      << wrong;
}

TEST(SessionFile, WhatIsNoSessionIsToldSo) {
  const auto expect = [](const std::string& text, const char* what) {
    const std::string told = fault(text);
    EXPECT_NE(told.find(what), std::string::npos) << text.substr(0, 100) << "\n" << told;
  };
  expect("", "line 1: this is not a session");
  expect("{\n\"a\": NaN }", "line 2: this is not a session");
  expect("{\n\"a\":\n1e999 }", "line 3: this is not a session");
  expect("[1]", "the JSON file has another content");
  expect("{}", "it has no \"alphascope_session\"");
  expect("{\"alphascope_session\": 2}", "newer version");
  expect("{\"alphascope_session\": \"1\"}", "version of this session is unknown");
  expect("{\"alphascope_session\": 1}", "\"molecule\"");
  expect(std::string(5000000, '['), "are nested here");
  expect("{\"a\":" + std::string(30000, '{'), "are nested here");
  expect("ATOM      1  N   THR A   1", "this is not a session");
}

TEST(SessionFile, AHugeFileIsRefusedUnread) {
  TemporaryFile file("S.json", with("") + std::string(9 << 20, '\n'));
  EXPECT_THROW(read_session(file.path()), ReadError);
}

// Texts are cut, changed and spliced. The result is a message, or a session with values within
// bounds.
TEST(SessionFile, NoMutationCrashesTheReader) {
  const std::string text = session_text(unusual());
  const char* const kPieces[] = {"{",       "}",   "[",     "]",    "\"",
                                 ",",       ":",   "1e308", "-1",   "null",
                                 "\\u0000", "NaN", "true",  "\xff", "99999999999999999999",
                                 "\n"};
  std::mt19937 random(15);
  const auto below = [&random](std::size_t n) { return random() % n; };
  std::size_t sessions = 0;
  for (int round = 0; round < 6000; ++round) {
    std::string changed = text;
    for (std::size_t change = 0; change <= below(3); ++change) {
      const std::size_t at = below(changed.size());
      switch (below(4)) {
        case 0:
          changed.resize(at + 1);
          break;
        case 1:
          changed[at] = static_cast<char>(random());
          break;
        case 2:
          changed.erase(at, below(20));
          break;
        default:
          changed.insert(at, kPieces[below(std::size(kPieces))]);
      }
    }
    try {
      const SessionDocument s = parse_session("S.json", changed).session;
      ++sessions;
      ASSERT_TRUE(std::isfinite(s.settings.request.alpha_angstrom2));
      ASSERT_LE(s.settings.display.ball_scale, 1);
      ASSERT_FALSE(session_text(s).empty());
    } catch (const ReadError& error) {
      ASSERT_NE(std::string(error.what()).find("S.json"), std::string::npos);
    }
  }
  EXPECT_GT(sessions, 100u);  // changed digits still give sessions
}

// --- files that a session names

class FileReferenceTest : public ::testing::Test {
 protected:
  FileReferenceTest() { fs::create_directories(folder_ / "below"); }
  ~FileReferenceTest() override { fs::remove_all(folder_); }
  fs::path write(const fs::path& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  fs::path folder_ = fs::temp_directory_path() / ("alphascope_refs_" + std::to_string(getpid()));
};

TEST_F(FileReferenceTest, BelowTheFolderIsRelativeElseNot) {
  EXPECT_EQ(refer_to("/a/b/m.pdb", kHash, "/a").relative, "b/m.pdb");
  EXPECT_EQ(refer_to("/a/m.pdb", kHash, "/a/").relative, "m.pdb");
  EXPECT_EQ(refer_to("/b/m.pdb", kHash, "/a").relative, "");
  EXPECT_EQ(refer_to("/b/m.pdb", kHash, "/a").absolute, "/b/m.pdb");
  EXPECT_TRUE(refer_to("m.pdb", kHash, ".").absolute.is_absolute());
}

TEST_F(FileReferenceTest, FoundByContentWhereverBothWent) {
  const fs::path file = write("below/m.pdb", "one");
  const FileReference wanted = refer_to(file, hash_of_file(file), folder_);
  EXPECT_EQ(find_file(wanted, folder_).state, FoundFile::State::same);
  // The folder with both files has moved, so the relative path finds the molecule.
  const fs::path elsewhere = folder_ / "elsewhere";
  fs::create_directories(elsewhere / "below");
  fs::rename(file, elsewhere / "below/m.pdb");
  const FoundFile moved = find_file(wanted, elsewhere);
  EXPECT_EQ(moved.state, FoundFile::State::same);
  EXPECT_EQ(moved.path, elsewhere / "below/m.pdb");
  // Only the session has moved, so the absolute path finds it, even if another file has that name.
  write("below/m.pdb", "one");
  write("elsewhere/below/m.pdb", "two");
  EXPECT_EQ(find_file(wanted, elsewhere).path, file);
}

TEST_F(FileReferenceTest, ChangedOrMissingIsSaid) {
  const fs::path file = write("m.pdb", "one");
  const FileReference wanted = refer_to(file, hash_of_file(file), folder_);
  write("m.pdb", "two");
  const FoundFile changed = find_file(wanted, folder_);
  EXPECT_EQ(changed.state, FoundFile::State::changed);
  EXPECT_EQ(changed.path, file);
  EXPECT_NE(why_not_found(wanted, changed).find(wanted.sha256.substr(0, 12)), std::string::npos);
  fs::remove(file);
  const FoundFile missing = find_file(wanted, folder_);
  EXPECT_EQ(missing.state, FoundFile::State::missing);
  EXPECT_NE(why_not_found(wanted, missing).find(file.string()), std::string::npos);
  fs::create_directories(file);
  EXPECT_THROW(find_file(wanted, folder_), ReadError);
}

TEST(SessionFile, ANameThatIsThereTwiceIsRefusedWithItsLine) {
  const std::string head =
      "{\n\"alphascope_session\": 1,\n\"molecule\": {\"absolute_path\": "
      "\"/a\", \"sha256\": \"" +
      kHash + "\"},\n";
  const struct {
    std::string rest, place;
    std::size_t line;
  } cases[] = {{"\"request\": {\n\"alpha_angstrom2\": 1.4,\n\"alpha_angstrom2\": 9}}",
                "\"request.alpha_angstrom2\"", 6},
               {"\"light_theme\": true,\n\"light_theme\": true}", "\"light_theme\"", 5},
               {"\"appearance\": {\"colours\": [{},\n{\"atoms\": [],\n\"atoms\": []}]}}",
                "\"appearance.colours.1.atoms\"", 6},
               {"\"nobody\": {\"a\": {\"b\": 1,\n\"b\": 2}}}", "\"nobody.a.b\"", 5}};
  for (const auto& c : cases) {
    try {
      parse_session("s.json", head + c.rest);
      ADD_FAILURE() << c.rest;
    } catch (const ReadError& error) {
      EXPECT_EQ(error.reason(), c.place + " occurs twice");
      EXPECT_EQ(error.line(), c.line) << error.what();
    }
  }
}

TEST(SessionFile, ASelectionThatCannotBeUnderstoodIsRefusedWithItsPlace) {
  const std::string text =
      "{\"alphascope_session\": 1,\n\"molecule\": {\"absolute_path\": "
      "\"/a\", \"sha256\": \"" +
      kHash + "\"},\n\"open\": {\n\"selection\": \"chain A and (\"}}";
  try {
    parse_session("s.json", text);
    ADD_FAILURE();
  } catch (const ReadError& error) {
    EXPECT_EQ(error.line(), 4u);
    EXPECT_TRUE(error.reason().starts_with("\"open.selection\" cannot be understood, column "))
        << error.what();
  }
}

TEST(SessionFile, AWrongTreatmentIsRefusedWithItsPlace) {
  const auto reason = [](const std::string& treatment, std::size_t line) {
    const std::string text =
        "{\"alphascope_session\": 1,\n\"molecule\": {\"absolute_path\": \"/a\", \"sha256\": \"" +
        kHash + "\"},\n\"open\": {\n\"treatments\": [\"PU8=ligand\",\n\"" + treatment + "\"]}}";
    try {
      parse_session("s.json", text);
    } catch (const ReadError& error) {
      EXPECT_EQ(error.line(), line) << error.what();
      EXPECT_NE(error.remedy().find("remove it"), std::string::npos);
      return error.reason();
    }
    return std::string("none");
  };
  EXPECT_EQ(
      reason("A:QIG 1=metal", 5),
      "\"open.treatments.1\" cannot be understood: \"A:QIG 1=metal\" does not say what residues "
      "are; write them as \"A:PU8 301=ligand\" or \"PU8=ligand\", with polymer, ligand, ion, "
      "water or dummy");
  EXPECT_TRUE(reason("resi (=ion", 5)
                  .starts_with("\"open.treatments.1\" cannot be understood: \"resi (\" names no "
                               "residues, column 6: "));
  EXPECT_EQ(reason("A:QIG 1=ion", 5), "none");
}

}  // namespace
}  // namespace alphascope

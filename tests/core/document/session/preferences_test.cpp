// SPDX-License-Identifier: GPL-3.0-or-later
// Tests preferences: kept between windows, shared by two windows, and never a reason not to start.
#include "core/document/session/preferences.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

class PreferencesTest : public ::testing::Test {
 protected:
  PreferencesTest() { fs::remove_all(folder_); }
  ~PreferencesTest() override {
    std::error_code ignored;
    fs::permissions(folder_, fs::perms::owner_all, ignored);
    fs::remove_all(folder_);
  }
  void write(const std::string& text) const {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "preferences.json") << text;
  }
  std::string text() const {
    std::ostringstream all;
    all << std::ifstream(folder_ / "preferences.json").rdbuf();
    return all.str();
  }
  Preferences read() const {
    const ReadPreferences found = read_preferences(folder_);
    EXPECT_EQ(found.problem, "");
    return found.preferences;
  }
  fs::path folder_ = fs::temp_directory_path() / ("alphascope_prefs_" + std::to_string(getpid()));
};

Preferences unusual() {
  return {true, 1.75, 1000, 700, EngineChoice::cpu, "/data", {"/data/a.pdb", "/data/b.json"}, true};
}

TEST_F(PreferencesTest, ComeBack) {
  EXPECT_EQ(read(), Preferences());
  save_preferences(folder_, {}, unusual());
  EXPECT_EQ(read(), unusual());
  Preferences other = unusual();
  other.light_theme = false;
  other.recent.clear();
  save_preferences(folder_, unusual(), other);
  EXPECT_EQ(read(), other);
}

TEST_F(PreferencesTest, TwoWindowsKeepEachOthersChanges) {
  save_preferences(folder_, {}, unusual());
  Preferences first = unusual(), second = unusual();
  first.scale = 2;
  note_recent(first, "/data/first.pdb");
  second.engine = EngineChoice::cgal;
  note_recent(second, "/data/b.json");
  save_preferences(folder_, unusual(), first);
  save_preferences(folder_, unusual(), second);
  const Preferences both = read();
  EXPECT_EQ(both.scale, 2);
  EXPECT_EQ(both.engine, EngineChoice::cgal);
  EXPECT_EQ(both.recent, (std::vector<fs::path>{"/data/b.json", "/data/first.pdb", "/data/a.pdb"}));
}

TEST_F(PreferencesTest, TwoWindowsAtOnceNeverTearTheFile) {
  const auto window = [this](int width) {
    Preferences before, now;
    for (int i = 0; i < 100; ++i) {
      now.width = width + i;
      save_preferences(folder_, before, now);
      before = now;
    }
  };
  std::thread first(window, 1000), second(window, 2000);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(read_preferences(folder_).problem, "");
  first.join();
  second.join();
  const int width = read().width;
  EXPECT_TRUE(width == 1099 || width == 2099) << width;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "a temporary file is left";
}

TEST_F(PreferencesTest, WhatANewerProgramWroteStays) {
  write("{\"alphascope_preferences\": 1, \"colour\": {\"of\": [1, \"x\"]}, \"scale\": 1.5}");
  Preferences now = read();
  EXPECT_EQ(now.scale, 1.5);
  const Preferences before = now;
  now.light_theme = true;
  save_preferences(folder_, before, now);
  EXPECT_EQ(read(), now);
  EXPECT_NE(text().find("\"colour\""), std::string::npos) << text();
}

TEST_F(PreferencesTest, AWrongValueIsToldAndTheOthersAreUsed) {
  write("{\"alphascope_preferences\": 1,\n\"scale\": 99,\n\"light_theme\": true}");
  const ReadPreferences found = read_preferences(folder_);
  EXPECT_NE(found.problem.find("line 2: \"scale\" is 99"), std::string::npos) << found.problem;
  EXPECT_TRUE(found.preferences.light_theme);
  EXPECT_EQ(found.preferences.scale, 0);
  EXPECT_FALSE(found.keep_file);
}

TEST_F(PreferencesTest, ADamagedFileIsToldAndStays) {
  for (const char* const damaged :
       {"", "{", "{}", "[[[[", "\xff\xff", "{\"alphascope_session\": 1}"}) {
    write(damaged);
    const ReadPreferences found = read_preferences(folder_);
    EXPECT_NE(found.problem.find("preferences.json"), std::string::npos) << damaged;
    EXPECT_TRUE(found.keep_file);
    EXPECT_EQ(found.preferences, Preferences());
    EXPECT_THROW(save_preferences(folder_, {}, unusual()), std::runtime_error);
    EXPECT_EQ(text(), damaged);
  }
}

TEST_F(PreferencesTest, AFolderThatCannotBeIsAnErrorThatNamesIt) {
  write("");
  const fs::path inside_a_file = folder_ / "preferences.json" / "alphascope";
  EXPECT_NE(read_preferences(inside_a_file).problem.size() + 1, 0u);  // no exception
  try {
    save_preferences(inside_a_file, {}, unusual());
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(inside_a_file.string()), std::string::npos);
  }
}

TEST_F(PreferencesTest, AReadOnlyFolderIsAnError) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::create_directories(folder_);
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(save_preferences(folder_, {}, unusual()), std::runtime_error);
}

TEST(PreferencesFolder, FollowsTheEnvironment) {
  const auto value = [](const char* name) {
    const char* const text = std::getenv(name);
    return std::string(text != nullptr ? text : "");
  };
  const std::string config = value("XDG_CONFIG_HOME"), home = value("HOME");
  setenv("XDG_CONFIG_HOME", "/tmp/config", 1);
  EXPECT_EQ(preferences_folder(), "/tmp/config/alphascope");
  setenv("XDG_CONFIG_HOME", "relative", 1);
  setenv("HOME", "/home/a", 1);
  EXPECT_EQ(preferences_folder(), "/home/a/.config/alphascope");
  unsetenv("XDG_CONFIG_HOME");
  EXPECT_EQ(preferences_folder(), "/home/a/.config/alphascope");
  unsetenv("HOME");
  EXPECT_EQ(preferences_folder(), "");
  setenv("HOME", home.c_str(), 1);
  if (!config.empty()) setenv("XDG_CONFIG_HOME", config.c_str(), 1);
}

TEST(RecentFiles, TheLatestIsFirstOnceAndTheListEnds) {
  Preferences p;
  for (int i = 0; i < 20; ++i) note_recent(p, "/d/" + std::to_string(i));
  EXPECT_EQ(p.recent.size(), kMostRecentFiles);
  EXPECT_EQ(p.recent.front(), "/d/19");
  note_recent(p, "/d/15");
  note_recent(p, "/d/./x/../15");
  EXPECT_EQ(p.recent.front(), "/d/15");
  EXPECT_EQ(std::count(p.recent.begin(), p.recent.end(), fs::path("/d/15")), 1);
}

}  // namespace
}  // namespace alphascope

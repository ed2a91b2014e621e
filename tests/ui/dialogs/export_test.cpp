// SPDX-License-Identifier: GPL-3.0-or-later
// Tests exports from the window: the same files as from the command line, of the complex on screen.
#include <cstdlib>

#include "tests/ui/viewer_fixture.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

class ExportFromTheWindow : public testing::ViewerTest {
 protected:
  // Returns the lines of the file, except those that name program and engine.
  std::string lines_of(const std::string& name) {
    std::istringstream lines(bytes(name));
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
      const bool differs = line.starts_with("# program") || line.starts_with("# engine") ||
                           line.starts_with("# note");
      if (!differs) kept += line + "\n";
    }
    return kept;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
};

TEST_F(ExportFromTheWindow, ACommandWritesWhatTheCommandLineDoes) {
  open_crambin();
  run("alpha.set 1.4\nwait-idle\nfile.export \"" + path("window.obj") + "\" chain\nwait-idle\n");
  EXPECT_TRUE(viewer_->state().error.empty()) << viewer_->state().error;
  EXPECT_EQ(
      viewer_->state().notice.text(),
      "Saved " + path("window.obj") +
          ": boundary of 41 solids: 850 triangles, 507 vertices, 503.4 Å³; left out, as they "
          "enclose nothing: 164 singular triangles, 22 edges, 0 vertices; 1 unit of the file is 1 "
          "Å");
  const std::string command = "'" ALPHASCOPE_CLI "' export -q '" + testing::crambin().string() +
                              "' --alpha 1.4 --colours chain -o '" + path("cli.obj") +
                              "' > /dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(lines_of("window.obj"), lines_of("cli.obj"));
  EXPECT_NE(bytes("window.obj").find("# program alphascope "), std::string::npos);
}

TEST_F(ExportFromTheWindow, TheDialogsFormatIsTheEnding) {
  open_crambin();
  viewer_->state().dialogs.export_path = path("figure.glb");
  run("key ctrl+e\nframes 3\nclick export.format\nframes 3\nclick export.pml\nframes 3\n");
  EXPECT_EQ(viewer_->state().dialogs.export_path, path("figure.pml"));
  run("click export.ok\nwait-idle\n");
  EXPECT_FALSE(viewer_->state().dialogs.show_export);
  for (const char* name : {"figure.pml", "figure-balls.pqr", "figure-boundary.obj"}) {
    EXPECT_GT(bytes(name).size(), 1000u) << name;
  }
  run("key ctrl+e\nframes 3\n");
  EXPECT_TRUE(viewer_->widgets().contains("export.replaces"));
  viewer_->state().dialogs.export_path = path("figure.docx");
  run("frames 3\n");
  EXPECT_TRUE(viewer_->widgets().contains("export.no_format"));
  run("click export.ok\nframes 3\n");
  EXPECT_TRUE(viewer_->state().dialogs.show_export);
  run("click export.cancel\nframes 3\n");
  EXPECT_FALSE(viewer_->state().dialogs.show_export);
}

TEST_F(ExportFromTheWindow, WhatCannotBeWrittenIsTold) {
  open_crambin();
  run("file.export /no/such/folder/x.stl\nwait-idle\n");
  EXPECT_NE(viewer_->state().error.find("/no/such/folder/x.stl"), std::string::npos)
      << viewer_->state().error;
  viewer_->state().error.clear();
  run("file.export \"" + path("own.pqr") + "\"\nwait-idle\n");
  const std::string before = bytes("own.pqr");
  run("open " + path("own.pqr") + "\nwait-idle\nfile.export \"" + path("own.pqr") +
      "\"\nwait-idle\n");
  EXPECT_NE(viewer_->state().error.find("which is read. Give the output another name."),
            std::string::npos)
      << viewer_->state().error;
  EXPECT_EQ(bytes("own.pqr"), before);
}

TEST_F(ExportFromTheWindow, CancelLeavesNoFile) {
  open_crambin();
  viewer_->calls().jobs.export_complex(ExportRequest{folder_ / "c.vtu", ExportColours::element});
  viewer_->calls().jobs.cancel(JobId::complex);  // in the same frame, before the worker is done
  run("wait-idle\n");
  const bool written = fs::exists(folder_ / "c.vtu");
  const std::string& notice = viewer_->state().notice.text();
  EXPECT_NE(notice.find(written ? "Saved" : "was not written"), std::string::npos) << notice;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    EXPECT_NE(entry.path().extension(), ".tmp");
  }
}

}  // namespace
}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// Tests pictures that go to the clipboard, with a stand-in for the desktop's program.
#include <sys/stat.h>

#include <cstdlib>
#include <optional>

#include "app/viewer/saving/picture_clipboard.hpp"
#include "core/run/cancel_token.hpp"
#include "tests/ui/viewer_fixture.hpp"

namespace alphascope::testing {
namespace {

// Sets a variable of the environment, or removes it, for as long as it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* const old = std::getenv(name)) old_ = old;
    if (value == nullptr) {
      unsetenv(name);
    } else {
      setenv(name, value, 1);
    }
  }
  ~Variable() {
    if (old_) {
      setenv(name_, old_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

class CopyPicture : public ViewerTest {
 protected:
  // A program that writes its arguments and its input into files.
  void install(const std::string& name, int status) {
    const fs::path program = folder_ / name;
    std::ofstream(program) << "#!/bin/sh\necho \"$0 $*\" > '" << (folder_ / "arguments").string()
                           << "'\n/bin/cat > '" << (folder_ / "copied.png").string()
                           << "'\necho refused >&2\nexit " << status << "\n";
    chmod(program.c_str(), 0755);
  }
  std::string message() {
    try {
      picture_clipboard();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(CopyPicture, NamesTheMissingPackage) {
  const Variable path("PATH", folder_.c_str());
  {
    const Variable x("DISPLAY", ":7"), wayland("WAYLAND_DISPLAY", nullptr);
    EXPECT_NE(message().find("Install the package xclip"), std::string::npos) << message();
  }
  {
    const Variable x("DISPLAY", ":7"), wayland("WAYLAND_DISPLAY", "wayland-0");
    EXPECT_NE(message().find("Install the package wl-clipboard"), std::string::npos) << message();
    install("xclip", 0);
    EXPECT_EQ(picture_clipboard().program.filename(), "xclip") << "better than none";
    install("wl-copy", 0);
    EXPECT_EQ(picture_clipboard().program.filename(), "wl-copy");
  }
  const Variable x("DISPLAY", nullptr), wayland("WAYLAND_DISPLAY", nullptr);
  EXPECT_NE(message().find("no display"), std::string::npos) << message();
}

TEST_F(CopyPicture, ThePictureArrivesAsPng) {
  open_crambin();
  viewer_->state().window.picture.width = 400;
  viewer_->state().window.picture.height = 300;
  install("xclip", 0);
  const Variable path("PATH", folder_.c_str()), x("DISPLAY", ":7"),
      wayland("WAYLAND_DISPLAY", nullptr);
  run("file.copy_picture\nwait-idle\n");
  EXPECT_EQ(viewer_->state().notice.text(), "Copied the picture");
  EXPECT_NE(bytes("arguments").find("-selection clipboard -t image/png"), std::string::npos);
  run("file.save_picture " + (folder_ / "saved.png").string() + "\nwait-idle\n");
  const std::string copied = bytes("copied.png");
  EXPECT_TRUE(copied.starts_with("\x89PNG"));
  EXPECT_EQ(copied, bytes("saved.png"));
}

TEST_F(CopyPicture, AProgramThatRefusesIsNamed) {
  open_crambin();
  install("xclip", 1);
  const Variable path("PATH", folder_.c_str()), x("DISPLAY", ":7"),
      wayland("WAYLAND_DISPLAY", nullptr);
  run("file.copy_picture\nwait-idle\n");
  EXPECT_EQ(viewer_->state().error_title, "The picture cannot be copied");
  EXPECT_NE(viewer_->state().error.find("xclip says: refused"), std::string::npos)
      << viewer_->state().error;
}

}  // namespace
}  // namespace alphascope::testing

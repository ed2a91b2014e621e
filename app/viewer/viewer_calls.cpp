// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of panels and commands (ui/calls.hpp), queued while a frame is drawn.
#include <imgui.h>

#include <array>
#include <utility>

#include "app/viewer/parts/call_queue.hpp"
#include "app/viewer/viewer.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {

class Viewer::Queued {
 public:
  explicit Queued(Viewer& viewer)
      : files(viewer, queue), view(viewer, queue), jobs(viewer, queue), lessons(viewer, queue) {}

  CallQueue queue;

 private:
  struct Part {
    Part(Viewer& viewer, CallQueue& calls) : v(viewer), queue(calls) {}
    Viewer& v;
    CallQueue& queue;
  };

 public:
  struct Files : Part, FileCalls {
    using Part::Part;
    void open(const std::filesystem::path& file) override {
      queue.put("open", [this, file] { v.file_.opening().open(file); });
    }
    void open_session(const std::filesystem::path& file) override {
      queue.put("open_session", [this, file] { v.file_.opening().open_session(file); });
    }
    void close_file() override {
      queue.put("close_file", [this] { v.close_file(); });
    }
    void save_session(const std::filesystem::path& file) override {
      queue.put("save_session", [this, file] {
        v.scene_.cameras().end_glide();
        v.scene_.cameras().settle(v.state_.viewport);
        v.file_.opening().save(file);
      });
    }
    void fetch(const MoleculeId& id, bool again) override {
      queue.put("fetch", [this, id, again] { v.file_.opening().fetch(id, again); });
    }
    void fetch_for_session() override {
      queue.put("fetch_for_session", [this] { v.file_.opening().fetch_for_session(); });
    }
    void continue_session(const std::filesystem::path& molecule) override {
      queue.put("continue_session", [this, molecule] { v.file_.opening().go_on(molecule); });
    }
    void abandon_session() override {
      queue.put("abandon_session", [this] { v.file_.opening().forget_waiting_session(); });
    }
    void forget_recent() override {
      queue.put("forget_recent", [this] { v.preferences_.forget_recent(); });
    }
    void undo() override {
      queue.put("undo", [this] { v.history_.undo(); });
    }
    void redo() override {
      queue.put("redo", [this] { v.history_.redo(); });
    }
    void copy(const std::string& text) override {
      queue.put("copy", [text] { ImGui::SetClipboardText(text.c_str()); });
    }
    void quit() override {
      queue.put("quit", [this] { quit_requested = true; });
    }
    bool quit_requested = false;
  };

  struct View : Part, ViewCalls {
    using Part::Part;
    void reset() override {
      queue.put("reset", [this] {
        v.history_.move_view([this] {
          v.scene_.cameras().reset();
          v.scene_.cameras().settle(v.state_.viewport);
        });
      });
    }
    void zoom(double factor) override {
      move("zoom", [this, factor] { v.scene_.cameras().zoom(factor); });
    }
    void look_from(const std::array<double, 3>& side) override {
      move("look_from", [this, side] { v.scene_.cameras().look_from(side); });
    }
    void look_across(const RealPoint& line) override {
      move("look_across", [this, line] { v.scene_.cameras().look_across(line); });
    }
    void zoom_to_selection() override {
      move("zoom_to_selection", [this] { v.marks_.zoom_to(v.state_.settings.selection.items); });
    }
    void zoom_to(const RefSet& items) override {
      move("zoom_to", [this, items] { v.marks_.zoom_to(items); });
    }
    void centre_on(const RefSet& items) override {
      move("centre_on", [this, items] { v.marks_.centre_on(items); });
    }
    void save(const std::string& name) override {
      move("save_view", [this, name] { v.marks_.save_view(name); });
    }
    void go_to(const std::string& name) override {
      move("go_to", [this, name] { v.marks_.go_to_view(name); });
    }
    void back() override {
      queue.put("view_back", [this] { v.history_.earlier_view(); });
    }
    void forward() override {
      queue.put("view_forward", [this] { v.history_.later_view(); });
    }
    void open_context_menu() override {
      queue.put("open_context_menu", [this] {
        v.pointing_.open_context_menu();
        v.pace_.due().ask();
      });
    }

   private:
    // Starts from the view of this frame. Undo brings the previous view back.
    void move(std::string_view name, std::function<void()> how) {
      queue.put(name, [this, how = std::move(how)] {
        v.scene_.cameras().settle(v.state_.viewport);
        v.history_.move_view(how);
      });
    }
  };

  struct Jobs : Part, JobCalls {
    using Part::Part;
    void save_picture(const ScreenshotRequest& request) override {
      of_the_view("save_picture", [this, request] { v.saving_.save_picture(request); });
    }
    void record(const RecordRequest& request) override {
      of_the_view("record", [this, request] { v.saving_.record(request); });
    }
    void save_table(const SaveTableRequest& request) override {
      queue.put("save_table", [this, request] { v.saving_.save_table(request); });
    }
    void export_complex(const ExportRequest& request) override {
      queue.put("export_complex", [this, request] { v.saving_.export_complex(request); });
    }
    void compare() override {
      queue.put("compare", [this] { v.status_.compare(); });
    }
    void compute_anew() override {
      queue.put("compute_anew", [this] { v.session_.compute_anew(); });
    }
    void run_benchmark() override {
      queue.put("run_benchmark", [this] {
        v.jobs_.benchmark().start(v.session_.state(), v.state_.benchmark_settings);
      });
    }
    void export_benchmark() override {
      queue.put("export_benchmark",
                [this] { v.jobs_.benchmark().save(v.state_.benchmark_settings); });
    }
    void cancel(JobId job) override {
      queue.put(kCancel[static_cast<std::size_t>(job)],
                [this, job] { v.jobs_.list().cancel(job); });
    }
    void cancel_result(const std::string& id) override {
      queue.put("cancel_result", [this, id] { v.store_.cancel(id); });
    }

   private:
    // Names of the calls, so that cancelling one job does not replace cancelling another.
    static constexpr std::array kCancel = {"cancel_fetching",  "cancel_opening", "cancel_computing",
                                           "cancel_comparing", "cancel_listing", "cancel_lessons",
                                           "cancel_session",   "cancel_picture", "cancel_table",
                                           "cancel_export",    "cancel_figures", "cancel_benchmark",
                                           "cancel_deriving"};
    static_assert(kCancel.size() == static_cast<std::size_t>(JobId::deriving) + 1);

    void of_the_view(std::string_view name, std::function<void()> job) {
      queue.put(name, [this, job = std::move(job)] {
        v.scene_.cameras().end_glide();
        v.scene_.cameras().settle(v.state_.viewport);
        job();
      });
    }
  };

  struct Lessons : Part, LessonCalls {
    using Part::Part;
    void open(const std::string& lesson) override {
      queue.put("lesson_open", [this, lesson] { v.lessons_.open(lesson); });
    }
    void next() override {
      queue.put("lesson_next", [this] { v.lessons_.player().next(); });
    }
    void back() override {
      queue.put("lesson_back", [this] { v.lessons_.player().back(); });
    }
    void restart_step() override {
      queue.put("lesson_again", [this] { v.lessons_.player().restart_step(); });
    }
    void reveal() override {
      queue.put("lesson_reveal", [this] { v.lessons_.player().reveal(); });
    }
    void close() override {
      queue.put("lesson_close", [this] { v.lessons_.player().close(); });
    }
  };

  Files files;
  View view;
  Jobs jobs;
  Lessons lessons;
};

std::shared_ptr<Viewer::Queued> Viewer::make_queued() {
  return std::make_shared<Queued>(*this);
}

Calls Viewer::calls() {
  return {queued_->files, queued_->view, queued_->jobs, queued_->lessons};
}

void Viewer::run_calls() {
  history_.begin_calls();
  queued_->queue.run();
}

bool Viewer::quit_requested() const {
  return queued_->files.quit_requested;
}

}  // namespace alphascope

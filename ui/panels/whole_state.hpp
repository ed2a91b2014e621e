// SPDX-License-Identifier: GPL-3.0-or-later
// The object that holds all parts of a ViewState, for the program and for tests. Panels need
// view_state.hpp and the headers of the parts that they use.
#pragma once

#include "core/document/export/program_name.hpp"
#include "core/document/settings/settings.hpp"
#include "core/engine/cold_and_warm.hpp"
#include "core/engine/gpu_device.hpp"
#include "core/selection/selection_error.hpp"
#include "ui/colour_legend.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/channels/channel_state.hpp"
#include "ui/panels/dialogs/benchmark_info.hpp"
#include "ui/panels/dialogs/browser_state.hpp"
#include "ui/panels/dialogs/dialog_state.hpp"
#include "ui/panels/dialogs/fetch_state.hpp"
#include "ui/panels/dialogs/picture_requests.hpp"
#include "ui/panels/dialogs/save_state.hpp"
#include "ui/panels/dialogs/session_problem.hpp"
#include "ui/panels/dialogs/table_state.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/frame/context_state.hpp"
#include "ui/panels/frame/mouse_state.hpp"
#include "ui/panels/frame/palette_state.hpp"
#include "ui/panels/frame/scroll_state.hpp"
#include "ui/panels/frame/start_state.hpp"
#include "ui/panels/frame/task_state.hpp"
#include "ui/panels/guide/guide_state.hpp"
#include "ui/panels/lessons/lesson_state.hpp"
#include "ui/panels/molecule/expression_state.hpp"
#include "ui/panels/molecule/radius_row.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/panels/work_info.hpp"
#include "ui/picture_marks.hpp"
#include "ui/running_job.hpp"
#include "ui/widgets/key_state.hpp"
#include "ui/widgets/number_typing.hpp"

namespace alphascope {

// ViewState describes each part.
struct ViewParts {
  Settings settings;
  WindowSettings window;
  Playback playback;
  LessonState lessons;
  GuideState guide;
  StepsState steps;
  CavityState cavities;
  ChannelState channels;
  SandboxState sandbox;
  MoleculeInfo molecule;
  ColdAndWarm ours, cgal, cgal_parallel;
  BadgeInfo badge;
  BenchmarkSettings benchmark_settings;
  BenchmarkInfo benchmark;
  RunningJobs jobs;
  BackgroundInfo background;
  ViewportInfo viewport;
  std::optional<GpuDevice> gpu;
  ProgramName program;
  ExpressionState expression;
  std::optional<SelectionError> expression_error;
  std::optional<SessionProblem> session_problem;
  PaletteState palette;
  ContextState context;
  DialogState dialogs;
  BrowserState browser;
  FetchState fetch;
  StartState start;
  TaskState tasks;
  SaveState saving;
  RecordState record;
  TableState save_table;
  NumberTyping number;
  KeyState keys;
  MouseState mouse;
  ScrollState scroll;
};

// A base, so that the parts are there before the ViewState that refers to them.
struct HeldParts {
  ViewParts parts;
};

class WholeState : private HeldParts, public ViewState {
 public:
  WholeState() : ViewState({}, parts) {}
  WholeState(const WholeState& other) : HeldParts(other), ViewState(other, parts) {}
  WholeState& operator=(const WholeState& other) {
    parts = other.parts;
    ViewValues::operator=(other);
    return *this;
  }
};

}  // namespace alphascope

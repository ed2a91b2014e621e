// SPDX-License-Identifier: GPL-3.0-or-later
// Plans a drawing by the free memory, and makes its arrays.
#include "app/viewer/scene/drawing_maker.hpp"

#include <new>
#include <utility>
#include <vector>

#include "core/run/freed_on_other_thread.hpp"
#include "ui/scene/display_style.hpp"

namespace alphascope {
namespace {

using Clock = std::chrono::steady_clock;

// Whether the balls of this molecule are on screen.
bool shows_balls(const DrawnMolecule* drawn, const OpenedMolecule& opened) {
  return drawn != nullptr && drawn->prepared == opened.prepared &&
         drawn->geometry->centres.size() == opened.prepared->balls->size();
}

}  // namespace

DrawingMaker::DrawingMaker(std::function<void()> wake, std::chrono::milliseconds finishes,
                           FreeMemory free_memory, MeshMaker make_mesh, Events events)
    : free_memory_(std::move(free_memory)),
      make_mesh_(std::move(make_mesh)),
      events_(std::move(events)),
      worker_(std::move(wake), finishes) {}

void DrawingMaker::make(WantedDrawing wanted) {
  worker_.submit(
      [this, wanted = std::move(wanted)](const RunContext& context) -> Worker::Delivery {
        try {
          return run(wanted, context);
        } catch (const std::bad_alloc&) {
          return [this, opened = wanted.opened] { events_.out_of_memory(opened); };
        }
      },
      [this](const Worker::Failure& failure) {
        if (!failure.cancelled) events_.failed(failure.message);
      });
}

// Returns the free memory. Reading it takes as long as making a small molecule's mesh. So a reading
// is used again for a second, if it is a thousand times the size of the complex. The mesh takes
// only a few times that size.
std::optional<std::uint64_t> DrawingMaker::free_memory_for(const DrawingTask& task) {
  constexpr std::chrono::seconds kServesFor{1};
  constexpr std::uint64_t kBytesABall = 200, kPlenty = 1000;
  const std::uint64_t small =
      task.balls * kBytesABall + (task.complex ? bytes_of(*task.complex) : 0);
  const Clock::time_point now = Clock::now();
  if (!free_read_ || now - free_read_at_ > kServesFor || *free_read_ / kPlenty < small) {
    free_read_ = free_memory_();
    free_read_at_ = now;
  }
  return free_read_;
}

DrawingPlan DrawingMaker::plan(const DrawingTask& task) {
  DrawingPlan plan = plan_drawing(task, free_memory_for(task));
  if (!plan.complete()) {
    wait_until_freed();  // the previous picture's memory
    plan = plan_drawing(task, free_memory_());
  }
  bytes_ = plan.complete() ? plan.wanted_bytes : drawing_budget(plan.free_bytes);
  return plan;
}

Worker::Delivery DrawingMaker::run(const WantedDrawing& wanted, const RunContext& context) {
  const bool known = shows_balls(wanted.drawn.get(), *wanted.opened);
  const DrawingPlan plan =
      this->plan({known ? 0 : wanted.opened->prepared->balls->size(),
                  wanted.answer ? &wanted.answer->complex : nullptr,
                  wanted.agreement ? &wanted.agreement->comparison : nullptr,
                  mesh_options(wanted.controls.display, wanted.controls.theme)});
  if (!plan.complete() && wanted.drawn) return events_.short_of_memory;
  // A pointer, because a delivery is copied and a drawing is large.
  const auto drawing = std::make_shared<Drawing>(draw(wanted, plan, context));
  return [this, drawing] { events_.ready(std::move(*drawing)); };
}

Drawing DrawingMaker::draw(const WantedDrawing& wanted, const DrawingPlan& plan,
                           const RunContext& context) {
  const bool known = shows_balls(wanted.drawn.get(), *wanted.opened);
  const SceneControls& controls = wanted.controls;
  Drawing drawing;
  drawing.not_drawn = not_drawn_text(plan);
  drawing.answer = wanted.answer;
  drawing.molecule = !plan.balls ? make_undrawn(wanted.opened)
                     : known     ? wanted.drawn
                                 : make_drawn(wanted.opened, context);
  const DrawnMolecule& m = *drawing.molecule;
  const auto looks = make_ball_appearance(m, controls.appearance);
  if (plan.balls) {
    // Radii of balls on screen change only with grown balls. Those of a million take milliseconds.
    const bool radii = !known || controls.display.grown_balls;
    drawing.parts = make_parts(
        {drawing.molecule, wanted.answer, controls.display, looks, plan.mesh, controls.clip, radii},
        wanted.paintings, make_mesh_, context);
  } else {
    drawing.parts.looks = looks;
  }
  DrawnParts& parts = drawing.parts;
  if (!known) {
    const std::size_t balls = m.geometry->centres.size();
    drawing.balls = make_ball_data(
        m.geometry, plan.balls ? parts.ball_colours(balls) : std::vector<Rgb8>(), parts.radii);
  }
  const Clock::time_point begun = Clock::now();
  drawing.mesh = make_mesh_data(parts.mesh);
  parts.mesh_milliseconds +=
      std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
  drawing.caps = ready_caps(controls.clip, parts.caps);
  if (plan.differences) {
    parts.differences = std::make_shared<const DifferenceMesh>(
        build_difference_mesh(*m.geometry, wanted.agreement->comparison));
    drawing.differences = make_difference_data(parts.differences);
  }
  return drawing;
}

}  // namespace alphascope

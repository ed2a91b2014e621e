// SPDX-License-Identifier: GPL-3.0-or-later
// Makes drawings of a molecule and its complex on a worker, as far as memory allows.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/session/session.hpp"
#include "app/viewer/scene/clip_caps.hpp"
#include "app/viewer/scene/drawn_molecule.hpp"
#include "app/viewer/scene/panel_layers.hpp"
#include "app/viewer/scene/scene_controls.hpp"
#include "core/run/worker.hpp"
#include "ui/scene/mesh/drawing_memory.hpp"
#include "ui/scene/picture/drawn_parts.hpp"
#include "ui/scene/scene_data.hpp"

namespace alphascope {

// The inputs of a drawing.
struct WantedDrawing {
  std::shared_ptr<const OpenedMolecule> opened;
  std::shared_ptr<const Answer> answer;        // null: balls alone
  std::shared_ptr<const Agreement> agreement;  // null: no differences are drawn
  SceneControls controls;
  // On screen at the start; null: nothing is.
  std::shared_ptr<const DrawnMolecule> drawn;
  Paintings paintings;
};

struct Drawing {
  std::shared_ptr<const DrawnMolecule> molecule;
  std::shared_ptr<const Answer> answer;
  std::shared_ptr<BallData> balls;  // null: the balls are those on screen
  DrawnParts parts;
  std::shared_ptr<MeshData> mesh;
  ReadyCaps caps;
  std::shared_ptr<DifferenceData> differences;
  std::string not_drawn;  // the missing parts and the reason; empty: none
};

class DrawingMaker {
 public:
  // All run on the main thread, inside poll().
  struct Events {
    std::function<void(Drawing)> ready;
    std::function<void()> short_of_memory;  // while a picture takes some of it
    std::function<void(const std::shared_ptr<const OpenedMolecule>&)> out_of_memory;
    std::function<void(const std::string& why)> failed;
  };
  // `wake` and `finishes` as in Worker.
  DrawingMaker(std::function<void()> wake, std::chrono::milliseconds finishes,
               FreeMemory free_memory, MeshMaker make_mesh, Events events);

  void make(WantedDrawing wanted);
  void cancel() { worker_.cancel(); }
  void poll() { worker_.poll(); }
  bool busy() const { return worker_.activity().busy; }
  // Upper bound of the bytes of the last drawing that was begun.
  std::uint64_t bytes() const { return bytes_.load(); }

 private:
  // These run on the worker's thread.
  std::optional<std::uint64_t> free_memory_for(const DrawingTask& task);
  DrawingPlan plan(const DrawingTask& task);
  Worker::Delivery run(const WantedDrawing& wanted, const RunContext& context);
  Drawing draw(const WantedDrawing& wanted, const DrawingPlan& plan, const RunContext& context);

  const FreeMemory free_memory_;
  const MeshMaker make_mesh_;
  const Events events_;
  // Free memory at the last reading, bytes. Only the worker uses these two.
  std::optional<std::uint64_t> free_read_;
  std::chrono::steady_clock::time_point free_read_at_;
  std::atomic<std::uint64_t> bytes_ = 0;
  Worker worker_;  // last member, so that its thread is joined first
};

}  // namespace alphascope

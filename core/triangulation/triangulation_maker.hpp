// SPDX-License-Identifier: GPL-3.0-or-later
// Makes triangulations, and what follows from them, on a device where there is one, else on the
// CPU. Both have the same bytes. Engines, derived results and searches take a maker; null stands
// for the CPU.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "core/complex/triangulation.hpp"
#include "core/run/cancel_token.hpp"
#include "core/triangulation/device_triangulator.hpp"

namespace alphascope {

struct BallSet;

// Any thread may call all functions. Calls that use the device wait for each other.
class TriangulationMaker {
 public:
  // Called at the first triangulation. Returns null if there is no device, and may set `why_not`:
  // why one that is there cannot be used.
  using MakeDevice = std::function<std::unique_ptr<DeviceTriangulator>(std::string& why_not)>;
  explicit TriangulationMaker(MakeDevice make_device) : make_device_(std::move(make_device)) {}

  // `threads` as in make_triangulation(). The result has a report. Throws Cancelled, and
  // std::length_error for more balls or tetrahedra than can be handled.
  Triangulation make(const BallSet& balls, int threads, const RunContext& context);

  // What follows from a triangulation, made on the device. Empty if there is none, if it would take
  // longer there, or if it failed. Throws Cancelled.
  std::optional<FiltrationParts> filtration_parts(const BallSet& balls,
                                                  const Triangulation& triangulation,
                                                  const RunContext& context);
  std::optional<TriangulationGround> ground(const BallSet& balls,
                                            const Triangulation& triangulation, FlowTies ties,
                                            const RunContext& context);

  // Membership at one alpha, made on the device. Empty unless the device made the last ground with
  // these incidences, and still has it. Throws Cancelled.
  std::optional<Membership> membership(const Incidence& incidence,
                                       const LatticeAlpha& alpha_on_lattice,
                                       const CancelToken& cancel);

  // As DeviceTriangulator::outside_parts(). Throws Cancelled.
  std::optional<ResultArray<OutsidePart>> outside_parts(const Membership& in,
                                                        std::span<const std::uint32_t> tetrahedra,
                                                        double solvent_on_lattice,
                                                        const CancelToken& cancel);

  // Returns once nothing is being made on the device, or after `most`. Other work on the device may
  // call it before it begins: two computations take longer at once than one after the other.
  // Throws Cancelled.
  void wait_until_idle(std::chrono::milliseconds most, const CancelToken& cancel);

  // Frees the device's memory that is kept for the next triangulation. Returns whether there was
  // any. Engines call it when they are short of memory.
  bool release_memory();

 private:
  DeviceTriangulation make_on_device(const BallSet& balls, const RunContext& context);
  // Calls make(device) for a triangulation that a device can have made.
  template <class Made, class Make>
  std::optional<Made> make_of(const Triangulation& triangulation, const RunContext& context,
                              const Make& make);
  bool find_device();   // with mutex_ locked
  void release_kept();  // with mutex_ locked

  std::mutex mutex_;
  MakeDevice make_device_;  // empty once it was called
  std::unique_ptr<DeviceTriangulator> device_;
  bool holds_memory_ = false;  // of the device
  std::string no_device_;
};

// As TriangulationMaker::make(). On the CPU if there is no maker.
Triangulation make_triangulation_by(const std::shared_ptr<TriangulationMaker>& maker,
                                    const BallSet& balls, int threads, const RunContext& context);

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the engines of the last two settings, so a return to earlier settings needs no set-up. With
// each engine it keeps the results for all its balls, unless another owner has them.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include "app/session/engines.hpp"
#include "core/document/store/answer.hpp"

namespace alphascope {

struct UnionDerivatives;

// One thread at a time may use it.
class EngineCache {
 public:
  // `threads` serve all engines. Null: each engine has threads of its own.
  explicit EngineCache(EngineFactory factory, std::shared_ptr<SharedThreads> threads = {})
      : factory_(std::move(factory)), threads_(std::move(threads)) {}

  // `balls` come without solvent radius. `of_all`: results of an earlier answer for all balls,
  // which another owner has. Results for other balls are ignored. The engine itself handles a
  // failing GPU (core/engines/engine_of_executors.hpp). Throws as make_engine(), with_solvent() and
  // Engine::compute() do.
  EngineAnswer compute(const std::shared_ptr<const BallSet>& balls, const Request& request,
                       const RunContext& context, const ResultsForAllAlphas& of_all = {});
  // As compute(), then share().
  std::shared_ptr<const EngineAnswer> compute_shared(const std::shared_ptr<const BallSet>& balls,
                                                     const Request& request,
                                                     const RunContext& context);
  // Hands over the results for all balls of the last answer's engine. The next answers use them
  // while the new owner keeps them.
  ResultsForAllAlphas take_made();
  // Call when the last answer is shared. The engine may then find complexes of smaller alphas in
  // it, by a threshold.
  void share(const std::shared_ptr<const EngineAnswer>& answer);

  // Areas and volumes of the last answer's complex, by its engine's device. If the device fails,
  // the CPU measures and adds a note. Nothing without a device. Throws as measure_union() does.
  std::optional<MeasuredUnion> measure_on_device(const EngineAnswer& answer,
                                                 const RunContext& context);
  // Lets the engine's device find the outer faces of the last answer's complex. Stores them in the
  // complex, and the time in `answer`. No effect without a device, or if it fails.
  void find_outer_faces_on_device(EngineAnswer& answer);
  // Measures by the device, or on the CPU if there is none. Derivatives need the CPU.
  MeasuredUnion measure(const EngineAnswer& answer, const RunContext& context,
                        UnionDerivatives* derivatives = nullptr);

  // Call before idle time. Engines free the memory that only their next results would use.
  void release_memory();
  void clear() { entries_.clear(); }
  std::uint64_t kept_bytes() const;  // bytes kept for later answers

 private:
  // An engine may hold a triangulation of millions of balls, so only the last settings are kept.
  static constexpr std::size_t kEntries = 2;

  struct Entry {
    std::shared_ptr<const BallSet> base, grown;
    Request request;  // the first request; requests with the same set-up share the entry
    MadeEngine made;
    bool answered = false;    // `made` has answered a request
    KnownResults known = {};  // results without those of other owners
    std::weak_ptr<const Triangulation> taken_triangulation = {};
    std::weak_ptr<const Filtration> taken_filtration = {};
  };

  std::optional<MadeEngine> engine_that_takes(const std::shared_ptr<const BallSet>& grown,
                                              Request request);
  AlphaComplex complex_of(Entry& entry, const Request& request, const RunContext& context,
                          const ResultsForAllAlphas& of_all);
  EngineAnswer answer(Entry& entry, const Request& request, const RunContext& context,
                      const ResultsForAllAlphas& of_all);
  Entry& find_or_make(const std::shared_ptr<const BallSet>& balls, const Request& request,
                      const ResultsForAllAlphas& of_all);

  EngineSettings engine_settings(const Request& request) const;
  std::shared_ptr<WorkThreads> threads_of(const Request& request) const;

  EngineFactory factory_;
  std::shared_ptr<SharedThreads> threads_;
  std::list<Entry> entries_;  // the last used entry first
};

}  // namespace alphascope

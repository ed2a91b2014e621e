// Keeps the engines of the last few settings, so that going back to one costs no setup. With each
// it keeps what is known of its balls, where nobody else does.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include "app/session/engines.hpp"
#include "core/document/store/answer.hpp"

namespace alphascope {

// Belongs to one thread at a time.
class EngineCache {
 public:
  // `threads`: whose the engines work on; null: each has its own.
  explicit EngineCache(EngineFactory factory, std::shared_ptr<SharedThreads> threads = {})
      : factory_(std::move(factory)), threads_(std::move(threads)) {}

  // `balls` without solvent radius. `of_all`: what another owner has of all balls of this or an
  // earlier answer; of other balls it is not looked at. What is done when a GPU fails is not
  // decided here but in the engine (core/engines/short_of_memory.hpp). Throws what make_engine(),
  // with_solvent() and Engine::compute() throw.
  EngineAnswer compute(const std::shared_ptr<const BallSet>& balls, const Request& request,
                       const RunContext& context, const OfAllBalls& of_all = {});
  // Hands over what the last answer's engine has made of all balls. The next answers are made from
  // it as long as the new owner has it.
  OfAllBalls take_made();
  // The last answer, now that it is shared: smaller alphas may be thresholds of it.
  void share(const std::shared_ptr<const EngineAnswer>& answer);

  // Areas and volumes of the last answer's complex, by the device of its engine; on the CPU, with a
  // note, where that cannot. Nothing when it has none. Throws what measure_union() throws.
  std::optional<MeasuredUnion> measure_on_device(const EngineAnswer& answer,
                                                 const RunContext& context);
  // The outside of the last answer's complex by the device of its engine, into that complex, and
  // how long that took; nothing where it has none, or that cannot.
  void find_outside_on_device(EngineAnswer& answer);
  // By the device, else on the CPU; derivatives are of the CPU only.
  MeasuredUnion measure(const EngineAnswer& answer, const RunContext& context,
                        UnionDerivatives* derivatives = nullptr);

  // Nothing will be asked for a while: gives back what engines keep for their next results alone.
  void rest();
  void clear() { entries_.clear(); }
  std::uint64_t kept_bytes() const;  // for later answers

 private:
  // An engine may hold a triangulation of millions of balls, so only the last settings are kept.
  static constexpr std::size_t kEntries = 2;

  struct Entry {
    std::shared_ptr<const BallSet> base, grown;
    Request request;  // the first; others are answered that have the same set-up
    MadeEngine made;
    bool answered = false;    // by `made`
    KnownOfBalls known = {};  // but for what others own
    std::weak_ptr<const Triangulation> taken_triangulation = {};
    std::weak_ptr<const Filtration> taken_filtration = {};
  };

  AlphaComplex complex_of(Entry& entry, const Request& request, const RunContext& context,
                          const OfAllBalls& of_all);
  EngineAnswer answer(Entry& entry, const Request& request, const RunContext& context,
                      const OfAllBalls& of_all);
  Entry& find_or_make(const std::shared_ptr<const BallSet>& balls, const Request& request,
                      const OfAllBalls& of_all);

  EngineSettings engine_settings(const Request& request) const;
  std::shared_ptr<WorkThreads> threads_of(const Request& request) const;

  EngineFactory factory_;
  std::shared_ptr<SharedThreads> threads_;
  std::list<Entry> entries_;  // the last used one first
};

}  // namespace alphascope

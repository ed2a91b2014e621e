// SPDX-License-Identifier: GPL-3.0-or-later
// Finds or makes the engine of a request, and hands results that cover all balls to their owner.
#include "app/session/engine_cache.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/session/rounding_note.hpp"
#include "core/engines/answers_from_known.hpp"
#include "core/measure/engine_measures.hpp"
#include "core/measure/union_measures.hpp"

namespace alphascope {

EngineCache::Entry& EngineCache::find_or_make(const std::shared_ptr<const BallSet>& balls,
                                              const Request& request,
                                              const ResultsForAllAlphas& of_all) {
  const auto fits = [&](const Entry& entry) {
    return entry.base == balls && same_setup(entry.request, request);
  };
  const auto found = std::find_if(entries_.begin(), entries_.end(), fits);
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front();
  }
  // Engines of another molecule are not needed again. They are freed before a new one is made.
  std::erase_if(entries_, [&](const Entry& entry) { return entry.base != balls; });
  std::shared_ptr<const BallSet> grown = balls;
  if (request.solvent_radius_angstrom != 0) {
    grown = std::make_shared<const BallSet>(with_solvent(*balls, request.solvent_radius_angstrom));
    if (of_all.balls && *of_all.balls == *grown) grown = of_all.balls;
  }
  std::optional<MadeEngine> taken = engine_that_takes(grown, request);
  while (entries_.size() >= kEntries) entries_.pop_back();
  MadeEngine made =
      taken ? *std::move(taken) : factory_(request.engine, grown, engine_settings(request));
  entries_.push_front({balls, std::move(grown), request, std::move(made)});
  return entries_.front();
}

// An engine of the same atoms with another solvent radius. A new one would reserve memory on the
// GPU anew.
std::optional<MadeEngine> EngineCache::engine_that_takes(
    const std::shared_ptr<const BallSet>& grown, Request request) {
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
    request.solvent_radius_angstrom = entry->request.solvent_radius_angstrom;
    if (!same_setup(entry->request, request) || !entry->made.engine->take(grown)) continue;
    MadeEngine made = std::move(entry->made);
    entries_.erase(entry);
    return made;
  }
  return std::nullopt;
}

EngineSettings EngineCache::engine_settings(const Request& request) const {
  EngineSettings settings{request.threads, request.tuples};
  if (threads_) settings.shared = threads_->of(request.threads);
  return settings;
}

std::shared_ptr<WorkThreads> EngineCache::threads_of(const Request& request) const {
  return threads_ ? threads_->of(request.threads) : std::make_shared<WorkThreads>(request.threads);
}

std::optional<MeasuredUnion> EngineCache::measure_on_device(const EngineAnswer& answer,
                                                            const RunContext& context) {
  if (entries_.empty() || entries_.front().grown != answer.balls) return std::nullopt;
  return alphascope::measure_on_device(*entries_.front().made.engine, *answer.balls, answer.complex,
                                       *threads_of(answer.request), context);
}

void EngineCache::find_outer_faces_on_device(EngineAnswer& answer) {
  if (entries_.empty() || entries_.front().grown != answer.balls) return;
  const auto begun = std::chrono::steady_clock::now();
  answer.complex.outside = entries_.front().made.engine->find_outer_faces(answer.complex);
  if (!answer.complex.outside) return;
  answer.outer_faces_milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

void EngineCache::release_memory() {
  for (Entry& entry : entries_) entry.made.engine->release_memory();
}

MeasuredUnion EngineCache::measure(const EngineAnswer& answer, const RunContext& context,
                                   UnionDerivatives* derivatives) {
  if (derivatives == nullptr) {
    if (auto measured = measure_on_device(answer, context)) return *std::move(measured);
  }
  return measure_on_cpu(*answer.balls, answer.complex, *threads_of(answer.request), context,
                        derivatives);
}

std::uint64_t EngineCache::kept_bytes() const {
  std::uint64_t bytes = 0;
  for (const Entry& entry : entries_) bytes += bytes_of(entry.known);
  return bytes;
}

// Computes the complex. If that is cancelled, the entry keeps finished results for all balls, for
// the next request.
AlphaComplex EngineCache::complex_of(Entry& entry, const Request& request,
                                     const RunContext& context, const ResultsForAllAlphas& of_all) {
  ResultsForAllAlphas owned{entry.grown, entry.taken_triangulation.lock(),
                            entry.taken_filtration.lock()};
  if (of_all.balls == entry.grown) owned.add(of_all);
  KnownResults& known = entry.known;
  known.balls = entry.grown;
  known.add(owned);
  try {
    AlphaComplex complex = entry.made.engine->compute(
        {request.alpha_angstrom2, request.tetrahedra_only}, known, context);
    known.drop(owned);
    return complex;
  } catch (...) {
    known.drop(owned);
    throw;
  }
}

// An answer is cold if it is the engine's first and has set-up stages. It has none if an earlier,
// cancelled request had finished the set-up.
EngineAnswer EngineCache::answer(Entry& entry, const Request& request, const RunContext& context,
                                 const ResultsForAllAlphas& of_all) {
  AlphaComplex complex = complex_of(entry, request, context, of_all);
  const auto& stages = complex.timings.stages;
  const bool set_up =
      std::any_of(stages.begin(), stages.end(), [](const StageTime& s) { return s.setup; });
  const bool first = !std::exchange(entry.answered, true);
  std::string note = entry.made.note;
  const std::string rounding = rounding_note(request, entry.grown->lattice);
  if (!rounding.empty()) note += (note.empty() ? "" : " ") + rounding;
  return {request, entry.grown, std::move(complex), std::move(note), first && set_up};
}

EngineAnswer EngineCache::compute(const std::shared_ptr<const BallSet>& balls,
                                  const Request& request, const RunContext& context,
                                  const ResultsForAllAlphas& of_all) {
  context.cancel.throw_if_cancelled();
  Entry& entry = find_or_make(balls, request, of_all);
  // The other engines free memory that they keep for their next results. On a GPU it is large.
  for (Entry& other : entries_) {
    if (&other != &entry) other.made.engine->release_memory();
  }
  return answer(entry, request, context, of_all);
}

ResultsForAllAlphas EngineCache::take_made() {
  if (entries_.empty()) return {};
  Entry& entry = entries_.front();
  ResultsForAllAlphas made{entry.grown, std::exchange(entry.known.triangulation, nullptr),
                           std::exchange(entry.known.filtration, nullptr)};
  if (made.triangulation) entry.taken_triangulation = made.triangulation;
  if (made.filtration) entry.taken_filtration = made.filtration;
  return made;
}

std::shared_ptr<const EngineAnswer> EngineCache::compute_shared(
    const std::shared_ptr<const BallSet>& balls, const Request& request,
    const RunContext& context) {
  auto answer = std::make_shared<const EngineAnswer>(compute(balls, request, context));
  share(answer);
  return answer;
}

void EngineCache::share(const std::shared_ptr<const EngineAnswer>& answer) {
  if (entries_.empty() || entries_.front().grown != answer->balls) return;
  entries_.front().known.share({answer, &answer->complex});
}

}  // namespace alphascope

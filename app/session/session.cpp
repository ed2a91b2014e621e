// SPDX-License-Identifier: GPL-3.0-or-later
// Moves files, requests and results between the main thread and the workers.
#include "app/session/session.hpp"

#include <thread>
#include <utility>

#include "core/document/reference/reference.hpp"
#include "core/engines/answers_from_known.hpp"
#include "core/measure/engine_measures.hpp"
#include "core/molecule/molecule.hpp"
#include "core/run/freed_on_other_thread.hpp"

namespace alphascope {

namespace {

// Slider moves come every few milliseconds. A computation shorter than this is finished, so
// pictures keep coming. A longer one is cancelled for the newest request.
constexpr std::chrono::milliseconds kSliderGrace{150};
constexpr std::chrono::milliseconds kAlways = std::chrono::hours(24);

std::string memory_remedy(SessionState::Source source) {
  switch (source) {
    case SessionState::Source::computing:
      return "There is not enough memory for this complex. Use a smaller alpha or solvent radius, "
             "compute tetrahedra only, keep fewer atoms, or close other programs.";
    case SessionState::Source::comparing:
      return "There is not enough memory to compare with CGAL. Use a smaller alpha, compute "
             "tetrahedra only, or close other programs.";
    case SessionState::Source::none:
    case SessionState::Source::opening:
    case SessionState::Source::changing:
      break;
  }
  return "There is not enough memory for so many atoms. Choose no assembly or a smaller one, one "
         "model, or fewer chains, or close other programs.";
}

AlphaComplex without_simplices(AlphaComplex complex) {
  complex.vertices = {};
  complex.edges = {};
  complex.triangles = {};
  complex.tetrahedra = {};
  return complex;
}

}  // namespace

Session::Services Session::program_services() {
  return {&make_engine,
          &alphascope::open_molecule,
          &alphascope::reopen_molecule,
          static_cast<int>(std::thread::hardware_concurrency()),
          &is_engine_memory_unused,
          &free_unused_engine_memory,
          &wait_for_engine_device};
}

Session::Session(std::function<void()> wake, Services services)
    : services_(std::move(services)),
      engines_(std::make_shared<EngineCache>(services_.make_engine, threads_)),
      references_(std::make_shared<EngineCache>(services_.make_engine)),
      opener_(wake),
      computer_(wake, kSliderGrace),
      comparer_(wake) {}

Session::~Session() = default;

void Session::open(const std::filesystem::path& path) {
  opening_path_ = path;
  asked_.reset();
  submit_open(path);
}

void Session::open(const std::filesystem::path& path, const OpenOptions& options,
                   const Request& request) {
  opening_path_ = path;
  asked_ = Asked{options, request};
  submit_open(path);
}

void Session::close() {
  // A worker that has finished delivers now, so that nothing comes later.
  opener_.cancel();
  opener_.poll();
  computer_.cancel();
  computer_.poll();
  comparer_.cancel();
  comparer_.poll();
  opening_path_.clear();
  asked_.reset();
  comparison_wanted_ = timing_parallel_ = reference_anew_ = false;
  options_ = for_another_file(options_);
  SessionState closed;
  closed.request = state_.request;
  state_ = std::move(closed);
  computer_.when_idle([engines = engines_] { engines->clear(); });
  comparer_.when_idle([references = references_] { references->clear(); });
  changes_ = {};
}

void Session::set_open_options(const OpenOptions& options) {
  options_ = options;
  if (!opening_path_.empty()) {
    if (!asked_) submit_open(opening_path_);
  } else if (state_.opened) {
    submit_reopen();
  }
}

void Session::submit_open(const std::filesystem::path& path) {
  const OpenOptions options = asked_          ? asked_->options
                              : state_.opened ? for_another_file(options_)
                                              : options_;
  opener_.submit(
      [this, path, options, asked = asked_, open = services_.open_molecule](const RunContext& c) {
        auto opened = std::make_shared<const OpenedMolecule>(open(path, options, c));
        return
            [this, opened, asked] { take_opened(opened, asked ? asked->request : state_.request); };
      },
      failure_of(Source::opening, ""));
}

void Session::submit_reopen() {
  const bool same_file_limit = options_.read.max_bytes == state_.opened->options.read.max_bytes;
  if (!same_file_limit) {
    open(state_.molecule->source);
    return;
  }
  opener_.submit(
      [this, before = state_.opened, options = options_,
       reopen = services_.reopen_molecule](const RunContext& context) {
        auto opened = std::make_shared<const OpenedMolecule>(reopen(*before, options, context));
        return [this, opened] { take_opened(opened, state_.request); };
      },
      failure_of(Source::changing, ""));
}

void Session::take_opened(std::shared_ptr<const OpenedMolecule> opened, const Request& request) {
  const bool latest = !opener_.activity().busy;
  state_.request = request;
  if (latest) {
    opening_path_.clear();
    asked_.reset();
    options_ = opened->options;
  }
  computer_.cancel();
  comparer_.cancel();
  state_.molecule = opened->molecule;
  state_.prepared = opened->prepared;
  state_.opened = std::move(opened);
  state_.ours = nullptr;
  state_.agreement = nullptr;
  state_.our_timings = {};
  forget_reference_timings();
  changes_.molecule = changes_.answer = changes_.agreement = true;
  succeeded(Source::opening);
  submit_compute();
}

// Keeps the open molecule. If another file could not be read, options that the user set meanwhile
// now apply to the open molecule. Options that the molecule has refused are reset.
void Session::opening_failed() {
  if (opener_.activity().busy) return;
  const bool was_a_file = !opening_path_.empty();
  opening_path_.clear();
  asked_.reset();
  if (!state_.opened || options_ == state_.opened->options) return;
  if (was_a_file) {
    submit_reopen();
  } else {
    options_ = state_.opened->options;
    changes_.options = true;
  }
}

void Session::set_request(const Request& request, const ResultsForAllAlphas& of_all) {
  if (request == state_.request && (state_.up_to_date() || computer_.activity().busy)) return;
  if (!same_setup(request, state_.request)) state_.our_timings = {};
  if (request.solvent_radius_angstrom != state_.request.solvent_radius_angstrom) {
    forget_reference_timings();
  }
  // A timing of parallel CGAL would take cores from the new computation, which is timed as well.
  if (timing_parallel_) comparer_.cancel();
  state_.request = request;
  if (state_.prepared) submit_compute(Engines::kept, of_all);
}

void Session::set_dragging(bool dragging) {
  computer_.set_grace(dragging ? kAlways : kSliderGrace);
}

void Session::compute_anew() {
  if (!state_.prepared) return;
  reference_anew_ = true;
  if (timing_parallel_) comparer_.cancel();
  submit_compute(Engines::anew);
}

bool Session::waits_for_device() const {
  return tables_first_ && state_.ours &&
         state_.ours->request.solvent_radius_angstrom != state_.request.solvent_radius_angstrom;
}

void Session::submit_compute(Engines which, const ResultsForAllAlphas& of_all) {
  computer_.submit(
      [this, which, of_all, request = state_.request, molecule = state_.molecule,
       prepared = state_.prepared, engines = engines_, measuring = measuring_,
       finding_outside = finding_outer_faces_,
       wait = waits_for_device() ? services_.wait_for_device : nullptr](const RunContext& context) {
        if (which == Engines::anew) engines->clear();
        if (wait) wait(context.cancel);
        EngineAnswer found = engines->compute(prepared->balls, request, context, of_all);
        if (measuring && !request.tetrahedra_only) {
          if (auto measured = engines->measure_on_device(found, context)) {
            found.measures = std::make_shared<const MeasuredUnion>(*std::move(measured));
          }
        }
        if (finding_outside) engines->find_outer_faces_on_device(found);
        const auto made = std::make_shared<ResultsForAllAlphas>(engines->take_made());
        const std::uint64_t kept = engines->kept_bytes();
        const std::shared_ptr<const Answer> answer =
            freed_on_other_thread(Answer{std::move(found), molecule, prepared, made, kept});
        engines->share(answer);
        return [this, answer] { take_answer(answer); };
      },
      failure_of(Source::computing, "Computing the complex failed: "));
}

void Session::take_answer(std::shared_ptr<const Answer> answer) {
  if (answer->prepared != state_.prepared) return;  // belongs to the previous molecule
  if (same_setup(answer->request, state_.request)) {
    state_.our_timings.note(answer->complex, answer->cold);
  }
  // The previous answer may never reach the screen. So results that came with it go to the new one.
  if (state_.ours && state_.ours->balls == answer->balls) {
    answer->made->add(std::exchange(*state_.ours->made, {}));
  }
  state_.ours = std::move(answer);
  changes_.answer = true;
  succeeded(Source::computing);
  if (comparison_wanted_ && state_.up_to_date()) submit_comparison();
}

void Session::request_comparison(int threads) {
  comparison_wanted_ = true;
  comparison_threads_ = threads;
  if (state_.up_to_date()) submit_comparison();
}

void Session::cancel_comparison() {
  comparison_wanted_ = false;
  comparer_.cancel();
}

// Returns the present request for CGAL. It lacks the switches of the tuple engine, which CGAL does
// not use. So a change of them does not discard CGAL's triangulation.
Request Session::reference_request(int threads) const {
  Request request = state_.ours->request;
  request.engine = EngineChoice::cgal;
  request.threads = threads;
  request.tuples = {};
  return request;
}

void Session::submit_comparison() {
  comparison_wanted_ = timing_parallel_ = false;
  const Request request = reference_request(comparison_threads_);
  const bool anew = std::exchange(reference_anew_, false);
  comparer_.submit(
      [this, anew, request, ours = state_.ours,
       references = references_](const RunContext& context) {
        if (anew) references->clear();
        EngineAnswer result = references->compute(ours->prepared->balls, request, context);
        context.cancel.throw_if_cancelled();
        context.report("comparison", 0);
        auto agreement = std::make_shared<Agreement>();
        agreement->ours = ours;
        agreement->comparison = compare(ours->complex, result.complex);
        agreement->reference_cold = result.cold;
        agreement->kept_bytes = references->kept_bytes();
        agreement->reference = std::make_shared<const AlphaComplex>(std::move(result.complex));
        return [this, agreement] { take_agreement(agreement); };
      },
      failure_of(Source::comparing, "Comparing with CGAL failed: "));
}

void Session::take_agreement(std::shared_ptr<const Agreement> agreement) {
  const Answer& ours = *agreement->ours;
  if (ours.prepared != state_.prepared) return;  // belongs to the previous molecule
  if (ours.request.solvent_radius_angstrom == state_.request.solvent_radius_angstrom) {
    state_.reference_timings.note(*agreement->reference, agreement->reference_cold);
  }
  state_.agreement = std::move(agreement);
  changes_.agreement = true;
  succeeded(Source::comparing);
  // CGAL's parallel code needs three threads (core/engine/engine.hpp).
  if (services_.cgal_threads >= 3 && state_.up_to_date()) submit_parallel_timing();
}

void Session::submit_parallel_timing() {
  timing_parallel_ = true;
  const Request request = reference_request(services_.cgal_threads);
  comparer_.submit(
      [this, request, ours = state_.ours, references = references_](const RunContext& context) {
        EngineAnswer result = references->compute(ours->prepared->balls, request, context);
        // Only the times are kept, since these simplices are those already compared.
        auto times = std::make_shared<EngineAnswer>();
        times->cold = result.cold;
        times->complex = without_simplices(std::move(result.complex));
        return [this, ours, times] { take_parallel_timing(*ours, *times); };
      },
      failure_of(Source::comparing, "Timing CGAL with all threads failed: "));
}

void Session::take_parallel_timing(const Answer& ours, const EngineAnswer& times) {
  timing_parallel_ = false;
  if (ours.prepared != state_.prepared ||
      ours.request.solvent_radius_angstrom != state_.request.solvent_radius_angstrom) {
    return;
  }
  state_.parallel_timings.note(times.complex, times.cold);
  changes_.agreement = true;
}

void Session::forget_reference_timings() {
  state_.reference_timings = state_.parallel_timings = {};
}

Worker::FailureHandler Session::failure_of(Source source, std::string prefix) {
  return [this, source, prefix = std::move(prefix)](const Worker::Failure& failure) {
    if (source == Source::opening || source == Source::changing) opening_failed();
    if (failure.cancelled) return;
    state_.last_error = failure.out_of_memory ? memory_remedy(source) : prefix + failure.message;
    state_.error_source = source;
    changes_.error = true;
  };
}

void Session::succeeded(Source source) {
  const bool same = state_.error_source == source ||
                    (source == Source::opening && state_.error_source == Source::changing);
  if (!same) return;
  state_.error_source = Source::none;
  state_.last_error.clear();
  changes_.error = true;
}

SessionChanges Session::poll() {
  opener_.poll();
  computer_.poll();
  comparer_.poll();
  // The main thread must not wait while memory of dropped results is freed.
  if (services_.is_memory_unused && services_.is_memory_unused()) {
    computer_.when_idle(services_.free_unused_memory);
  }
  return std::exchange(changes_, {});
}

void Session::release_engine_memory() {
  computer_.when_idle([engines = engines_] { engines->release_memory(); });
}

std::uint64_t Session::held_bytes() const {
  std::uint64_t bytes = 0;
  if (state_.ours) {
    bytes +=
        bytes_of(state_.ours->complex) + state_.ours->kept_bytes + bytes_of(*state_.ours->made);
  }
  if (state_.ours && state_.ours->measures) bytes += 16 * state_.ours->balls->size();
  if (const Agreement* agreement = state_.agreement.get()) {
    bytes += bytes_of(*agreement->reference) + agreement->kept_bytes;
    if (agreement->ours != state_.ours) bytes += bytes_of(agreement->ours->complex);
  }
  return bytes;
}

SessionActivity Session::activity() const {
  SessionActivity a{
      opener_.activity(), computer_.activity(), comparer_.activity(), {}, opening_path_};
  if (timing_parallel_) std::swap(a.comparing, a.timing);
  return a;
}

}  // namespace alphascope

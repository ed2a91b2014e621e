// One open molecule and its latest exact results, for a main thread that never waits: what the
// window shows and changes. No GUI type; drawing is not its business.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/session/engine_cache.hpp"
#include "app/session/open_molecule.hpp"
#include "core/complex/compare.hpp"
#include "core/engine/cold_and_warm.hpp"
#include "core/run/worker.hpp"

namespace alphascope {

// An answer beside CGAL's; immutable once handed over.
struct Agreement {
  std::shared_ptr<const Answer> ours;
  std::shared_ptr<const AlphaComplex> reference;
  Comparison comparison;
  bool reference_cold = false;
  std::uint64_t kept_bytes = 0;  // by CGAL's engines
};

// Pointers are null as long as there is nothing.
struct SessionState {
  std::shared_ptr<const OpenedMolecule> opened;  // what the next two are parts of
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const PreparedBalls> prepared;  // radii before any solvent radius
  Request request;                                // the latest asked for
  std::shared_ptr<const Answer> ours;
  std::shared_ptr<const Agreement> agreement;  // of `ours` when agreement->ours == ours
  ColdAndWarm our_timings, reference_timings;  // of the present balls, solvent radius and engine
  // CGAL with all threads; not of machines without enough threads. Follows an agreement.
  ColdAndWarm parallel_timings;
  // Of what failed last; the text is empty once the same thing has succeeded.
  enum class Source { none, opening, changing, computing, comparing };  // changing: what is open
  std::string last_error;
  Source error_source = Source::none;

  // `ours` answers the latest request.
  bool up_to_date() const { return ours && ours->request == request; }
};

struct SessionActivity {
  Worker::Activity opening, computing, comparing;
  Worker::Activity timing;             // of CGAL with all threads, after a comparison
  std::filesystem::path opening_path;  // while opening.busy
};

struct SessionChanges {
  bool molecule = false;   // molecule or prepared balls
  bool answer = false;     // ours, our_timings
  bool agreement = false;  // agreement, reference_timings
  bool error = false;      // last_error
  bool options = false;    // open_options(), by the session itself
  bool any() const { return molecule || answer || agreement || error || options; }
};

class Session {
 public:
  using Opener = std::function<OpenedMolecule(const std::filesystem::path&, const OpenOptions&,
                                              const RunContext&)>;
  using Reopener =
      std::function<OpenedMolecule(const OpenedMolecule&, const OpenOptions&, const RunContext&)>;
  struct Services {
    EngineFactory make_engine;  // also asked, on another thread, for the CGAL reference
    Opener open_molecule;
    Reopener reopen_molecule;
    // Of the parallel CGAL that is timed after a comparison; fewer than three: it is not.
    int cgal_threads = 0;
    // As is_engine_memory_unused() and free_unused_engine_memory(); may be empty.
    std::function<bool()> is_memory_unused = {};
    std::function<void()> free_unused_memory = {};
  };
  static Services program_services();

  // `wake` as in Worker: called from other threads when poll() has something to do.
  explicit Session(std::function<void()> wake = {}, Services services = program_services());
  ~Session();

  // Reads a file in the background; then its complex is computed at the present request. The old
  // molecule and its results stay until that has succeeded. After the first file, the options that
  // were chosen for one file only go back to their defaults (for_another_file()).
  void open(const std::filesystem::path& path);
  // The same with options and a request that hold from the moment that the file is there; until
  // then, and when it cannot be read, everything stays.
  void open(const std::filesystem::path& path, const OpenOptions& options, const Request& request);
  // Applies to the open molecule at once, and to those opened later. When it fails or is cancelled
  // the molecule stays as it was, and the options go back to those that it was made with.
  void set_open_options(const OpenOptions& options);
  const OpenOptions& open_options() const { return options_; }
  void cancel_opening() { opener_.cancel(); }

  // Latest wins. Does nothing when `request` is the present one and already answered or on its way.
  // `of_all`: what the store has of all balls, for engines on the CPU; of other balls it is not
  // looked at. The comparison with CGAL does not use it.
  void set_request(const Request& request, const OfAllBalls& of_all = {});
  // Whether answers to come have their areas and volumes with them where the engine has a device
  // that keeps the complex (EngineAnswer::measures).
  void set_measuring(bool measuring) { measuring_ = measuring; }
  // Likewise, whether they have the outside of their tetrahedra (AlphaComplex::outside).
  void set_finding_outside(bool finding) { finding_outside_ = finding; }
  // Memory is about to be short: the engines give back what they keep for their next results
  // alone, when none is being computed.
  void let_engines_rest();
  void cancel_computing() { computer_.cancel(); }
  // While a slider is dragged, a computation that has begun finishes although a newer request
  // waits: else a slow one would show nothing until the hand rests. At rest it soon gives way.
  void let_finish(bool dragging);

  // Answers the present request once more, set-up included, as if the molecule had just been
  // opened; so does CGAL when it is next asked to compare. For the cold times of engines that were
  // kept.
  void compute_anew();

  // Compares with CGAL's triangulation, on a thread of its own: the present answer, or the next
  // when one is on its way. `threads` for CGAL: 1 is its sequential triangulation, 0 all of the
  // machine.
  void request_comparison(int threads = 1);
  void cancel_comparison();

  // To be called on the main thread, every frame or when woken.
  SessionChanges poll();
  const SessionState& state() const { return state_; }
  // Those that the complexes are computed on, for the number of them that is set.
  std::shared_ptr<WorkThreads> threads() const { return threads_->of(state_.request.threads); }
  // Complexes and what engines keep for the next ones, as far as it is known.
  std::uint64_t held_bytes() const;
  SessionActivity activity() const;

 private:
  struct Asked {
    OpenOptions options;
    Request request;
  };
  void submit_open(const std::filesystem::path& path);
  void submit_reopen();
  void opening_failed();
  enum class Engines { kept, anew };
  void submit_compute(Engines which = Engines::kept, const OfAllBalls& of_all = {});
  Request reference_request(int threads) const;
  void submit_comparison();
  void submit_parallel_timing();
  void take_parallel_timing(const Answer& ours, const EngineAnswer& times);
  void forget_reference_timings();
  void take_opened(std::shared_ptr<const OpenedMolecule> opened, const Request& request);
  void take_answer(std::shared_ptr<const Answer> answer);
  void take_agreement(std::shared_ptr<const Agreement> agreement);
  using Source = SessionState::Source;
  Worker::FailureHandler failure_of(Source source, std::string prefix);
  void succeeded(Source source);

  Services services_;
  OpenOptions options_;
  SessionState state_;
  SessionChanges changes_;
  std::filesystem::path opening_path_;  // empty when none is on its way
  std::optional<Asked> asked_;          // with it; none: what is in force
  bool measuring_ = false, finding_outside_ = false;
  bool comparison_wanted_ = false;
  bool reference_anew_ = false;   // of the next comparison
  bool timing_parallel_ = false;  // is what the comparer does
  int comparison_threads_ = 1;
  const std::shared_ptr<SharedThreads> threads_ = std::make_shared<SharedThreads>();
  // Each is touched by the jobs of one worker only.
  std::shared_ptr<EngineCache> engines_, references_;

  // Last, so that they are joined before anything that their jobs use goes.
  Worker opener_, computer_, comparer_;
};

}  // namespace alphascope

// SPDX-License-Identifier: GPL-3.0-or-later
// One open molecule and its latest exact results, for a main thread that never waits. Holds no GUI
// type and does not draw.
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

// An answer and CGAL's complex. Immutable once published.
struct Agreement {
  std::shared_ptr<const Answer> ours;
  std::shared_ptr<const AlphaComplex> reference;
  Comparison comparison;
  bool reference_cold = false;
  std::uint64_t kept_bytes = 0;  // by CGAL's engines
};

// Pointers are null until there is a value.
struct SessionState {
  std::shared_ptr<const OpenedMolecule> opened;  // holds the next two
  std::shared_ptr<const Molecule> molecule;
  std::shared_ptr<const PreparedBalls> prepared;  // radii without solvent radius
  Request request;                                // the latest request
  std::shared_ptr<const Answer> ours;
  std::shared_ptr<const Agreement> agreement;  // of `ours` when agreement->ours == ours
  ColdAndWarm our_timings, reference_timings;  // for the present balls, solvent radius and engine
  // CGAL with all threads, timed after an agreement. Empty if the machine has too few threads.
  ColdAndWarm parallel_timings;
  // The last failure, and the action that failed. The text becomes empty when the same action
  // succeeds.
  // changing: options of the open molecule
  enum class Source { none, opening, changing, computing, comparing };
  std::string last_error;
  Source error_source = Source::none;

  // True if `ours` answers the latest request.
  bool up_to_date() const { return ours && ours->request == request; }
};

struct SessionActivity {
  Worker::Activity opening, computing, comparing;
  Worker::Activity timing;             // CGAL with all threads, after a comparison
  std::filesystem::path opening_path;  // while opening.busy
};

struct SessionChanges {
  bool molecule = false;   // molecule or prepared balls
  bool answer = false;     // ours, our_timings
  bool agreement = false;  // agreement, reference_timings
  bool error = false;      // last_error
  bool options = false;    // the session itself changed open_options()
  bool any() const { return molecule || answer || agreement || error || options; }
};

class Session {
 public:
  using Opener = std::function<OpenedMolecule(const std::filesystem::path&, const OpenOptions&,
                                              const RunContext&)>;
  using Reopener =
      std::function<OpenedMolecule(const OpenedMolecule&, const OpenOptions&, const RunContext&)>;
  struct Services {
    EngineFactory make_engine;  // another thread calls it for the CGAL reference
    Opener open_molecule;
    Reopener reopen_molecule;
    // Threads of the parallel CGAL that is timed after a comparison. Fewer than three: it is not
    // timed.
    int cgal_threads = 0;
    // As is_engine_memory_unused() and free_unused_engine_memory(). May be empty.
    std::function<bool()> is_memory_unused = {};
    std::function<void()> free_unused_memory = {};
    // As wait_for_engine_device(). May be empty.
    std::function<void(const CancelToken&)> wait_for_device = {};
  };
  static Services program_services();

  // `wake` as in Worker: other threads call it when poll() has work.
  explicit Session(std::function<void()> wake = {}, Services services = program_services());
  ~Session();

  // Reads a file in the background, then computes its complex at the present request. The old
  // molecule and its results stay until the file is read. A second or later file resets the options
  // that hold for one file only (for_another_file()).
  void open(const std::filesystem::path& path);
  // The same with options and a request that hold once the file is read. Until then, and if reading
  // fails, nothing changes.
  void open(const std::filesystem::path& path, const OpenOptions& options, const Request& request);
  // Applies options to the open molecule, in the background, and to later ones. If this fails or is
  // cancelled, the molecule and its options stay.
  void set_open_options(const OpenOptions& options);
  const OpenOptions& open_options() const { return options_; }
  void cancel_opening() { opener_.cancel(); }
  // Closes the molecule and cancels all work. The request stays, and so do options that do not
  // belong to one file.
  void close();

  // The latest request wins. No effect if `request` is the present one and is answered or being
  // computed. `of_all`: the store's results for all balls, for engines on the CPU; results for
  // other balls are ignored. The comparison with CGAL does not use them.
  void set_request(const Request& request, const ResultsForAllAlphas& of_all = {});
  // Whether answers come with areas and volumes (EngineAnswer::measures), if the engine's device
  // keeps the complex.
  void set_measuring(bool measuring) { measuring_ = measuring; }
  // Whether answers come with the outer faces of their tetrahedra (AlphaComplex::outside).
  void set_finding_outer_faces(bool finding) { finding_outer_faces_ = finding; }
  // Call when memory gets short. If nothing is being computed, engines free the memory that only
  // their next results would use.
  void release_engine_memory();
  void cancel_computing() { computer_.cancel(); }
  // While a slider is dragged, a running computation is finished although a newer request waits.
  // Otherwise slow computations would never show a result. At rest, a newer request cancels it
  // after 150 ms.
  void set_dragging(bool dragging);
  // Whether tables of the balls on screen are being made. A computation for another solvent radius
  // then lets them have the engine's device first.
  void set_tables_first(bool first) { tables_first_ = first; }

  // Computes the present request once more with its set-up, as after opening the molecule. CGAL
  // does the same at its next comparison. This gives cold times of engines that were kept.
  void compute_anew();

  // Compares the present answer with CGAL's triangulation, on a thread of its own. If an answer is
  // being computed, it is compared instead. `threads` for CGAL: 1 is its sequential triangulation,
  // 0 all threads of the machine.
  void request_comparison(int threads = 1);
  void cancel_comparison();

  // Call on the main thread, every frame or when woken.
  SessionChanges poll();
  const SessionState& state() const { return state_; }
  // The threads of the computation, for the present number of threads.
  std::shared_ptr<WorkThreads> threads() const { return threads_->of(state_.request.threads); }
  // Known bytes of complexes and of results that engines keep.
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
  void submit_compute(Engines which = Engines::kept, const ResultsForAllAlphas& of_all = {});
  bool waits_for_device() const;
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
  std::filesystem::path opening_path_;  // empty: no file is being opened
  std::optional<Asked> asked_;          // for opening_path_; none: the options and request in force
  bool measuring_ = false, finding_outer_faces_ = false, tables_first_ = false;
  bool comparison_wanted_ = false;
  bool reference_anew_ = false;   // the next comparison needs a new engine
  bool timing_parallel_ = false;  // the comparer times parallel CGAL
  int comparison_threads_ = 1;
  const std::shared_ptr<SharedThreads> threads_ = std::make_shared<SharedThreads>();
  // Only the jobs of one worker use each cache.
  std::shared_ptr<EngineCache> engines_, references_;

  // Last members, so that their threads are joined before their jobs' data is destroyed.
  Worker opener_, computer_, comparer_;
};

}  // namespace alphascope

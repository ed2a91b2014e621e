// alphascope-cli bench: our engine and CGAL in one process, cold and warm, medians.
// Cold: a new engine, made and asked once; what a user waits for after opening a molecule. CGAL's
// cold time is its own route, the triangulation and the filter. Warm: the same engine asked again
// for a slightly different alpha, as a slider does.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>

#include "app/cli/commands.hpp"
#include "app/cli/input.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "core/io/atomic_file.hpp"

namespace alphascope::cli {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

struct Series {
  std::vector<double> cold, warm;  // ms
  AlphaComplex complex;            // of the last cold run, its lists empty
  std::size_t tetrahedra = 0;
};

template <class Work>
double timed(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// The step between two places of a slider that a hand can still tell apart.
constexpr double kSliderStep = 0.001;  // Å²

void run_once(const std::shared_ptr<const BallSet>& balls, const SessionRequest& request,
              const RunContext& context, Series& series) {
  MadeEngine made;
  AlphaComplex complex;
  const AlphaRequest at{request.alpha_angstrom2, request.tetrahedra_only};
  series.cold.push_back(timed([&] {
    made = make_engine(request.engine, balls, {request.threads, request.tuples});
    complex = made.engine->compute(at, context);
  }));
  const AlphaRequest beside{request.alpha_angstrom2 - kSliderStep, request.tetrahedra_only};
  AlphaComplex moved;
  series.warm.push_back(timed([&] { moved = made.engine->compute(beside, context); }));
  series.tetrahedra = complex.tetrahedra.size();
  series.complex = {};
  series.complex.hash = complex.hash;
  series.complex.engine = complex.engine;
}

struct Row {
  std::string file;
  std::size_t balls = 0;
  SessionRequest request;
  Series ours, cgal;
  bool same() const { return ours.complex.hash == cgal.complex.hash; }
};

Row measure(const std::filesystem::path& file, const std::shared_ptr<const BallSet>& balls,
            const SessionRequest& request, int runs, const RunContext& context) {
  Row row{file.filename().string(), balls->size(), request, {}, {}};
  SessionRequest cgal = request;
  cgal.engine = EngineChoice::cgal;
  for (int run = 0; run < runs; ++run) {
    // In turns, so that a machine that slows down meanwhile slows both.
    run_once(balls, request, context, row.ours);
    run_once(balls, cgal, context, row.cgal);
  }
  return row;
}

void print_header() {
  std::printf("%-18s %9s %7s %7s %3s %10s %11s %11s %7s %11s %11s  %s\n", "file", "balls", "alpha",
              "solvent", "thr", "tetrahedra", "cold ms", "CGAL cold", "ratio", "warm ms",
              "CGAL warm", "engine");
}

void print_row(const Row& row) {
  const double cold = median(row.ours.cold), cgal = median(row.cgal.cold);
  std::printf("%-18s %9s %7s %7s %3d %10s %11.2f %11.2f %7.2f %11.2f %11.2f  %s, %s%s\n",
              row.file.c_str(), grouped(row.balls).c_str(),
              number_text(row.request.alpha_angstrom2).c_str(),
              number_text(row.request.solvent_radius_angstrom).c_str(), row.request.threads,
              grouped(row.ours.tetrahedra).c_str(), cold, cgal, cgal / cold,
              median(row.ours.warm), median(row.cgal.warm), row.ours.complex.engine.name.c_str(),
              row.ours.complex.engine.route.c_str(), row.same() ? "" : "  DIFFERS FROM CGAL");
  std::fflush(stdout);
}

std::string csv_quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv(const std::vector<Row>& rows) {
  std::string text =
      "file,balls,alpha_angstrom2,solvent_radius_angstrom,tetrahedra_only,threads,tetrahedra,hash,"
      "engine,device,route,runs,cold_median_ms,cold_min_ms,warm_median_ms,cgal_cold_median_ms,"
      "cgal_cold_min_ms,cgal_warm_median_ms,identical\n";
  const auto least = [](const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); };
  for (const Row& row : rows) {
    const SessionRequest& r = row.request;
    text += csv_quoted(row.file) + "," + std::to_string(row.balls) + "," +
            number_text(r.alpha_angstrom2) + "," + number_text(r.solvent_radius_angstrom) + "," +
            (r.tetrahedra_only ? "1," : "0,") + std::to_string(r.threads) + "," +
            std::to_string(row.ours.tetrahedra) + "," + hash_text(row.ours.complex.hash) + "," +
            csv_quoted(row.ours.complex.engine.name) + "," +
            csv_quoted(row.ours.complex.engine.device) + "," +
            csv_quoted(row.ours.complex.engine.route) + "," +
            std::to_string(row.ours.cold.size());
    for (const double ms : {median(row.ours.cold), least(row.ours.cold), median(row.ours.warm),
                            median(row.cgal.cold), least(row.cgal.cold), median(row.cgal.warm)}) {
      text += "," + number_text(ms);
    }
    text += row.same() ? ",1\n" : ",0\n";
  }
  return text;
}

}  // namespace

ExitCode run_bench(const BenchOptions& options) {
  const RunContext& context = run_context();
  RunContext quiet;  // no progress reports while the clock runs
  quiet.cancel = context.cancel;
  std::vector<Row> rows;
  bool same = true;
  std::cout << "medians of " << options.runs << " runs, cold = new engine, warm = alpha moved by "
            << number_text(kSliderStep) << " Å²; ratio = CGAL cold / ours cold"
            << (options.request.tetrahedra_only ? "; tetrahedra only" : "") << std::endl;
  print_header();
  for (const std::filesystem::path& file : options.files) {
    InputOptions input_options = options.input;
    input_options.file = file;
    const Input input = open_input(input_options, context);
    clear_progress();
    std::shared_ptr<const BallSet> balls = input.prepared().balls;
    if (options.request.solvent_radius_angstrom != 0) {
      balls = std::make_shared<const BallSet>(
          with_solvent(*balls, options.request.solvent_radius_angstrom));
    }
    for (const int threads : options.threads) {
      for (const double alpha : options.alphas) {
        SessionRequest request = options.request;
        request.alpha_angstrom2 = alpha;
        request.threads = threads;
        rows.push_back(measure(file, balls, request, options.runs, quiet));
        same &= rows.back().same();
        print_row(rows.back());
      }
    }
  }
  if (!options.csv.empty()) {
    AtomicFile file(options.csv);
    file.write(csv(rows));
    file.commit();
  }
  return same ? ExitCode::ok : ExitCode::differs;
}

}  // namespace alphascope::cli

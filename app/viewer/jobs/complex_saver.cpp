// Writes an export in a worker's job, and reports its outcome.
#include "app/viewer/jobs/complex_saver.hpp"

#include <list>
#include <stdexcept>
#include <utility>

#include "core/files/atomic_file.hpp"
#include "core/run/background.hpp"
#include "core/run/work_threads.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

// Writes all of the files or none. Returns a text on their content.
std::string write_files(const Answer& answer, const ComplexHeader& header,
                        const ExportRequest& request, const RunContext& context) {
  const ExportFormatInfo* const format = export_format_of(request.path);
  if (format == nullptr) throw std::runtime_error("No format has this ending.");
  std::list<AtomicFile> files;
  std::vector<AtomicFile*> open;
  for (const fs::path& file : export_files(*format, request.path)) {
    open.push_back(&files.emplace_back(file));
  }
  const ExportSource source{answer, *answer.molecule, *answer.prepared, header, request.colours};
  std::vector<std::string> lines;
  WorkThreads threads(1);  // all other threads stay free for the slider
  threads.run([&] { lines = write_export(source, *format, request.path, open, context); });
  context.cancel.throw_if_cancelled();
  commit_together(open);
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? ": " : "; ") + line;
  return text;
}

}  // namespace

void ComplexSaver::start(std::shared_ptr<const Answer> answer, ComplexHeader header,
                         const ExportRequest& request) {
  if (busy()) {
    throw std::runtime_error("Cannot export " + request.path.string() + ": " + saving_->string() +
                             " is still being written. Wait until it is finished, or cancel it.");
  }
  saving_ = request.path;
  since_ = std::chrono::steady_clock::now();
  // The worker writes it until its job has ended.
  const auto what = std::make_shared<std::string>();
  worker_.submit(
      [this, what, answer = std::move(answer), header = std::move(header),
       request](const RunContext& context) -> Worker::Delivery {
        give_way_to_others(Share::third);
        *what = write_files(*answer, header, request, context);
        return [this, path = request.path, what] {
          outcome_.ended = true;
          outcome_.notice = "Saved " + printable(path.string()) + *what;
          saving_.reset();
        };
      },
      [this, path = request.path, what](const Worker::Failure& failure) {
        outcome_.ended = true;
        if (failure.too_late) {
          outcome_.notice = "Saved " + printable(path.string()) + *what;
        } else if (failure.cancelled) {
          outcome_.notice = "Cancelled: " + printable(path.string()) + " was not written.";
        } else {
          outcome_.error = failure.message;
        }
        saving_.reset();
      });
}

ComplexSaver::Outcome ComplexSaver::poll() {
  worker_.poll();
  return std::exchange(outcome_, {});
}

void ComplexSaver::describe(BusyInfo& info) const {
  info = {};
  if (!busy()) return;
  const Worker::Activity activity = worker_.activity();
  info.active = true;
  info.what = "Exporting " + saving_->filename().string();
  info.step = activity.stage;
  info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
}

}  // namespace alphascope

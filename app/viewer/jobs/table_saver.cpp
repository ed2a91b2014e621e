// Requests the text of a table as a derived result, and writes its file in a worker's job.
#include "app/viewer/jobs/table_saver.hpp"

#include <list>
#include <stdexcept>
#include <utility>

#include "core/files/atomic_file.hpp"
#include "core/run/work_threads.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

// Size of a written piece. Cancelling is possible between two pieces.
constexpr std::size_t kPiece = 1 << 20;  // bytes

void write_text(const std::filesystem::path& path, const std::string& text,
                const CancelToken& cancel) {
  AtomicFile file(path);
  for (std::size_t at = 0; at < text.size(); at += kPiece) {
    cancel.throw_if_cancelled();
    file.write(std::string_view(text).substr(at, kPiece));
  }
  cancel.throw_if_cancelled();
  file.commit();
}

// Writes all of the files or none.
void write_files(const fs::path& path, const std::vector<fs::path>& names, const FileWriter& writer,
                 const RunContext& context) {
  std::list<AtomicFile> files;
  std::vector<AtomicFile*> open;
  for (const fs::path& name : names) open.push_back(&files.emplace_back(name));
  WorkThreads threads(1);  // all other threads stay free for the slider
  threads.run([&] { writer.write(path, open, context); });
  context.cancel.throw_if_cancelled();
  commit_together(open);
}

}  // namespace

TableSaver::TableSaver(std::function<void()> wake) : worker_(std::move(wake)) {}

void TableSaver::start(SaveTableRequest request) {
  if (busy()) {
    throw std::runtime_error("Cannot save " + request.path.string() + ": " +
                             saving_->path.string() +
                             " is still being saved. Wait until it is finished, or cancel it.");
  }
  AtomicFile{request.path};  // an unwritable path must fail before the computation
  saving_ = std::move(request);
  begun_ = writing_ = false;
  since_ = std::chrono::steady_clock::now();
}

void TableSaver::cancel(Store& store) {
  if (!busy()) return;
  if (writing_) return worker_.cancel();  // its outcome tells how the job ended
  store.cancel(definition().id);
  outcome_.notice = "Cancelled: " + saving_->path.string() + " was not written.";
  saving_.reset();
}

const FormatToSave* TableSaver::other_format() const {
  if (saving_->format < kFirstOfMore) return nullptr;
  return &saving_->table->more.at(static_cast<std::size_t>(saving_->format - kFirstOfMore));
}

const AnyDefinition& TableSaver::definition() const {
  if (const FormatToSave* other = other_format()) return other->writer;
  const TableToSave& table = *saving_->table;
  return saving_->format == kJsonFormat ? *table.json : table.csv;
}

void TableSaver::fail(const std::string& why) {
  outcome_.error = why;
  saving_.reset();
  writing_ = false;
}

// Wants the table's text. Fails if the picture changed before all its numbers were ready.
void TableSaver::want(Store& store, const Inputs& inputs) {
  const TableToSave& table = *saving_->table;
  const bool other = inputs.balls_key != table.inputs.balls_key ||
                     inputs.alpha_angstrom2 != table.inputs.alpha_angstrom2 || !inputs.complex;
  if (table.of_the_picture && other) {
    return fail(saving_->path.string() +
                " was not written: the picture has changed before all numbers were there. Save "
                "the table again.");
  }
  // Needed after cancel() of an earlier request.
  if (!std::exchange(begun_, true)) store.begin_again(definition().id);
  const Inputs& of = table.of_the_picture ? inputs : table.inputs;
  if (const FormatToSave* other = other_format()) return want_as(other->writer, store, of);
  want_as(saving_->format == kJsonFormat ? *table.json : table.csv, store, of);
}

template <class T>
void TableSaver::want_as(const Definition<T>& definition, Store& store, const Inputs& inputs) {
  const Derived<T> made = store.want(definition, inputs);
  if (made.ready()) return write(made.value);
  if (made.state == DerivedState::waiting || made.state == DerivedState::running) return;
  fail("Cannot save " + saving_->path.string() + ": " +
       (made.why.empty() ? "its numbers are not there. Save it again." : made.why));
}

void TableSaver::write(const Text& text) {
  submit([path = saving_->path, text](const RunContext& context) {
    write_text(path, *text, context.cancel);
  });
}

void TableSaver::write(const std::shared_ptr<const FileWriter>& writer) {
  submit([path = saving_->path, names = other_format()->files(saving_->path),
          writer](const RunContext& context) { write_files(path, names, *writer, context); });
}

void TableSaver::submit(std::function<void(const RunContext&)> write) {
  writing_ = true;
  worker_.submit(
      [this, path = saving_->path,
       write = std::move(write)](const RunContext& context) -> Worker::Delivery {
        write(context);
        return [this, path] {
          outcome_.notice = "Saved " + printable(path.string());
          saving_.reset();
        };
      },
      [this, path = saving_->path](const Worker::Failure& failure) {
        if (!failure.cancelled) return fail(failure.message);
        outcome_.notice = failure.too_late
                              ? "Saved " + printable(path.string())
                              : "Cancelled: " + printable(path.string()) + " was not written.";
        saving_.reset();
      });
}

TableSaver::Outcome TableSaver::poll(Store& store, const Inputs& inputs) {
  worker_.poll();
  if (busy() && !writing_) want(store, inputs);
  return std::exchange(outcome_, {});
}

void TableSaver::describe(BusyInfo& info) const {
  if (!busy()) return;
  info.active = true;
  info.what = "Saving " + saving_->path.filename().string();
  info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
}

}  // namespace alphascope

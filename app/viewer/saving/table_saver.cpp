// SPDX-License-Identifier: GPL-3.0-or-later
// Requests the text of a table as a derived result, and writes its file in a job.
#include "app/viewer/saving/table_saver.hpp"

#include <stdexcept>
#include <utility>

#include "core/document/store/inputs.hpp"
#include "core/files/atomic_file.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/name_table.hpp"
#include "core/text/printable.hpp"
#include "ui/panels/dialogs/table_to_save.hpp"
#include "ui/running_job.hpp"

namespace alphascope {
namespace {

constexpr const char* kNoTable = "The table cannot be saved";

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

}  // namespace

void TableSaver::start(SaveTableRequest request) {
  if (running()) {
    throw std::runtime_error("Cannot save " + printable(request.path.string()) +
                             ": another table is still being saved. Wait until it is finished, "
                             "or cancel it.");
  }
  AtomicFile{request.path};  // an unwritable path must fail before the computation
  wanted_ = std::move(request);
  begun_ = false;
  since_ = std::chrono::steady_clock::now();
}

std::optional<RunningJob> TableSaver::running() const {
  if (!wanted_) return file_.running();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - since_;
  return RunningJob{JobId::table, title(), {}, -1, seconds.count()};
}

void TableSaver::cancel() {
  if (!wanted_) return file_.cancel();  // its outcome tells how the job ended
  store_.cancel(definition().id);
  news_.notice = "Cancelled: " + printable(wanted_->path.string()) + " was not written.";
  wanted_.reset();
}

const FormatToSave* TableSaver::other_format() const {
  if (wanted_->format < kFirstOfMore) return nullptr;
  return &wanted_->table->more.at(static_cast<std::size_t>(wanted_->format - kFirstOfMore));
}

const AnyDefinition& TableSaver::definition() const {
  if (const FormatToSave* other = other_format()) return other->writer;
  const TableToSave& table = *wanted_->table;
  return wanted_->format == kJsonFormat ? *table.json : table.csv;
}

void TableSaver::fail(const std::string& why) {
  news_.error_title = kNoTable;
  news_.error = why;
  wanted_.reset();
}

// Asks the store for the table's text. Fails if the picture has changed before all numbers were
// ready.
void TableSaver::want() {
  const TableToSave& table = *wanted_->table;
  const bool other = inputs_.balls_key != table.inputs.balls_key ||
                     inputs_.alpha_angstrom2 != table.inputs.alpha_angstrom2 || !inputs_.complex;
  if (table.of_the_picture && other) {
    return fail(printable(wanted_->path.string()) +
                " was not written, because the picture changed before all numbers were ready. "
                "Save the table again.");
  }
  // An earlier request may have been cancelled, and the store makes a cancelled result only after
  // retry().
  if (!std::exchange(begun_, true)) store_.retry(definition().id);
  const Inputs& of = table.of_the_picture ? inputs_ : table.inputs;
  if (const FormatToSave* other_one = other_format()) return want_as(other_one->writer, of);
  want_as(wanted_->format == kJsonFormat ? *table.json : table.csv, of);
}

template <class T>
void TableSaver::want_as(const Definition<T>& definition, const Inputs& inputs) {
  const Derived<T> made = store_.want(definition, inputs);
  if (made.ready()) return write(made.value);
  if (made.state == DerivedState::waiting || made.state == DerivedState::running) return;
  fail("Cannot save " + printable(wanted_->path.string()) + ": " +
       (made.why.empty() ? "its numbers are not ready. Save it again later." : made.why));
}

void TableSaver::write(const Text& text) {
  write([path = wanted_->path, text](const RunContext& context) {
    write_text(path, *text, context.cancel);
  });
}

void TableSaver::write(const std::shared_ptr<const FileWriter>& writer) {
  write([path = wanted_->path, names = other_format()->files(wanted_->path),
         writer](const RunContext& context) {
    write_together(
        names, [&](const std::vector<AtomicFile*>& files) { writer->write(path, files, context); },
        context.cancel);
  });
}

void TableSaver::write(std::function<void(const RunContext&)> how) {
  FileJob::Task task{wanted_->path, title(), kNoTable,
                     [how = std::move(how)](const RunContext& context) {
                       how(context);
                       return std::string();
                     }};
  wanted_.reset();
  file_.start(std::move(task));
}

JobNews TableSaver::poll() {
  JobNews news = file_.poll();
  if (wanted_) want();
  if (!news_.notice.empty() || !news_.error.empty()) news = std::exchange(news_, {});
  return news;
}

}  // namespace alphascope

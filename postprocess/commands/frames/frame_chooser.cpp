// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_chooser.h"

#include "frame_options.h"
#include "frame_rows.h"
#include "frame_stream.h"

#include <algorithm>
#include <fmt/format.h>

namespace ellipsoid::post {

FrameChooser::FrameChooser(const FrameOptions& options, std::string run, WorkerPool* workers,
                           unsigned most_frames,
                           const std::function<Collect(const ChosenFrame&)>& measure)
    : options_(options), run_(std::move(run)), workers_(workers), most_frames_(most_frames),
      measure_(measure) {}
FrameChooser::~FrameChooser() { // threads may still look at it when an exception passes
  for (const Waiting& waiting : waiting_)
    waiting.outcome.wait();
}

int FrameChooser::read(const std::vector<std::string>& files) {
  try {
    FrameStream stream(files);
    while (!is_done_ && next_of(stream))
      choose();
  } catch (const InputError& error) {
    collect_all();
    if (!is_found_) { // what comes behind the frame that was asked for does not matter
      if (!is_unreadable_)
        report_error(error.what());
      code_ = exit_bad_data;
    }
  }
  if (options_.frames == "last" && has_last_)
    hand_over(last_);
  collect_all();
  if (seen_ > 0 && rows_of_last_ == 0 && (options_.frames == "last" || options_.frames == "all"))
    report_warning(
        fmt::format("{}: the last frame, of time step {}, holds no particles", run_, last_step_),
        "last frame of " + run_);
  if (repeated_ > 0)
    report_error(fmt::format("{}: the same in {} more {}", run_, repeated_,
                             repeated_ == 1 ? "frame" : "frames"));
  if (chosen_ == 0 && code_ == exit_good) {
    report_error(no_frame());
    code_ = exit_bad_data;
  }
  return code_;
}

/// Threads read the rows of their frames, but not of the first one: what is wrong with a file is
/// mostly seen there.
bool FrameChooser::next_of(FrameStream& stream) {
  const bool is_enough = is_found_ || (workers_ && seen_ > 0);
  return is_enough ? stream.next_unread(frame_) : stream.next(frame_);
}

/// Why nothing was chosen although nothing is broken.
std::string FrameChooser::no_frame() const {
  if (seen_ == 0)
    return fmt::format("{}: expected at least one frame, found none: the file is empty", run_);
  return fmt::format("{}: expected a frame of time step {}, found {}: {}", run_, options_.frames,
                     seen_ == 1 ? "one frame" : fmt::format("{} frames", seen_),
                     first_step_ == last_step_
                         ? fmt::format("time step {}", first_step_)
                         : fmt::format("time steps {} to {}", first_step_, last_step_));
}

/// What the first frame of a run leaves open, and how it is taken.
void FrameChooser::say_what_is_assumed() const {
  if (!frame_.units.empty() && frame_.units != "si")
    report_warning(fmt::format("{}: the file is in units '{}'; tables and pictures name those of "
                               "'si', the numbers are the file's",
                               run_, frame_.units));
  const bool has_box = frame_.box.upper[0] > frame_.box.lower[0]; // VTK files have none
  if (has_box && frame_.box.boundary.empty() && options_.particles.periodic.empty())
    report_warning(
        fmt::format("{}: the file does not say whether its box repeats (as pp behind BOX "
                    "BOUNDS): taken as one that does not; --periodic says it",
                    run_),
        "sides of " + run_);
}

void FrameChooser::choose() {
  if (seen_ == 0)
    say_what_is_assumed();
  if (seen_ > 0 && frame_.timestep <= last_step_)
    report_warning(fmt::format("{}: frame {} of {} is of time step {}, after one of {}: frames are "
                               "repeated or not in the order of time",
                               run_, frame_.location.frame, frame_.location.file, frame_.timestep,
                               last_step_),
                   "order of " + run_);
  first_step_ = seen_++ == 0 ? frame_.timestep : first_step_;
  last_step_ = frame_.timestep;
  rows_of_last_ = frame_.rows;
  if (options_.frames == "last") {
    std::swap(frame_, last_);
    has_last_ = true;
  } else if (options_.frames == "all") {
    hand_over(frame_);
  } else if (options_.frames == "first") {
    hand_over(frame_);
    is_done_ = true;
  } else if (fmt::format("{}", frame_.timestep) == options_.frames) {
    choose_step();
  }
}

/// The first frame of a time step; a run that was resumed may have written it twice.
void FrameChooser::choose_step() {
  is_done_ = is_found_;
  if (is_found_)
    report_warning(fmt::format("{}: several frames are of time step {}: the first one is taken",
                               run_, options_.frames));
  else
    hand_over(frame_);
  is_found_ = true;
}

/// Measures a frame, now or in a thread.
void FrameChooser::hand_over(Frame& frame) {
  ++chosen_;
  if (workers_) {
    hand_to_workers(frame);
    return;
  }
  Outcome outcome;
  measure(frame, outcome);
  report(outcome);
}

void FrameChooser::hand_to_workers(Frame& frame) {
  // in memory at the same time; a single frame may have more
  constexpr std::size_t most_rows = 1000000, most_text = std::size_t{1} << 28;
  while (!waiting_.empty() &&
         (waiting_.size() >= most_frames_ || rows_waiting_ + frame.rows > most_rows ||
          text_waiting_ + frame.unread.size() > most_text))
    collect_oldest();
  if (free_.empty())
    free_.push_back(std::make_unique<Frame>());
  std::unique_ptr<Frame> own = std::move(free_.back());
  free_.pop_back();
  std::swap(*own, frame);
  rows_waiting_ += own->rows;
  const std::size_t text = own->unread.size(); // the thread will change it
  text_waiting_ += text;
  Frame* const shared = own.get();
  std::future<Outcome> outcome =
      workers_->submit<Outcome>([this, shared] { return outcome_of(*shared); });
  waiting_.push_back({std::move(outcome), std::move(own), text});
}

/// In a thread: reads the rows, and measures.
FrameChooser::Outcome FrameChooser::outcome_of(Frame& frame) const {
  Outcome outcome;
  try {
    read_rows(frame);
  } catch (const InputError& error) {
    outcome.error = error.what();
    outcome.is_unreadable = true;
    return outcome;
  }
  const KeepWarnings keep(outcome.warnings);
  measure(frame, outcome);
  return outcome;
}

void FrameChooser::measure(const Frame& frame, Outcome& outcome) const {
  try {
    const ParticleSet set = particles_of(frame, options_.particles);
    for (const std::string& remark : set.remarks)
      report_warning(run_ + ": " + remark, remark + run_);
    outcome.collect = measure_({run_, frame, set});
  } catch (const InputError& error) {
    const std::string what = error.what();
    outcome.reason = what;
    const bool names_file = what.find(frame.location.file) != std::string::npos;
    outcome.error = names_file ? what
                               : fmt::format("{}: frame {} (time step {}): {}", frame.location.file,
                                             frame.location.frame, frame.timestep, what);
  }
}

void FrameChooser::report(const Outcome& outcome) {
  if (is_unreadable_)
    return;
  for (const Warning& warning : outcome.warnings)
    print(warning);
  if (outcome.collect)
    outcome.collect();
  if (outcome.error.empty())
    return;
  if (outcome.reason.empty() || reasons_.insert(outcome.reason).second)
    report_error(outcome.error);
  else
    ++repeated_;
  code_ = exit_bad_data;
  is_unreadable_ = outcome.is_unreadable;
  is_done_ = is_done_ || is_unreadable_;
}

void FrameChooser::collect_oldest() {
  Waiting oldest = std::move(waiting_.front());
  waiting_.pop_front();
  rows_waiting_ -= oldest.frame->rows;
  text_waiting_ -= oldest.text;
  report(oldest.outcome.get());
  free_.push_back(std::move(oldest.frame));
}

void FrameChooser::collect_all() {
  while (!waiting_.empty())
    collect_oldest();
}

} // namespace ellipsoid::post

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
    : m_options(options), m_run(std::move(run)), m_workers(workers), m_most_frames(most_frames),
      m_measure(measure) {}
FrameChooser::~FrameChooser() { // threads may still look at it when an exception passes
  for (const Waiting& waiting : m_waiting)
    waiting.outcome.wait();
}

int FrameChooser::read(const std::vector<std::string>& files) {
  try {
    FrameStream stream(files);
    while (!m_is_done && next_of(stream))
      choose();
  } catch (const InputError& error) {
    collect_all();
    if (!m_is_unreadable)
      report_error(error.what());
    m_code = exit_bad_data;
  }
  if (m_options.frames == "last" && m_has_last) {
    if (m_last.rows == 0)
      report_warning(fmt::format("{}: the last frame, of time step {}, holds no particles", m_run,
                                 m_last.timestep));
    hand_over(m_last);
  }
  collect_all();
  if (m_repeated > 0)
    report_error(fmt::format("{}: the same in {} more {}", m_run, m_repeated,
                             m_repeated == 1 ? "frame" : "frames"));
  if (m_chosen == 0 && m_code == exit_good) {
    report_error(no_frame());
    m_code = exit_bad_data;
  }
  return m_code;
}

/// Threads read the rows of their frames, but not of the first one: what is wrong with a file is
/// mostly seen there.
bool FrameChooser::next_of(FrameStream& stream) {
  return m_workers && m_seen > 0 ? stream.next_unread(m_frame) : stream.next(m_frame);
}

/// Why nothing was chosen although nothing is broken.
std::string FrameChooser::no_frame() const {
  if (m_seen == 0)
    return fmt::format("{}: expected at least one frame, found none: the file is empty", m_run);
  return fmt::format("{}: expected a frame of time step {}, found {}: {}", m_run, m_options.frames,
                     m_seen == 1 ? "one frame" : fmt::format("{} frames", m_seen),
                     m_first_step == m_last_step
                         ? fmt::format("time step {}", m_first_step)
                         : fmt::format("time steps {} to {}", m_first_step, m_last_step));
}

void FrameChooser::choose() {
  if (m_seen == 0 && !m_frame.units.empty() && m_frame.units != "si")
    report_warning(fmt::format("{}: the file is in units '{}'; tables and pictures name those of "
                               "'si', the numbers are the file's",
                               m_run, m_frame.units));
  if (m_seen > 0 && m_frame.timestep <= m_last_step)
    report_warning(fmt::format("{}: frame {} of {} is of time step {}, after one of {}: frames are "
                               "repeated or not in the order of time",
                               m_run, m_frame.location.frame, m_frame.location.file,
                               m_frame.timestep, m_last_step),
                   "order of " + m_run);
  m_first_step = m_seen++ == 0 ? m_frame.timestep : m_first_step;
  m_last_step = m_frame.timestep;
  if (m_options.frames == "last") {
    std::swap(m_frame, m_last);
    m_has_last = true;
  } else if (m_options.frames == "all") {
    hand_over(m_frame);
  } else if (m_options.frames == "first" ||
             fmt::format("{}", m_frame.timestep) == m_options.frames) {
    hand_over(m_frame);
    m_is_done = true;
  }
}

/// Measures a frame, now or in a thread.
void FrameChooser::hand_over(Frame& frame) {
  ++m_chosen;
  if (m_workers) {
    hand_to_workers(frame);
    return;
  }
  Outcome outcome;
  measure(frame, outcome);
  report(outcome);
}

void FrameChooser::hand_to_workers(Frame& frame) {
  // in memory at the same time, or a single frame
  constexpr std::size_t most_rows = 1000000, most_text = std::size_t{1} << 28;
  while (!m_waiting.empty() &&
         (m_waiting.size() >= m_most_frames || m_rows_waiting + frame.rows > most_rows ||
          m_text_waiting + frame.unread.size() > most_text))
    collect_oldest();
  if (m_free.empty())
    m_free.push_back(std::make_unique<Frame>());
  std::unique_ptr<Frame> own = std::move(m_free.back());
  m_free.pop_back();
  std::swap(*own, frame);
  m_rows_waiting += own->rows;
  const std::size_t text = own->unread.size(); // the thread will change it
  m_text_waiting += text;
  Frame* const shared = own.get();
  std::future<Outcome> outcome =
      m_workers->submit<Outcome>([this, shared] { return outcome_of(*shared); });
  m_waiting.push_back({std::move(outcome), std::move(own), text});
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
    const ParticleSet set = particles_of(frame, m_options.particles);
    for (const std::string& remark : set.remarks)
      report_warning(m_run + ": " + remark, remark + m_run);
    outcome.collect = m_measure({m_run, frame, set});
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
  if (m_is_unreadable)
    return;
  for (const Warning& warning : outcome.warnings)
    print(warning);
  if (outcome.collect)
    outcome.collect();
  if (outcome.error.empty())
    return;
  if (outcome.reason.empty() || m_reasons.insert(outcome.reason).second)
    report_error(outcome.error);
  else
    ++m_repeated;
  m_code = exit_bad_data;
  m_is_unreadable = outcome.is_unreadable;
  m_is_done = m_is_done || m_is_unreadable;
}

void FrameChooser::collect_oldest() {
  Waiting oldest = std::move(m_waiting.front());
  m_waiting.pop_front();
  m_rows_waiting -= oldest.frame->rows;
  m_text_waiting -= oldest.text;
  report(oldest.outcome.get());
  m_free.push_back(std::move(oldest.frame));
}

void FrameChooser::collect_all() {
  while (!m_waiting.empty())
    collect_oldest();
}

} // namespace ellipsoid::post

// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#pragma once

#include "frame_loop.h"
#include "frame_options.h"
#include "messages.h"
#include "worker_pool.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace ellipsoid::post {

class FrameStream;

/// The frames of one run that the options choose, measured one after the other or several at a
/// time.
class FrameChooser {
 public:
  /// @param[in] workers none: frames are measured one after the other
  /// @param[in] most_frames that are measured at a time
  FrameChooser(const FrameOptions& options, std::string run, WorkerPool* workers,
               unsigned most_frames, const std::function<Collect(const ChosenFrame&)>& measure);
  ~FrameChooser();
  FrameChooser(const FrameChooser&) = delete;
  FrameChooser& operator=(const FrameChooser&) = delete;

  /// @return exit code
  int read(const std::vector<std::string>& files);

 private:
  /// What became of a frame: an error message, or what to do with its measures.
  struct Outcome {
    std::string error, reason; ///< the reason is the error without its location
    Collect collect;
    bool is_unreadable = false; ///< what follows in the file does not count
    std::vector<Warning> warnings;
  };
  struct Waiting {
    std::future<Outcome> outcome;
    std::unique_ptr<Frame> frame;
    std::size_t text; ///< size of its rows as text (bytes)
  };

  bool next_of(FrameStream& stream);
  std::string no_frame() const;
  void say_what_is_assumed() const;
  void choose();
  void choose_step();
  void hand_over(Frame& frame);
  void hand_to_workers(Frame& frame);
  Outcome outcome_of(Frame& frame) const;
  void measure(const Frame& frame, Outcome& outcome) const;
  void report(const Outcome& outcome);
  void collect_oldest();
  void collect_all();

  const FrameOptions& options_;
  std::string run_;
  WorkerPool* workers_;
  unsigned most_frames_;
  const std::function<Collect(const ChosenFrame&)>& measure_;
  Frame frame_, last_;
  bool has_last_ = false, is_done_ = false;
  bool is_found_ = false;             ///< the frame of the time step that was asked for
  bool is_unreadable_ = false;        ///< rows of a frame that the threads have read
  std::size_t chosen_ = 0, seen_ = 0; ///< frames
  std::size_t rows_of_last_ = 0;      ///< of the frames that were seen
  std::size_t rows_waiting_ = 0, text_waiting_ = 0; ///< rows, bytes
  std::int64_t first_step_ = 0, last_step_ = 0;     ///< of the frames that were seen
  std::deque<Waiting> waiting_;              ///< frames that are being measured, oldest first
  std::vector<std::unique_ptr<Frame>> free_; ///< whose memory is used again
  std::set<std::string> reasons_;            ///< of errors that were reported
  std::size_t repeated_ = 0;                 ///< errors for a reason that was reported already
  int code_ = exit_good;
};

} // namespace ellipsoid::post

// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_options.h"

#include "frame_rows.h"
#include "frame_stream.h"
#include "worker_pool.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace ellipsoid::post {
namespace {

RunGrouping grouping_of(const FrameOptions& options) {
  return options.one_run     ? RunGrouping::one_run
         : options.each_file ? RunGrouping::each_file
                             : RunGrouping::automatic;
}

std::string check_frames(const std::string& word) {
  if (word == "last" || word == "first" || word == "all")
    return "";
  if (!word.empty() && word.find_first_not_of("0123456789") == std::string::npos)
    return "";
  return fmt::format("--frame \"{}\": allowed are last, first, all, or a time step", word);
}

/// A warning; of several with the same `once_for` only the first is printed.
struct Warning {
  std::string message, once_for;
};

/// What became of a frame: an error message, or what to do with its measures.
struct Outcome {
  std::string error;
  Collect collect;
  bool is_unreadable = false; ///< what follows in the file does not count
  std::vector<Warning> warnings;
};

void print(const Warning& warning) {
  static std::set<std::string> known;
  if (warning.once_for.empty() || known.insert(warning.once_for).second)
    fmt::print(stderr, "warning: {}\n", warning.message);
}

/// Where the warnings of this thread wait until those of the frames before have been printed.
thread_local std::vector<Warning>* waiting_warnings = nullptr;

/// The frames of one run that the options choose, several at a time.
class FrameChooser {
 public:
  FrameChooser(const FrameOptions& options, std::string run, WorkerPool* workers,
               unsigned most_frames, const std::function<Collect(const ChosenFrame&)>& measure)
      : m_options(options), m_run(std::move(run)), m_workers(workers), m_most_frames(most_frames),
        m_measure(measure) {}
  ~FrameChooser() { // threads may still look at it when an exception passes
    for (const Waiting& waiting : m_waiting)
      waiting.outcome.wait();
  }
  FrameChooser(const FrameChooser&) = delete;
  FrameChooser& operator=(const FrameChooser&) = delete;

  /// @return exit code
  int read(const std::vector<std::string>& files) {
    try {
      FrameStream stream(files);
      while (!m_is_done && next_of(stream))
        take();
    } catch (const InputError& error) {
      collect_all();
      if (!m_is_unreadable)
        report_error(error.what());
      m_code = exit_bad_data;
    }
    if (m_options.frames == "last" && m_has_last)
      hand_over(m_last);
    collect_all();
    if (m_chosen == 0 && m_code == exit_good) {
      report_error(no_frame());
      m_code = exit_bad_data;
    }
    return m_code;
  }

 private:
  /// Threads read the rows of their frames, but not of the first one: what is wrong with a file is
  /// mostly seen there.
  bool next_of(FrameStream& stream) {
    return m_workers && m_seen > 0 ? stream.next_unread(m_frame) : stream.next(m_frame);
  }

  /// Why nothing was chosen although nothing is broken.
  std::string no_frame() const {
    if (m_seen == 0)
      return fmt::format("{}: expected at least one frame, found none: the file is empty", m_run);
    return fmt::format("{}: expected a frame of time step {}, found {}: {}", m_run,
                       m_options.frames,
                       m_seen == 1 ? "one frame" : fmt::format("{} frames", m_seen),
                       m_first_step == m_last_step
                           ? fmt::format("time step {}", m_first_step)
                           : fmt::format("time steps {} to {}", m_first_step, m_last_step));
  }

  void take() {
    if (m_seen == 0 && !m_frame.units.empty() && m_frame.units != "si")
      report_warning(fmt::format("{}: the file is in units '{}'; tables and pictures name those of "
                                 "'si', the numbers are the file's",
                                 m_run, m_frame.units));
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
  void hand_over(Frame& frame) {
    // in memory at the same time, or a single frame
    constexpr std::size_t most_rows = 1000000, most_text = std::size_t{1} << 28;
    ++m_chosen;
    if (!m_workers) {
      Outcome outcome;
      measure(frame, outcome);
      finish(outcome);
      return;
    }
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
  Outcome outcome_of(Frame& frame) const {
    Outcome outcome;
    try {
      read_rows(frame);
    } catch (const InputError& error) {
      outcome.error = error.what();
      outcome.is_unreadable = true;
      return outcome;
    }
    waiting_warnings = &outcome.warnings;
    measure(frame, outcome);
    waiting_warnings = nullptr;
    return outcome;
  }

  void measure(const Frame& frame, Outcome& outcome) const {
    try {
      outcome.collect = m_measure({m_run, frame, particles_of(frame, m_options.particles)});
    } catch (const InputError& error) {
      const std::string what = error.what();
      const bool names_place = what.find(frame.place.file) != std::string::npos;
      outcome.error = names_place ? what
                                  : fmt::format("{}: frame {} (time step {}): {}", frame.place.file,
                                                frame.place.frame, frame.timestep, what);
    }
  }

  void finish(const Outcome& outcome) {
    if (m_is_unreadable)
      return;
    for (const Warning& warning : outcome.warnings)
      print(warning);
    if (outcome.collect)
      outcome.collect();
    if (outcome.error.empty())
      return;
    report_error(outcome.error);
    m_code = exit_bad_data;
    m_is_unreadable = outcome.is_unreadable;
    m_is_done = m_is_done || m_is_unreadable;
  }

  void collect_oldest() {
    Waiting oldest = std::move(m_waiting.front());
    m_waiting.pop_front();
    m_rows_waiting -= oldest.frame->rows;
    m_text_waiting -= oldest.text;
    finish(oldest.outcome.get());
    m_free.push_back(std::move(oldest.frame));
  }
  void collect_all() {
    while (!m_waiting.empty())
      collect_oldest();
  }

  struct Waiting {
    std::future<Outcome> outcome;
    std::unique_ptr<Frame> frame;
    std::size_t text; ///< that its rows were (bytes)
  };

  const FrameOptions& m_options;
  std::string m_run;
  WorkerPool* m_workers; ///< none: frames are measured one after the other
  unsigned m_most_frames;
  const std::function<Collect(const ChosenFrame&)>& m_measure;
  Frame m_frame, m_last;
  bool m_has_last = false, m_is_done = false;
  bool m_is_unreadable = false;         ///< rows of a frame that was given to the threads
  std::size_t m_chosen = 0, m_seen = 0; ///< frames
  std::size_t m_rows_waiting = 0, m_text_waiting = 0; ///< rows, bytes
  std::int64_t m_first_step = 0, m_last_step = 0;     ///< of the frames that were seen
  std::deque<Waiting> m_waiting;              ///< frames that are being measured, oldest first
  std::vector<std::unique_ptr<Frame>> m_free; ///< whose memory is used again
  int m_code = exit_good;
};

} // namespace

CLI::Validator check_by(std::function<void(const std::string&)> parse) {
  return CLI::Validator(
      [parse = std::move(parse)](const std::string& word) -> std::string {
        try {
          parse(word);
        } catch (const std::exception& error) {
          return error.what();
        }
        return "";
      },
      "");
}

void add_output_options(CLI::App& command, FrameOptions& options) {
  command.add_option("--csv", options.csv,
                     "write the table as CSV to a file, \"-\": to standard output");
  command.add_option("--json", options.json,
                     "write the table as JSON to a file, \"-\": to standard output");
  command.add_flag("--quiet", options.quiet, "print no table for people");
}

void add_frame_options(CLI::App& command, FrameOptions& options) {
  command
      .add_option(
          "runs", options.runs,
          "dump files (.gz too, \"-\": standard input); files that differ only in their time "
          "step are one run, and so is a quoted pattern 'dump.*'; every other file is a run")
      ->required();
  auto* one_run = command.add_flag("--one-run", options.one_run, "all files together are one run");
  command.add_flag("--each-file", options.each_file, "every file is a run of its own")
      ->excludes(one_run);
  command.add_option("--frame", options.frames, "last, first, all, or the time step of one frame")
      ->check(CLI::Validator(check_frames, "FRAME"))
      ->capture_default_str();
  command
      .add_option("--semiaxes", options.particles.semiaxes,
                  "a b c of all particles, for files without columns shapex shapey shapez")
      ->expected(3)
      ->check(CLI::PositiveNumber);
  command
      .add_option("--subspheres", options.particles.subspheres,
                  "number N of sub-spheres of all particles, for files without f_subspheres")
      ->check(CLI::Range(0, largest_sphere_count));
  command
      .add_option("--spacing", options.spacing_word,
                  "spacing of these sub-spheres: paper, minimax_outline, minimax_area")
      ->capture_default_str()
      ->check(check_by([&options](const std::string& word) {
        options.particles.spacing = sphere_spacing_from_word(word);
      }));
  command
      .add_option("--size-scale", options.particles.sphere_size_scale,
                  "factor on all sizes of the file (0.5 where it holds diameters)")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option("--threads", options.threads,
                  "frames measured at the same time with --frame all (0: one per processor)")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  add_output_options(command, options);
}

void add_plane_options(CLI::App& command, PlaneOptions& options) {
  command.add_option("--wall", options.wall, "abscissa x of the wall on the left")
      ->capture_default_str();
  command.add_flag("--no-wall", options.no_wall, "a free, two-sided pile");
  command.add_option("--floor", options.pile.floor, "ordinate y of the floor")
      ->capture_default_str();
  command.add_option("--section", options.pile.section, "z of the plane (default: mean z)");
  command
      .add_option("--cut-bottom", options.pile.cut_bottom,
                  "share of the height left out of the fit at the bottom")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  command
      .add_option("--cut-top", options.pile.cut_top,
                  "share of the height left out of the fit at the top")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  command
      .add_option("--columns", options.pile.column_spacing,
                  "distance of the columns of the free surface, in mean smallest semi-axes b")
      ->check(CLI::Range(1e-4, 1.0))
      ->capture_default_str();
  command
      .add_option("--cluster-gap", options.pile.cluster_gap,
                  "particles this close (in b) belong to one pile")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  command
      .add_option("--outline", options.outline,
                  "true: discs of multi-sphere particles (MS); ellipse: always the "
                  "circumscribed ellipse (MS ellipse)")
      ->check(CLI::IsMember({"true", "ellipse"}))
      ->capture_default_str();
}

PileOptions plane_settings(const PlaneOptions& options) {
  PileOptions pile = options.pile;
  pile.wall = options.no_wall ? std::nullopt : std::optional<double>(options.wall);
  pile.outline =
      options.outline == "ellipse" ? OutlineKind::smooth_ellipse : OutlineKind::true_shape;
  return pile;
}

int for_measured_frames(const FrameOptions& options,
                        const std::function<Collect(const ChosenFrame&)>& measure) {
  const unsigned threads =
      options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  int code = exit_good;
  try {
    std::unique_ptr<WorkerPool> workers;
    if (threads > 1 && options.frames == "all")
      workers = std::make_unique<WorkerPool>(threads);
    for (const Run& run : runs_of(options.runs, grouping_of(options)))
      code = std::max(
          code,
          FrameChooser(options, run.name, workers.get(), 2 * threads, measure).read(run.files));
  } catch (const InputError& error) {
    report_error(error.what());
    code = exit_bad_data;
  }
  return code;
}

int for_chosen_frames(const FrameOptions& options,
                      const std::function<void(const ChosenFrame&)>& visit) {
  FrameOptions one_by_one = options;
  one_by_one.threads = 1;
  return for_measured_frames(one_by_one, [&visit](const ChosenFrame& chosen) {
    visit(chosen);
    return Collect();
  });
}

Row frame_row(const ChosenFrame& chosen) {
  return {{"run", "run", "", chosen.run}, {"timestep", "time step", "", chosen.frame.timestep}};
}

bool prints_text(const FrameOptions& options) {
  return !options.quiet && options.csv != "-" && options.json != "-";
}

void write_table(const FrameOptions& options, const Table& table) {
  if (prints_text(options) && !table.rows.empty())
    write_text("-", as_text(table));
  if (!options.csv.empty())
    write_text(options.csv, as_csv(table));
  if (!options.json.empty())
    write_text(options.json, as_json(table));
}

void report_error(const std::string& message) { fmt::print(stderr, "error: {}\n", message); }

void report_warning(const std::string& message, const std::string& once_for) {
  if (waiting_warnings)
    waiting_warnings->push_back({message, once_for});
  else
    print({message, once_for});
}

} // namespace ellipsoid::post

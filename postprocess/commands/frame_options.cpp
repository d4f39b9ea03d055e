// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_options.h"

#include "frame_stream.h"

#include <algorithm>
#include <fmt/format.h>

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

/// The frames of one run that the options choose.
class FrameChooser {
 public:
  FrameChooser(const FrameOptions& options, std::string run,
               const std::function<void(const ChosenFrame&)>& visit)
      : m_options(options), m_run(std::move(run)), m_visit(visit) {}

  /// @return exit code
  int read(const std::vector<std::string>& files) {
    int code = exit_good;
    try {
      FrameStream stream(files);
      while (!m_is_done && stream.next(m_frame))
        take();
    } catch (const InputError& error) {
      report_error(error.what());
      code = exit_bad_data;
    }
    if (m_options.frames == "last" && m_has_last)
      code = std::max(code, hand_over(m_last));
    if (m_visited == 0 && code == exit_good) {
      report_error(fmt::format("{}: no frame {}", m_run,
                               m_options.frames == "all" ? "in it" : m_options.frames));
      code = exit_bad_data;
    }
    return std::max(code, m_visit_code);
  }

 private:
  void take() {
    if (m_options.frames == "last") {
      std::swap(m_frame, m_last);
      m_has_last = true;
    } else if (m_options.frames == "all") {
      m_visit_code = std::max(m_visit_code, hand_over(m_frame));
    } else if (m_options.frames == "first" ||
               fmt::format("{}", m_frame.timestep) == m_options.frames) {
      m_visit_code = std::max(m_visit_code, hand_over(m_frame));
      m_is_done = true;
    }
  }

  int hand_over(const Frame& frame) {
    ++m_visited;
    try {
      m_visit({m_run, frame, particles_of(frame, m_options.particles)});
    } catch (const InputError& error) {
      const std::string what = error.what();
      const bool names_place = what.find(frame.place.file) != std::string::npos;
      report_error(names_place ? what
                               : fmt::format("{}: frame {} (time step {}): {}", frame.place.file,
                                             frame.place.frame, frame.timestep, what));
      return exit_bad_data;
    }
    return exit_good;
  }

  const FrameOptions& m_options;
  std::string m_run;
  const std::function<void(const ChosenFrame&)>& m_visit;
  Frame m_frame, m_last;
  bool m_has_last = false, m_is_done = false;
  std::size_t m_visited = 0;
  int m_visit_code = exit_good;
};

} // namespace

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
      ->check([&options](const std::string& word) -> std::string {
        try {
          options.particles.spacing = sphere_spacing_from_word(word);
        } catch (const std::invalid_argument& error) {
          return error.what();
        }
        return "";
      });
  command
      .add_option("--size-scale", options.particles.sphere_size_scale,
                  "factor on all sizes of the file (0.5 where it holds diameters)")
      ->check(CLI::PositiveNumber)
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

int for_chosen_frames(const FrameOptions& options,
                      const std::function<void(const ChosenFrame&)>& visit) {
  int code = exit_good;
  try {
    for (const Run& run : runs_of(options.runs, grouping_of(options)))
      code = std::max(code, FrameChooser(options, run.name, visit).read(run.files));
  } catch (const InputError& error) {
    report_error(error.what());
    code = exit_bad_data;
  }
  return code;
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

void report_warning(const std::string& message) { fmt::print(stderr, "warning: {}\n", message); }

} // namespace ellipsoid::post

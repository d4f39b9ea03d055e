// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "input_error.h"
#include "option_checks.h"
#include "picture_options.h"
#include "render_pile.h"
#include "render_space.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace ellipsoid::post {
namespace {

struct FilmOptions {
  RenderOptions plane; ///< with what both kinds share
  RenderSpaceOptions space;
  std::string output;
  double per_second = 25.0;
  bool is_in_space = false;
};

/// A folder that is there as long as the object lives.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "ellipsoid-film-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw InputError(fmt::format("{}: no folder for the pictures can be made: {}", name,
                                   std::strerror(errno)));
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Runs a program by its name, without a shell. @return its exit status, 127 where it is not there
int run_program(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  constexpr int not_there = 127;
  pid_t child = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
    return not_there;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      return not_there;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool is_pictures(const std::string& name) { return name.find('*') != std::string::npos; }

/// The pictures of all frames, their names by a pattern.
int render_frames(const FilmOptions& options, const std::string& names) {
  if (options.is_in_space) {
    RenderSpaceOptions space = options.space;
    space.frames = options.plane.frames;
    space.output = names;
    space.colour_by = options.plane.picture.colour_by;
    space.colour_range = options.plane.colour_range;
    space.title = options.plane.picture.title;
    space.view.width = options.plane.picture.width;
    return render_spaces(space);
  }
  RenderOptions plane = options.plane;
  plane.output = names;
  return render_piles(plane);
}

/// A path for a pattern: signs that the pattern would interpret are escaped.
std::string literal_in_pattern(const std::string& path) {
  std::string text;
  for (const char letter : path)
    text += (std::string("*?[]{}\\").find(letter) == std::string::npos ? "" : "\\") +
            std::string(1, letter);
  return text;
}

int join_frames(const FilmOptions& options, const std::string& folder) {
  // what most players want: colours of half the resolution, and so even sizes
  const int status = run_program(
      {"ffmpeg", "-loglevel", "error", "-y", "-framerate", fmt::format("{}", options.per_second),
       "-pattern_type", "glob", "-i", literal_in_pattern(folder) + "/film_*.png", "-vf",
       "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", options.output});
  if (status != 0)
    throw InputError(
        fmt::format("{}: ffmpeg ended with status {}, see what it says", options.output, status));
  fmt::print(stderr, "film: {}\n", options.output);
  return exit_good;
}

int make_film(const FilmOptions& options) {
  if (is_pictures(options.output))
    return render_frames(options, options.output);
  if (run_program({"ffmpeg", "-loglevel", "quiet", "-version"}) != 0)
    throw InputError(
        "ffmpeg, which joins the pictures, is not installed (Debian: ffmpeg): install it, "
        "or give a name such as 'film_*.png' for numbered pictures");
  const TemporaryFolder folder;
  const int code = render_frames(options, folder.path() + "/film_*.png");
  if (std::filesystem::is_empty(folder.path()))
    return code == exit_good ? exit_bad_data : code;
  return std::max(code, join_frames(options, folder.path()));
}

void add_view_options(CLI::App& command, FilmOptions& options) {
  CLI::Option* in_space =
      command.add_flag("--space", options.is_in_space,
                       "particles in space as render3d draws them; else piles in "
                       "the plane as render does");
  command.add_option("--width", options.plane.picture.width, "pixels")
      ->check(CLI::Range(100, 20000))
      ->capture_default_str();
  command.add_option("--height", options.space.view.height, "pixels, of --space")
      ->check(CLI::Range(16, 10000))
      ->capture_default_str()
      ->needs(in_space);
  command.add_option("--azimuth", options.space.view.azimuth_deg, "as of render3d (deg)")
      ->capture_default_str()
      ->needs(in_space);
  command.add_option("--elevation", options.space.view.elevation_deg, "as of render3d (deg)")
      ->check(CLI::Range(-90.0, 90.0))
      ->capture_default_str()
      ->needs(in_space);
  command.add_option("--up", options.space.up, "as of render3d")
      ->check(CLI::IsMember({"y", "z"}))
      ->needs(in_space);
  CLI::Option* view =
      command.add_option("--view", options.plane.view, "x0 x1 y0 y1: shows this part of the plane");
  view->expected(4)->excludes(in_space);
  command
      .add_option("--part", options.space.part,
                  "x0 x1 y0 y1 z0 z1: fits this part of the space into the picture")
      ->expected(6)
      ->needs(in_space);
}

} // namespace

void add_film_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<FilmOptions>();
  options->plane.frames.frames = "all";
  CLI::App* command = program.add_subcommand(
      "film", "a film of all frames, through ffmpeg, or its numbered pictures");
  command->footer(
      "All pictures have one size, one view and one range of colours: those that all frames "
      "together take, or as given. Frames without particles are left out with a remark.");
  add_frame_options(*command, options->plane.frames, FrameUse::one_series);
  add_plane_options(*command, options->plane.plane);
  add_fit_options(*command, options->plane.plane);
  command
      ->add_option("--output,-o", options->output,
                   "the film, for example film.mp4; or numbered pictures, 'film_*.png'")
      ->required();
  command->add_option("--rate", options->per_second, "frames per second")
      ->check(CLI::Range(0.1, 240.0))
      ->capture_default_str();
  add_view_options(*command, *options);
  add_colour_options(*command, options->plane.picture.colour_by, options->plane.colour_range);
  command->add_option("--title", options->plane.picture.title, "words above each picture");
  command->add_flag("--no-fit", options->plane.no_fit, "without the line A-B");
  command->callback([command, options, &exit_code] {
    if (options->plane.picture.colour_by.empty())
      refuse_without_effect(*command, {"--colour-range"}, "without --colour");
    if (is_pictures(options->output))
      refuse_without_effect(*command, {"--rate"}, "on numbered pictures");
    if (options->is_in_space || options->plane.no_fit)
      refuse_without_effect(*command, fit_options, "with --space or --no-fit");
    if (options->is_in_space)
      refuse_without_effect(*command, plane_options, "with --space");
    if (options->is_in_space)
      refuse_without_effect(*command, {"--no-fit"}, "with --space");
    require_ascending_pairs("--colour-range", options->plane.colour_range);
    require_ascending_pairs("--view", options->plane.view);
    require_ascending_pairs("--part", options->space.part);
    exit_code = make_film(*options);
  });
}

} // namespace ellipsoid::post

// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "report_runs.h"

#include "frame_loop.h"
#include "gravity_options.h"
#include "natural_order.h"
#include "paper_parameters.h"
#include "picture_options.h"
#include "report_page.h"
#include "report_pictures.h"
#include "run_log.h"
#include "run_state.h"
#include "view_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

namespace fs = std::filesystem;

bool lies_in_a_plane(const ParticleSet& set) {
  constexpr double noticeable = 0.01; // of the smallest semi-axis, as for piles
  return std::all_of(set.particles.begin(), set.particles.end(), [&](const Particle& p) {
    return std::abs(p.centre.z - set.particles.front().centre.z) <=
           2.0 * noticeable * p.smallest_axis();
  });
}

Row log_row(const std::string& run, const RunLog& log) {
  Row row = {{"run", "run", "", run}};
  if (!log.version.empty())
    row.push_back({"version", "version", "", log.version});
  if (log.ranks > 0) { // a run that has not ended says nothing of its time
    row.push_back({"ranks", "ranks", "", static_cast<std::int64_t>(log.ranks)});
    row.push_back({"loop_time_s", "run time", "s", log.loop_time});
  }
  for (const auto& [fix, seed] : log.seeds)
    row.push_back({"seed_" + fix, "seed of fix " + fix, "", seed});
  for (const auto& [name, value] : log.variables)
    row.push_back({"variable_" + name, name, "", value});
  return row;
}

/// A page of `view` in the folder of a dump, relative to the report; nothing where there is none.
std::string view_page_beside(const std::string& dump, const std::string& report) {
  std::error_code error;
  std::vector<std::string> found;
  const fs::path folder = fs::path(dump).parent_path();
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, error))
    if (entry.path().extension() == ".html" && is_view_page(entry.path().string()))
      found.push_back(relative_to_report(entry.path().string(), report));
  return found.empty() ? "" : *std::min_element(found.begin(), found.end());
}

ReportedRun reported(const ReportOptions& options, const ChosenFrame& chosen) {
  ReportedRun run;
  const bool is_pile = options.plane.pile.section || lies_in_a_plane(chosen.set);
  run.title = frame_title(chosen);
  if (is_pile) {
    run.pile = ReportedPile{measure_pile(options, chosen), chosen.set};
    run.measures = run.pile->measured.row;
  } else {
    run.measures = frame_row(chosen);
    run.measures.push_back(
        {"particles", "particles", "", static_cast<std::int64_t>(chosen.set.particles.size())});
    append_completeness(run.measures, chosen);
    run.picture = picture_in_space(turned_upright(chosen.set, up_direction("", chosen).axis),
                                   run.title, count_of_runs(options.frames));
  }
  if (const RunLog* log = log_of(chosen)) {
    run.log = log_row(chosen.run, *log);
    if (is_pile)
      run.differences = differences_from_paper(*log);
  }
  run.view_page = view_page_beside(chosen.frame.location.file, options.output);
  return run;
}

} // namespace

std::vector<std::string> with_folders_opened(const std::vector<std::string>& arguments) {
  std::vector<std::string> result;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!fs::is_directory(argument, error)) {
      result.push_back(argument);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(argument, error)) {
      const std::string name = entry.path().filename().string();
      if (name.find(".dump") != std::string::npos && entry.is_regular_file(error))
        found.push_back(entry.path().string());
    }
    if (found.empty())
      throw InputError(fmt::format("{}: no file *.dump in this folder", argument));
    std::sort(found.begin(), found.end(), natural_less);
    result.insert(result.end(), found.begin(), found.end());
  }
  return result;
}

std::vector<ReportedRun> reported_runs(const ReportOptions& options, int& exit_code) {
  std::vector<ReportedRun> runs;
  exit_code = for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) {
    runs.push_back(reported(options, chosen));
  });
  std::stable_sort(runs.begin(), runs.end(), [](const ReportedRun& p, const ReportedRun& q) {
    return natural_less(p.name(), q.name());
  });
  return runs;
}

std::map<std::string, std::string> short_names(const std::vector<ReportedRun>& runs) {
  if (runs.empty())
    return {};
  std::vector<fs::path> paths;
  for (const ReportedRun& run : runs)
    paths.emplace_back(run.name());
  const auto all_same = [&](const auto& part) {
    return std::all_of(paths.begin(), paths.end(),
                       [&](const fs::path& path) { return part(path) == part(paths.front()); });
  };
  const bool drops_file = paths.size() > 1 && paths.front().has_parent_path() &&
                          all_same([](const fs::path& path) { return path.filename(); });
  std::map<std::string, std::string> names;
  for (const fs::path& path : paths)
    names[path.string()] = (drops_file ? path.parent_path() : path).string();
  const auto first_folder_is_common = [&] {
    const std::string& name = names.begin()->second;
    const std::string folder = name.substr(0, name.find('/') + 1);
    return !folder.empty() && std::all_of(names.begin(), names.end(), [&](const auto& entry) {
      return entry.second.rfind(folder, 0) == 0 && entry.second.size() > folder.size();
    });
  };
  while (first_folder_is_common())
    for (auto& [path, name] : names)
      name.erase(0, name.find('/') + 1);
  return names;
}

} // namespace ellipsoid::post

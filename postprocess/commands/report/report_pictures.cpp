// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "report_pictures.h"

#include "chosen_runs.h"
#include "particle_colours.h"
#include "pile_picture.h"
#include "space_picture.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <iterator>

namespace ellipsoid::post {
namespace {

/// Bytes of all pictures together: base64 makes four bytes of three, and tables need room, too.
constexpr std::size_t largest_sum = 1200000;

/// Widths of pictures, the largest that fits is taken (pixels).
constexpr int widths[] = {1200, 900, 720, 560, 440, 340, 260};

/// Small pictures are read at their own size: their letters are larger.
double letters_at(int width) { return std::max(1.0, 750.0 / width); }

/// The largest width at which a picture has no more bytes than its share, else the smallest.
int fitting_width(const std::function<std::string(int width)>& drawn, std::size_t share) {
  for (const int width : widths)
    if (drawn(width).size() <= share)
      return width;
  return *std::prev(std::end(widths));
}

bool is_png(const std::string& bytes) { return bytes.rfind("\x89PNG", 0) == 0; }

std::vector<const ReportedRun*> piles_of(const std::vector<ReportedRun>& runs) {
  std::vector<const ReportedRun*> piles;
  for (const ReportedRun& run : runs)
    if (run.pile)
      piles.push_back(&run);
  return piles;
}

/// What all piles together take.
PileView common_view(const std::vector<const ReportedRun*>& piles) {
  PileView all;
  for (const ReportedRun* run : piles) {
    const ReportedPile& pile = *run->pile;
    const PileView view = whole_pile(pile.set, pile.measured.pile, pile.measured.settings);
    if (run == piles.front())
      all = view;
    all = {std::min(all.left, view.left), std::max(all.right, view.right),
           std::min(all.bottom, view.bottom), std::max(all.top, view.top)};
  }
  return all;
}

/// The pile with the most outlines: its picture has the most bytes.
const ReportedRun& richest_of(const std::vector<const ReportedRun*>& piles) {
  const auto outlines = [](const ReportedRun* run) {
    return run->pile->set.particles.size() + run->pile->set.spheres.size();
  };
  return **std::max_element(piles.begin(), piles.end(), [&](const auto* p, const auto* q) {
    return outlines(p) < outlines(q);
  });
}

/// @param[in] share of each picture (bytes)
std::vector<std::string> pile_pictures(const std::vector<const ReportedRun*>& piles,
                                       std::size_t share) {
  PilePictureOptions options;
  options.view = common_view(piles);
  const auto drawn = [&options](const ReportedRun& run, PictureFormat format, int width) {
    options.width = width;
    options.letters = letters_at(width);
    return draw_pile(format, {}, run.pile->set, run.pile->measured.pile,
                     run.pile->measured.settings, run.pile->measured.flanks, options);
  };
  const ReportedRun& richest = richest_of(piles);
  PictureFormat format = PictureFormat::svg;
  int width = widths[0];
  if (draws_png() && drawn(richest, format, width).size() > share) {
    format = PictureFormat::png;
    width = fitting_width([&](int w) { return drawn(richest, format, w); }, share);
  }
  std::vector<std::string> pictures;
  for (const ReportedRun* run : piles)
    pictures.push_back(drawn(*run, format, width));
  return pictures;
}

std::string caption_of(const ReportedRun& run, const std::string& name) {
  std::string caption = name + ": " + run.title;
  if (!run.pile)
    return caption;
  caption += ", " + shown(*find_value(run.measures, "surface"));
  const std::string count = shown(*find_value(run.measures, "subspheres"));
  return count == "-" ? caption : caption + ", N = " + count;
}

} // namespace

std::size_t count_of_runs(const FrameOptions& frames) { return runs_of(frames).size(); }

std::string picture_in_space(const ParticleSet& upright, const std::string& title,
                             std::size_t runs) {
  const ParticleColours colours = particle_colours({}, upright, "", {}, {});
  const PictureFormat format = draws_png() ? PictureFormat::png : PictureFormat::svg;
  const auto drawn = [&](int width) {
    SpaceView view;
    view.width = width;
    view.height = width * 3 / 4;
    view.letters = letters_at(width);
    return space_picture(format, upright, colours, view, title);
  };
  return drawn(fitting_width(drawn, largest_sum / std::max<std::size_t>(1, runs)));
}

std::vector<HtmlPicture> pictures_of(const std::vector<ReportedRun>& runs,
                                     const std::map<std::string, std::string>& names) {
  const auto piles = piles_of(runs);
  std::vector<std::string> of_piles;
  if (!piles.empty())
    of_piles = pile_pictures(piles, largest_sum / runs.size());
  std::vector<HtmlPicture> pictures;
  auto pile = of_piles.begin();
  for (const ReportedRun& run : runs) {
    const std::string& bytes = run.pile ? *pile++ : run.picture;
    pictures.push_back({bytes, is_png(bytes) ? "image/png" : "image/svg+xml",
                        caption_of(run, names.at(run.name())), run.view_page, "turn and play it"});
  }
  return pictures;
}

} // namespace ellipsoid::post

// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "space_axes.h"

#include "space_camera.h"

#include <algorithm>
#include <array>

namespace ellipsoid::post {

void draw_axes(Canvas& canvas, const SpaceView& view, const PixelPoint& corner, double unit) {
  const Camera camera(view);
  const Vector3 axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return camera.seen(axes[i]).z < camera.seen(axes[j]).z;
  });
  Style line;
  line.line = {0.13, 0.15, 0.18};
  line.line_width = 2.5 * unit;
  TextStyle text;
  text.size = 22.0 * unit;
  text.anchor = Anchor::middle;
  for (const std::size_t k : order) {
    const Vector3 tip = camera.seen(axes[k]);
    const double length = 60.0 * unit;
    canvas.line(corner, {corner.x + length * tip.x, corner.y - length * tip.y}, line);
    canvas.text({corner.x + 1.25 * length * tip.x, corner.y - 1.25 * length * tip.y + 8.0 * unit},
                view.axis_names[k], text);
  }
}

} // namespace ellipsoid::post

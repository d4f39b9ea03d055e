// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Which contacts with a wall of many triangles count: seams, ridges, grooves, boxes, against planes
// and the closed form of wedges, for ellipsoids and chains of spheres.
#include "contact_families.h"
#include "wall/mesh_contact.h"
#include "wall/plane_contact.h"

#include <gtest/gtest.h>

using namespace ellipsoid;
using namespace contact_test;

namespace {

using Mesh = std::vector<Triangle>;

bool never(int, int) { return false; }

/// Contacts of a body with its centre at `centre`.
std::vector<TriangleContact> solve(const Body& body, const Vector3& centre, Mesh mesh,
                                   const SameSurface& same = never) {
  for (Triangle& t : mesh)
    for (Vector3& node : t)
      node -= centre;
  std::vector<TriangleContact> contacts;
  find_mesh_contacts(EllipsoidBody(body.semiaxes, body.orientation), mesh, same, contacts);
  return contacts;
}

void add_quad(Mesh& mesh, const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  mesh.push_back({a, b, c});
  mesh.push_back({a, c, d});
}

/// The square |x|, |y| < half at z = 0, divided into n x n x 2 triangles of random orientation.
Mesh floor_mesh(int n, double half, PairGenerator& random) {
  Mesh mesh;
  const double step = 2.0 * half / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = -half + i * step, y = -half + j * step;
      add_quad(mesh, {x, y, 0.0}, {x + step, y, 0.0}, {x + step, y + step, 0.0},
               {x, y + step, 0.0});
      if (random.uniform(0.0, 1.0) > 0.5)
        std::swap(mesh.back()[0], mesh.back()[1]);
    }
  return mesh;
}

Body random_body(PairGenerator& random, double aspect) {
  return random.body(Family::triaxial, 1.0, aspect);
}

double height_at_touch(const Body& body) { return support(body.shape, {0.0, 0.0, -1.0}); }

} // namespace

// Anywhere on a floor of triangles, on seams and nodes too, there is one contact, that of the
// plane.
TEST(MeshContact, FloorOfTrianglesIsOnePlane) {
  PairGenerator random(41);
  for (int k = 0; k < 1500; ++k) {
    const Body body = random_body(random, 6.0);
    const int cells = k % 3 == 0 ? 1 : k % 3 == 1 ? 4 : 40;
    const Mesh mesh = floor_mesh(cells, 20.0, random);
    const double overlap = random.uniform(0.0, 0.5) * body.shape.smallest_curvature_radius;
    Vector3 centre{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), 0.0};
    centre.z = height_at_touch(body) - overlap;
    if (k % 2 == 0) { // the deepest point on a node or a seam
      const Vector3 deepest =
          (1.0 / height_at_touch(body)) * (body.shape.a_matrix * Vector3{0.0, 0.0, -1.0});
      centre.x = -deepest.x;
      centre.y = k % 4 == 0 ? -deepest.y : centre.y;
    }
    const auto contacts = solve(body, centre, mesh);
    ASSERT_EQ(contacts.size(), 1u) << "pose " << k;
    const ContactGeometry plane =
        find_plane_contact(body.shape, Vector3{0.0, 0.0, -centre.z}, {0.0, 0.0, -1.0});
    ASSERT_NEAR(contacts[0].overlap, plane.overlap, 1e-13);
    ASSERT_LT(norm(contacts[0].normal - plane.normal), 1e-12);
    ASSERT_LT(norm(contacts[0].point - plane.point), 1e-7) << "pose " << k;
  }
}

// Deep into a floor finer than the body: still the plane.
TEST(MeshContact, DeepInAFineFloor) {
  PairGenerator random(42);
  const Mesh mesh = floor_mesh(40, 8.0, random);
  for (int k = 0; k < 300; ++k) {
    const Body body = random_body(random, 5.0);
    const Vector3 centre{0.1, 0.2, height_at_touch(body) * random.uniform(0.3, 1.0)};
    const auto contacts = solve(body, centre, mesh);
    ASSERT_EQ(contacts.size(), 1u) << "pose " << k;
    ASSERT_NEAR(contacts[0].overlap, height_at_touch(body) - centre.z, 1e-12);
    ASSERT_NEAR(contacts[0].normal.z, -1.0, 1e-12);
  }
}

// Sliding over a ridge: one contact, with steady overlap and normal, and the overlap is the minimum
// over the normals between those of the two faces.
TEST(MeshContact, OneContactOnARidge) {
  PairGenerator random(43);
  int edges = 0;
  for (int k = 0; k < 60; ++k) {
    const double slope = random.uniform(0.1, 1.5); // a roof; its ridge is the y axis
    const double drop = 30.0 * std::tan(slope);
    Mesh mesh;
    add_quad(mesh, {0.0, -40.0, 0.0}, {0.0, 40.0, 0.0}, {30.0, 40.0, -drop}, {30.0, -40.0, -drop});
    add_quad(mesh, {0.0, -40.0, 0.0}, {-30.0, -40.0, -drop}, {-30.0, 40.0, -drop},
             {0.0, 40.0, 0.0});
    const Body body = random_body(random, 4.0);
    const double depth = 0.3 * body.shape.smallest_curvature_radius;
    const double step = 0.02;
    double before = -1.0;
    Vector3 normal_before;
    for (double x = -2.0; x < 2.0; x += step) {
      const double y = 0.3 * x;
      double z = 0.0, overlap = 0.0; // at depth below the first touch with the wedge
      const auto overlap_at = [&](const Vector3& centre) {
        double smallest = 1e9;
        for (int m = 0; m <= 400; ++m) {
          const double angle = slope * (m / 200.0 - 1.0);
          const Vector3 n{std::sin(angle), 0.0, -std::cos(angle)};
          smallest = std::min(smallest, support(body.shape, n) + dot(n, centre));
        }
        return smallest;
      };
      double low = -10.0 - drop, high = 5.0;
      for (int m = 0; m < 40; ++m) {
        z = 0.5 * (low + high);
        (overlap_at({x, y, z}) > depth ? low : high) = z;
      }
      overlap = overlap_at({x, y, z});
      const auto contacts = solve(body, {x, y, z}, mesh);
      ASSERT_EQ(contacts.size(), 1u) << "pose " << k << " x " << x;
      ASSERT_NEAR(contacts[0].overlap, overlap, 1e-4) << "pose " << k << " x " << x;
      edges += contacts[0].feature == TriangleFeature::edge;
      if (before >= 0.0) {
        ASSERT_LT(norm(contacts[0].normal - normal_before), 0.6);
      }
      before = contacts[0].overlap;
      normal_before = contacts[0].normal;
    }
  }
  EXPECT_GT(edges, 1000);
}

// In a groove both faces touch, and the groove's edge does not.
TEST(MeshContact, TwoContactsInAGroove) {
  Mesh mesh;
  add_quad(mesh, {0.0, -40.0, 0.0}, {0.0, 40.0, 0.0}, {30.0, 40.0, 30.0}, {30.0, -40.0, 30.0});
  add_quad(mesh, {0.0, -40.0, 0.0}, {-30.0, -40.0, 30.0}, {-30.0, 40.0, 30.0}, {0.0, 40.0, 0.0});
  PairGenerator random(44);
  for (int k = 0; k < 1000; ++k) {
    const Body body = random_body(random, 3.0);
    const double overlap = 0.3 * body.shape.smallest_curvature_radius, r = std::sqrt(0.5);
    const Vector3 right{r, 0.0, -r}, left{-r, 0.0, -r};
    const double s_right = support(body.shape, right) - overlap,
                 s_left = support(body.shape, left) - overlap;
    const Vector3 centre{(s_left - s_right) * r, random.uniform(-1.0, 1.0), (s_left + s_right) * r};
    const auto contacts = solve(body, centre, mesh);
    ASSERT_EQ(contacts.size(), 2u) << "pose " << k;
    for (const TriangleContact& c : contacts) {
      EXPECT_EQ(c.feature, TriangleFeature::face);
      EXPECT_NEAR(c.overlap, overlap, 1e-12);
    }
  }
}

// Two faces of one surface, if the caller says so, count once where the patch of the deeper
// contact, of radius sqrt(R h), reaches the other foot; farther apart they are two supports.
TEST(MeshContact, FacesOfOneSurfaceCountOnceWithinAPatch) {
  Mesh mesh;
  const double rise = 30.0 * std::tan(0.02);
  add_quad(mesh, {0.0, -40.0, 0.0}, {0.0, 40.0, 0.0}, {30.0, 40.0, rise}, {30.0, -40.0, rise});
  add_quad(mesh, {0.0, -40.0, 0.0}, {-30.0, -40.0, rise}, {-30.0, 40.0, rise}, {0.0, 40.0, 0.0});
  Body body;
  body.semiaxes = {3.0, 1.0, 1.0};
  body.shape = make_shape(body.semiaxes, body.orientation);
  const auto always = [](int, int) { return true; };
  for (const double height : {0.999, 0.99, 0.97, 0.95, 0.9}) {
    const Vector3 centre{0.01, 0.0, height};
    const auto both = solve(body, centre, mesh), found = solve(body, centre, mesh, always);
    ASSERT_EQ(both.size(), 2u) << height;
    const double overlap = std::max(both[0].overlap, both[1].overlap);
    const double patch = std::sqrt(3.0 * overlap); // R = a b c / s^2, s = 1 on the flat side
    const bool is_one = norm(both[0].foot - both[1].foot) < patch;
    EXPECT_EQ(is_one, height < 0.96);
    ASSERT_EQ(found.size(), is_one ? 1u : 2u) << height;
    if (is_one) {
      EXPECT_EQ(found[0].overlap, overlap);
    }
  }
}

namespace {

/// The floor of a careless drawing: strips of uneven width, divided without regard to each other
/// (T-junctions), slivers between some of them, and every corner moved by up to `noise`.
Mesh careless_floor(double half, double noise, PairGenerator& random) {
  Mesh mesh;
  const auto cuts = [&](double sliver_share) {
    std::vector<double> c{-half};
    while (c.back() < half)
      c.push_back(c.back() + (random.uniform(0.0, 1.0) < sliver_share
                                  ? random.log_uniform(1e-4, 1e-2)
                                  : random.uniform(0.05, 0.6)));
    return c;
  };
  const std::vector<double> x = cuts(0.3);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const std::vector<double> y = cuts(0.1);
    for (std::size_t j = 0; j + 1 < y.size(); ++j) {
      const auto corner = [&](double u, double v) {
        return Vector3{u, v, 0.0} + (noise * random.uniform(0.0, 1.0)) * random.direction();
      };
      add_quad(mesh, corner(x[i], y[j]), corner(x[i + 1], y[j]), corner(x[i + 1], y[j + 1]),
               corner(x[i], y[j + 1]));
    }
  }
  return mesh;
}

/// Those triangles that a body at the place can reach, as the host's neighbour lists give them.
Mesh near(const Mesh& mesh, const Vector3& centre, double reach) {
  Mesh found;
  for (const Triangle& t : mesh)
    if (norm(nearest_point(t, centre) - centre) < reach)
      found.push_back(t);
  return found;
}

} // namespace

// On it there is one contact everywhere, that of the plane but for the corners' errors.
TEST(MeshContact, CarelessFloorIsOnePlane) {
  PairGenerator random(48);
  constexpr double noise = 1e-5; // of the largest semi-axis, which is 1 or more
  const Mesh mesh = careless_floor(6.0, noise, random);
  EXPECT_GT(mesh.size(), 3000u);
  double worst = 0.0, steepest = 0.0;
  for (int k = 0; k < 1500; ++k) {
    const Body body = random_body(random, 4.0);
    const double a = std::max({body.semiaxes.x, body.semiaxes.y, body.semiaxes.z});
    const double overlap = random.log_uniform(1e-3, 0.3) * body.shape.smallest_curvature_radius;
    const Vector3 centre{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0),
                         support(body.shape, {0.0, 0.0, -1.0}) - overlap};
    const auto contacts = solve(body, centre, near(mesh, centre, 1.01 * a));
    ASSERT_EQ(contacts.size(), 1u) << "pose " << k;
    worst = std::max(worst, std::fabs(contacts[0].overlap - overlap));
    steepest = std::max(steepest, norm(contacts[0].normal - Vector3{0.0, 0.0, -1.0}));
  }
  std::printf("%zu triangles; overlap off by %.1e at most, normal by %.1e\n", mesh.size(), worst,
              steepest);
  EXPECT_LT(worst, 2.0 * noise);
  EXPECT_LT(steepest, 0.01);
}

// A crack between two plates of up to a thousandth of the body's size, and a step as high: one
// contact wherever the body is, and an overlap that is steady and near the plane's.
TEST(MeshContact, CracksAndStepsAreNoFeatures) {
  PairGenerator random(49);
  for (const double width : {1e-7, 1e-5, 1e-4, 1e-3})
    for (const double step : {0.0, 1e-6, 1e-4, 1e-3}) {
      Mesh mesh;
      add_quad(mesh, {-20.0, -20.0, 0.0}, {-0.5 * width, -20.0, 0.0}, {-0.5 * width, 20.0, 0.0},
               {-20.0, 20.0, 0.0});
      add_quad(mesh, {0.5 * width, -20.0, step}, {20.0, -20.0, step}, {20.0, 20.0, step},
               {0.5 * width, 20.0, step});
      for (int k = 0; k < 20; ++k) {
        const Body body = random_body(random, 4.0);
        const double smallest = body.shape.smallest_curvature_radius;
        const double overlap = random.log_uniform(0.01, 0.3) * smallest;
        const Vector3 down{0.0, 0.0, -1.0};
        const Vector3 deepest = (1.0 / support(body.shape, down)) * (body.shape.a_matrix * down);
        const double reach = 4.0 * std::sqrt(overlap), pitch = 1e-3;
        double before = 0.0;
        for (double x = -reach; x < reach; x += pitch) { // of the deepest point
          const Vector3 centre{x - deepest.x, 0.3, support(body.shape, down) - overlap};
          const auto contacts = solve(body, centre, mesh);
          ASSERT_EQ(contacts.size(), 1u) << width << " " << step << " " << x << " body " << k;
          const double found = contacts[0].overlap;
          const double dip = width * width / (8.0 * smallest);
          ASSERT_GT(found, overlap - dip - 1e-12);
          ASSERT_LT(found, overlap + step + 1e-12);
          if (x > -reach) {
            // at a step's edge the overlap grows as the edge nears, by no more than the slope
            // there of the surface at that depth in the body
            const double radius = smallest - overlap - step;
            ASSERT_LT(std::fabs(found - before),
                      pitch * (std::sqrt(2.0 * (step + dip) / radius) + pitch / radius))
                << width << " " << step << " " << x << " body " << k;
          }
          before = found;
        }
      }
    }
}

// A second sheet behind the first, however near, is not touched.
TEST(MeshContact, SheetBehindASheet) {
  PairGenerator random(50);
  for (double behind = 1e-9; behind < 0.05; behind *= 1.5) {
    Mesh mesh;
    add_quad(mesh, {-20.0, -20.0, 0.0}, {20.0, -20.0, 0.0}, {20.0, 20.0, 0.0}, {-20.0, 20.0, 0.0});
    add_quad(mesh, {-18.0, -20.0, -behind}, {18.0, -20.0, -behind}, {18.0, 20.0, -behind},
             {-18.0, 20.0, -behind});
    for (int k = 0; k < 20; ++k) {
      const Body body = random_body(random, 5.0);
      const double overlap = random.log_uniform(1e-3, 0.5) * body.shape.smallest_curvature_radius;
      const Vector3 centre{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                           support(body.shape, {0.0, 0.0, -1.0}) - overlap};
      const auto contacts = solve(body, centre, mesh);
      ASSERT_EQ(contacts.size(), 1u) << behind << " body " << k;
      EXPECT_NEAR(contacts[0].overlap, overlap, 1e-12);
    }
  }
}

// A slanted body on the rim of a box, its tip below the lid beside the box: one contact, at the
// rim, and none with the side that the tip has passed.
TEST(MeshContact, TipBesideABoxDoesNotTouchItsSideFromWithin) {
  Mesh box;
  add_quad(box, {-9.0, -9.0, 0.0}, {0.0, -9.0, 0.0}, {0.0, 9.0, 0.0}, {-9.0, 9.0, 0.0});
  add_quad(box, {0.0, -9.0, 0.0}, {0.0, -9.0, -9.0}, {0.0, 9.0, -9.0}, {0.0, 9.0, 0.0});
  const double tilt = 0.5;
  Body body;
  body.semiaxes = {4.0, 1.0, 1.0};
  body.orientation = {std::cos(0.5 * tilt), 0.0, std::sin(0.5 * tilt), 0.0}; // +x end down
  body.shape = make_shape(body.semiaxes, body.orientation);
  const Vector3 n{-std::sin(tilt), 0.0, -std::cos(tilt)};
  const double overlap = 0.01;
  const Vector3 along{std::cos(tilt), 0.0, -std::sin(tilt)};
  const Vector3 centre = -(support(body.shape, n) - overlap) * n - 0.2 * along;
  const auto contacts = solve(body, centre, box);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].feature, TriangleFeature::edge);
  EXPECT_LT(contacts[0].overlap, overlap);
  EXPECT_GT(contacts[0].overlap, 0.0);
}

// Beside the rim of a thin plate, not touching: nothing, however the plate's plane cuts the body.
TEST(MeshContact, NoContactBesideAPlate) {
  PairGenerator random(45);
  Mesh plate;
  add_quad(plate, {0.0, -20.0, 0.0}, {20.0, -20.0, 0.0}, {20.0, 20.0, 0.0}, {0.0, 20.0, 0.0});
  for (int k = 0; k < 20000; ++k) {
    const Body body = random_body(random, 8.0);
    // the plane's cut through the body ends at x = 0 or before
    const double height = random.uniform(-0.95, 0.95) * height_at_touch(body);
    const SymmetricMatrix3& a = body.shape.a_matrix;
    const double left = std::sqrt((a.xx - a.xz * a.xz / a.zz) * (1.0 - height * height / a.zz));
    const double reach = -a.xz * height / a.zz + left;
    const Vector3 centre{-reach - 1e-9, random.uniform(-5.0, 5.0), height};
    ASSERT_TRUE(solve(body, centre, plate).empty()) << "pose " << k;
    ASSERT_EQ(solve(body, centre + Vector3{2e-9, 0.0, 0.0}, plate).size(), 1u) << "pose " << k;
  }
}

// Every body that reaches into a closed box has a contact, and none points out of it.
TEST(MeshContact, BoxIsClosed) {
  PairGenerator random(46);
  Mesh box;
  const Vector3 e[3] = {{5.0, 0.0, 0.0}, {0.0, 5.0, 0.0}, {0.0, 0.0, 5.0}};
  for (std::size_t k = 0; k < 3; ++k)
    for (const double side : {-1.0, 1.0}) {
      const Vector3 o = side * e[k], u = e[(k + 1) % 3], v = e[(k + 2) % 3];
      add_quad(box, o - u - v, o + u - v, o + u + v, o - u + v);
    }
  int outside = 0;
  for (int k = 0; k < 20000; ++k) {
    const Body body = random_body(random, 4.0);
    const Vector3 centre = random.uniform(4.0, 9.0) * random.direction();
    const auto inside_box = [&](const Vector3& p) {
      return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) < 5.0;
    };
    if (inside_box(centre))
      continue;
    ++outside;
    const auto contacts = solve(body, centre, box);
    double nearest = 1e9; // growth factor
    for (Triangle t : box) {
      for (Vector3& node : t)
        node -= centre;
      double growth;
      find_growing_contact(EllipsoidBody(body.semiaxes, body.orientation), t, growth);
      nearest = std::min(nearest, growth);
    }
    ASSERT_EQ(contacts.empty(), nearest >= 1.0) << "pose " << k;
    for (const TriangleContact& c : contacts)
      ASSERT_GT(dot(c.normal, c.foot), 0.0) << "pose " << k;
  }
  EXPECT_GT(outside, 5000);
}

// Chains of spheres on a floor of triangles: those of the plane, sphere by sphere.
TEST(MeshContact, ChainOnAFloorOfTriangles) {
  PairGenerator random(47);
  const MultisphereBody chain(make_multisphere(3.0, 1.0, 9, SphereSpacing::paper));
  for (int k = 0; k < 400; ++k) {
    MultispherePose pose;
    pose.body = &chain;
    pose.axis = random.direction();
    pose.axis.z *= 0.1;
    pose.axis = normalized(pose.axis);
    const double height = random.uniform(0.2, 1.2);
    Mesh mesh = floor_mesh(k % 2 ? 30 : 1, 8.0, random);
    for (Triangle& t : mesh)
      for (Vector3& node : t)
        node.z -= height;
    std::vector<TriangleContact> contacts;
    find_mesh_contacts(pose, mesh, never, contacts);
    std::vector<WallContact> expected;
    find_plane_contacts(pose, {{0.0, 0.0, -height}, {0.0, 0.0, -1.0}}, expected);
    ASSERT_EQ(contacts.size(), expected.size()) << "pose " << k;
    for (std::size_t m = 0; m < contacts.size(); ++m) {
      EXPECT_EQ(contacts[m].sphere, expected[m].sphere);
      EXPECT_NEAR(contacts[m].overlap, expected[m].overlap, 1e-14);
      EXPECT_LT(norm(contacts[m].point - expected[m].point), 1e-13);
      EXPECT_EQ(contacts[m].reduced_radius, expected[m].reduced_radius);
    }
  }
}

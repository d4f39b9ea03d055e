// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// The text dump reader: what it accepts, what it refuses and in which words.
#include "../../postprocess/fuzz/memory_bytes.h"
#include "body_properties.h"
#include "compressed_bytes.h"
#include "energy.h"
#include "multisphere/ellipsoid_spheres.h"
#include "particles.h"
#include "text_dump.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <zlib.h>
#include <zstd.h>

namespace ellipsoid::post {
namespace {

std::string frame_text(int step, const std::string& columns, const std::vector<std::string>& rows,
                       const std::string& count = "") {
  std::string text = "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" +
                     (count.empty() ? std::to_string(rows.size()) : count) +
                     "\nITEM: BOX BOUNDS mm mm ff\n0 0.5\n-0.005 0.2\n-0.01 0.01\nITEM: ATOMS " +
                     columns + "\n";
  for (const auto& row : rows)
    text += row + "\n";
  return text;
}

TextDumpReader reader_of(const std::string& text) {
  return TextDumpReader(memory_bytes(text), "test.dump");
}

/// Reads to the end; gives the number of whole frames and the error's text (or nothing).
std::pair<int, std::string> read_all(const std::string& text) {
  TextDumpReader reader = reader_of(text);
  Frame frame;
  int frames = 0;
  try {
    while (reader.next(frame))
      ++frames;
  } catch (const InputError& error) {
    return {frames, error.what()};
  }
  return {frames, ""};
}

void expect_error(const std::string& text, int whole_frames, const std::string& message) {
  const auto [frames, error] = read_all(text);
  EXPECT_EQ(frames, whole_frames) << error;
  EXPECT_EQ(error, message);
}

/// The second value of column y.
void expect_unreadable(const std::string& value) {
  TextDumpReader reader = reader_of(frame_text(0, "id x y", {"1 0 0", "2 0 " + value, "3 0 nan"}));
  Frame frame;
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(frame.required("x", "")[1], 0.0);
  try {
    frame.required("y", "");
    ADD_FAILURE() << value;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "test.dump:11: frame 1: expected a finite number in column \"y\", found \"" + value +
                  "\"");
  }
}

const std::string good = frame_text(0, "id x y z radius", {}) +
                         frame_text(100, "id x y z radius", {"1 0.5 1 2 3e-3", "2 -1 -2.5 0 +0.1"});

TEST(TextDump, gives_header_and_values) {
  TextDumpReader reader = reader_of("\n" + good);
  Frame frame;
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(frame.rows, 0u);
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(frame.timestep, 100);
  EXPECT_EQ(frame.location.frame, 2u);
  EXPECT_EQ(frame.box.boundary, "mm mm ff");
  EXPECT_EQ(frame.box.lower[1], -0.005);
  EXPECT_EQ(frame.box.upper[0], 0.5);
  ASSERT_EQ(frame.names.size(), 5u);
  EXPECT_EQ(frame.required("radius", "")[0], 3e-3);
  EXPECT_EQ(frame.required("radius", "")[1], 0.1);
  EXPECT_EQ(frame.required("y", "")[1], -2.5);
  EXPECT_FALSE(reader.next(frame));
}

TEST(TextDump, accepts_windows_line_ends_units_time_and_words_for_elements) {
  std::string text = "ITEM: UNITS\nsi\n";
  text = frame_text(7, "element id x", {"Al 1 0.25"});
  text.insert(text.find("ITEM: NUMBER"), "ITEM: TIME\n0.5\nITEM: UNITS\nsi\n");
  std::string windows;
  for (const char letter : text)
    windows += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  TextDumpReader reader = reader_of(windows);
  Frame frame;
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(frame.units, "si");
  EXPECT_EQ(frame.time.value_or(0.0), 0.5);
  EXPECT_EQ(frame.required("x", "")[0], 0.25);
}

TEST(TextDump, accepts_units_and_time_before_the_time_step) {
  const std::string first = "ITEM: UNITS\ncgs\nITEM: TIME\n0.25\n" + frame_text(7, "id x", {"1 2"});
  TextDumpReader reader = reader_of(first + "ITEM: TIME\n0.5\n" + frame_text(8, "id x", {"1 3"}) +
                                    frame_text(9, "id x", {"1 4"}));
  Frame frame;
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(frame.units, "cgs");
  EXPECT_EQ(frame.time.value_or(0.0), 0.25);
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(frame.units, "cgs"); // stated once for the whole file
  EXPECT_EQ(frame.time.value_or(0.0), 0.5);
  EXPECT_EQ(frame.timestep, 8);
  ASSERT_TRUE(reader.next(frame));
  EXPECT_FALSE(frame.time.has_value());
  expect_error("ITEM: TIMESTEPS\n1\n", 0,
               "test.dump:1: frame 1: expected \"ITEM: TIMESTEP\", found \"ITEM: TIMESTEPS\"");
  expect_error(good + "ITEM: UNITS\nsi\n", 2,
               "test.dump:23: frame 3: expected \"ITEM: TIMESTEP\", found the end of the file (the "
               "last frame is cut off)");
}

TEST(TextDump, reads_lists_of_contacts) {
  std::string text = frame_text(3, "c_1[1] c_1[2]", {"1 2"});
  text.replace(text.find("NUMBER OF ATOMS"), 15, "NUMBER OF ENTRIES");
  text.replace(text.find("ITEM: ATOMS"), 11, "ITEM: ENTRIES");
  TextDumpReader reader = reader_of(text);
  Frame frame;
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(frame.label, "ENTRIES");
  EXPECT_EQ(frame.required("c_1[2]", "")[0], 2.0);
}

TEST(TextDump, numbers_at_the_ends_of_the_range) {
  const auto [frames, error] =
      read_all(frame_text(0, "x y", {"1e-400 -1e-320", "1.7976931348623157e308 4.9e-324"}));
  EXPECT_EQ(frames, 1) << error;
  expect_unreadable("1e400");
}

TEST(TextDump, names_what_is_wrong_after_the_whole_frames) {
  const std::string header = "id x y z radius";
  expect_error(good + frame_text(200, header, {"1 0 0 0 1", "2 0 0 0"}), 2,
               "test.dump:31: frame 3: expected 5 values in row 2 of 2, found 4: \"2 0 0 0\"");
  expect_error(
      good + frame_text(200, header, {"1 0 0 0 1 9"}), 2,
      "test.dump:30: frame 3: expected 5 values in row 1 of 1, found more: \"1 0 0 0 1 9\"");
}

TEST(TextDump, values_that_are_no_numbers_matter_to_those_who_need_the_column) {
  for (const char* value : {"nan", "-inf", "0x", "word"})
    expect_unreadable(value);
  TextDumpReader reader = reader_of(frame_text(0, "id x y", {"1 nan 2"}) + good);
  Frame frame;
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(frame.required("y", "")[0], 2.0);
  EXPECT_FALSE(frame.is_readable(1));
  ASSERT_TRUE(reader.next(frame)); // what follows is read
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(frame.required("x", "")[0], 0.5);
}

TEST(TextDump, wrong_counts) {
  const std::string header = "id x";
  expect_error(frame_text(0, header, {"1 0"}, "2"), 0,
               "test.dump:11: frame 1: expected row 2 of 2, found the end of the file (the last "
               "frame is cut off)");
  expect_error(frame_text(0, header, {"1 0", "2 0"}, "1"), 1,
               "test.dump:11: frame 2: expected \"ITEM: TIMESTEP\", found \"2 0\"");
  expect_error(frame_text(0, header, {"1 0"}, "2") + frame_text(1, header, {"1 0"}), 0,
               "test.dump:11: frame 1: expected row 2 of 2, found \"ITEM: TIMESTEP\"");
  expect_error(frame_text(0, header, {}, "-1"), 0,
               "test.dump:4: frame 1: expected the number of rows, a whole number >= 0, found "
               "\"-1\"");
  // a count that would need all memory of the machine
  expect_error(frame_text(0, header, {"1 0"}, "1000000000000000000"), 0,
               "test.dump:11: frame 1: expected row 2 of 1000000000000000000, found the end of the "
               "file (the last frame is cut off)");
}

TEST(TextDump, is_cut_off_anywhere) {
  const std::string first = frame_text(0, "id x", {"1 0.5", "2 0.25"});
  const std::string both = first + frame_text(1, "id x", {"1 0.5", "2 0.75"});
  const std::size_t first_end = first.size();
  for (std::size_t length = 1; length < both.size(); ++length) {
    if (length == first_end)
      continue; // this is a whole file
    const auto [frames, error] = read_all(both.substr(0, length));
    EXPECT_FALSE(error.empty()) << length;
    EXPECT_EQ(frames, length > first_end ? 1 : 0) << length;
  }
}

TEST(TextDump, rubbish) {
  expect_error(std::string("\x7f"
                           "ELF\0\0\0",
                           7),
               0, "test.dump:1: frame 1: expected text, found a NUL byte: these are binary data");
  expect_error("hello\n", 0, "test.dump:1: frame 1: expected \"ITEM: TIMESTEP\", found \"hello\"");
  expect_error(std::string("\xff\xfe\x01"), 0,
               "test.dump:1: frame 1: expected \"ITEM: TIMESTEP\", found \"\\xff\\xfe\\x01\"");
  expect_error(
      std::string(3u << 20, 'x'), 0,
      "test.dump:1: frame 1: expected lines of text, found a line of more than 1048576 bytes");
  EXPECT_EQ(read_all("").first, 0);
}

TEST(TextDump, gzip_gives_the_same_and_a_cut_file_is_an_error) {
  const std::string path = "post_text_dump_test.dump.gz";
  gzFile file = gzopen(path.c_str(), "wb");
  std::string text;
  for (int k = 0; k < 3000; ++k)
    text += good;
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  TextDumpReader reader(path);
  Frame frame;
  int frames = 0;
  while (reader.next(frame))
    ++frames;
  EXPECT_EQ(frames, 6000);
  EXPECT_EQ(frame.required("y", "")[1], -2.5);
  std::FILE* whole = std::fopen(path.c_str(), "rb");
  std::string bytes(1u << 20, '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), whole));
  std::fclose(whole);
  std::FILE* cut = std::fopen(path.c_str(), "wb");
  std::fwrite(bytes.data(), 1, bytes.size() / 2, cut);
  std::fclose(cut);
  TextDumpReader broken(path);
  frames = 0;
  try {
    while (broken.next(frame))
      ++frames;
    ADD_FAILURE() << "a cut file was read to its end";
  } catch (const InputError& error) {
    const std::size_t line = std::size_t(frames) / 2 * 20 + (frames % 2 == 1 ? 9 : 0);
    const std::string message = error.what();
    const std::size_t begin = path.size() + 1;
    ASSERT_EQ(message.substr(0, begin), path + ":") << message;
    const std::size_t named =
        std::stoul(message.substr(begin)); // in the frame after the whole ones
    EXPECT_TRUE(named > line && named <= line + 11) << message << " after " << frames << " frames";
    EXPECT_NE(message.find(": frame " + std::to_string(frames + 1) +
                           ": expected more data, found "
                           "gzip data that are broken or cut off (unexpected end of file)"),
              std::string::npos)
        << message;
  }
}

TEST(TextDump, zstd_gives_the_same_and_cut_data_are_an_error) {
  std::string packed(ZSTD_compressBound(good.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), good.data(), good.size(), 3));
  TextDumpReader reader(decompressed(memory_bytes(packed + packed)), "test.dump");
  Frame frame;
  int frames = 0;
  while (reader.next(frame))
    ++frames;
  EXPECT_EQ(frames, 4);
  EXPECT_EQ(frame.required("y", "")[1], -2.5);
  TextDumpReader cut(decompressed(memory_bytes(packed.substr(0, packed.size() - 8))), "test.dump");
  EXPECT_THROW(while (cut.next(frame)){}, InputError);
}

TEST(TextDump, boxes_along_the_axes_tilted_and_general) {
  const auto box_of = [](const std::string& title, const std::string& bounds) {
    std::string text = frame_text(0, "id x", {"1 0"});
    text.replace(text.find("mm mm ff"),
                 std::string("mm mm ff\n0 0.5\n-0.005 0.2\n-0.01 0.01").size(),
                 title + "\n" + bounds);
    TextDumpReader reader = reader_of(text);
    Frame frame;
    EXPECT_TRUE(reader.next(frame));
    return frame.box;
  };
  const Box tilted = box_of("xy xz yz pp ff pp", "-1 14 4\n0 8 -1\n1 3 2");
  EXPECT_EQ(tilted.boundary, "pp ff pp");
  EXPECT_EQ(tilted.lower[0], 0.0); // -1 - min(0, 4, -1, 3)
  EXPECT_EQ(tilted.tilted_edges.at(0).x, 10.0);
  EXPECT_EQ(tilted.tilted_edges.at(1).x, 4.0);
  EXPECT_EQ(tilted.tilted_edges.at(1).y, 6.0); // 8 - max(0, 2)
  EXPECT_EQ(tilted.tilted_edges.at(2).x, -1.0);
  EXPECT_EQ(tilted.tilted_edges.at(2).y, 2.0);
  EXPECT_EQ(tilted.tilted_edges.at(2).z, 2.0);
  EXPECT_EQ(tilted.upper[0], 13.0);
  EXPECT_TRUE(box_of("xy xz yz pp pp pp", "0 1 0\n0 1 0\n0 1 0").tilted_edges.empty());
  const Box general = box_of("abc origin pp pp pp", "1 0 0 5\n0.5 2 0 6\n0 0.25 3 7");
  EXPECT_EQ(general.lower[2], 7.0);
  EXPECT_EQ(general.tilted_edges.at(2).y, 0.25);
  EXPECT_EQ(general.upper[1], 8.25);
  EXPECT_THROW(box_of("pp pp pp", "0 1 4\n0 1\n0 1"), InputError);
}

TEST(TextDump, a_missing_file_is_an_error) {
  EXPECT_THROW(TextDumpReader("no/such/file.dump"), InputError);
  EXPECT_THROW(TextDumpReader("/tmp"), InputError);
}

// --- particles ---------------------------------------------------------------------------

Frame one_frame(const std::string& columns, const std::vector<std::string>& rows) {
  TextDumpReader reader = reader_of(frame_text(5, columns, rows));
  Frame frame;
  EXPECT_TRUE(reader.next(frame));
  return frame;
}

std::string particle_error(const std::string& columns, const std::string& row,
                           const ParticleOptions& options = {}) {
  try {
    particles_of(one_frame(columns, {row}), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Particles, columns_may_stand_in_any_order) {
  const Frame a = one_frame("id type x y z quat1 quat2 quat3 quat4 shapex shapey shapez",
                            {"2 1 1 2 3 0.6 0 0 0.8 3 2 1", "1 4 0 0 0 1 0 0 0 1 1 1"});
  const Frame b = one_frame("shapez quat4 z y x extra shapex shapey quat3 quat2 quat1 id type",
                            {"1 0 0 0 0 7 1 1 0 0 1 1 4", "1 0.8 3 2 1 9 3 2 0 0 0.6 2 1"});
  const ParticleSet p = particles_of(a, {}), q = particles_of(b, {});
  ASSERT_EQ(p.particles.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(p.particles[k].id, q.particles[k].id);
    EXPECT_EQ(p.particles[k].type, q.particles[k].type);
    EXPECT_EQ(p.particles[k].centre.y, q.particles[k].centre.y);
    EXPECT_EQ(p.particles[k].semiaxes.x, q.particles[k].semiaxes.x);
    EXPECT_EQ(p.particles[k].orientation.z, q.particles[k].orientation.z);
  }
  EXPECT_EQ(p.particles[0].id, 1);
  EXPECT_EQ(p.particles[1].semiaxes.y, 2.0);
}

TEST(Particles, scaled_positions_and_spheres) {
  const ParticleSet set =
      particles_of(one_frame("id xs ys zs radius", {"1 0.5 0.5 0.5 0.002"}), {});
  EXPECT_DOUBLE_EQ(set.particles[0].centre.x, 0.25);
  EXPECT_DOUBLE_EQ(set.particles[0].centre.y, 0.0975);
  EXPECT_EQ(set.particles[0].semiaxes.z, 0.002);
  EXPECT_TRUE(set.particles[0].is_smooth());
}

TEST(Particles, multispheres_have_the_kernels_chain_in_space) {
  const ParticleSet set =
      particles_of(one_frame("id x y z quat1 quat2 quat3 quat4 shapex shapey shapez f_subspheres",
                             {"1 1 2 3 0.7071067811865476 0 0 0.7071067811865476 2.7 1.15 1.15 7",
                              "2 0 0 0 1 0 0 0 2.7 1.15 1.15 0"}),
                   {});
  const MultisphereTemplate chain = make_multisphere(2.7, 1.15, 7);
  ASSERT_EQ(set.particles[0].sphere_count, 7u);
  EXPECT_TRUE(set.particles[1].is_smooth());
  for (std::size_t k = 0; k < 7; ++k) { // turned by 90 degrees about z: x axis to y axis
    EXPECT_NEAR(set.spheres[k].centre.x, 1.0, 1e-15);
    EXPECT_NEAR(set.spheres[k].centre.y, 2.0 + chain.centres[k], 1e-14);
    EXPECT_EQ(set.spheres[k].radius, chain.radii[k]);
  }
}

/// Two crossed pairs of spheres: the file's axes are the principal ones.
ParticleOptions with_cross(const std::string& assignment = "2=cross.csv") {
  std::ofstream("cross.csv") << "x,y,z,r\n1,0,0,0.8\n-1,0,0,0.8\n0,0.5,0,0.6\n0,-0.5,0,0.6\n";
  ParticleOptions options;
  options.clumps = {assignment};
  return options;
}

const std::string clump_columns =
    "id mass x y z quat1 quat2 quat3 quat4 shapex shapey shapez vx vy vz omegax omegay omegaz "
    "f_subspheres f_spacing";

TEST(Particles, clumps_have_the_spheres_of_their_file_in_their_size) {
  const std::string turned = "1 3 1 2 3 0.7071067811865476 0 0 0.7071067811865476 3.6 2.2 1.6 "
                             "0 0 0 0 0 2 4 1002";
  const ParticleSet set = particles_of(one_frame(clump_columns, {turned}), with_cross());
  const Particle& p = set.particles[0];
  ASSERT_EQ(p.sphere_count, 4u);
  // twice as large, turned by 90 degrees about z
  EXPECT_NEAR(norm(set.spheres[0].centre - Vector3{1.0, 4.0, 3.0}), 0.0, 1e-14);
  EXPECT_NEAR(norm(set.spheres[2].centre - Vector3{0.0, 2.0, 3.0}), 0.0, 1e-14);
  EXPECT_NEAR(set.spheres[1].radius, 1.6, 1e-14);
  EXPECT_NEAR(set.spheres[3].radius, 1.2, 1e-14);
  // volume and moment about z by points of a grid
  double volume = 0.0, moment = 0.0;
  constexpr int cells = 160;
  const double cell = 8.0 / cells;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < cells; ++k) {
        const Vector3 d{(i + 0.5) * cell - 4.0, (j + 0.5) * cell - 4.0, (k + 0.5) * cell - 4.0};
        bool inside = false;
        for (const Sphere& s : set.spheres)
          inside = inside || norm(p.centre + d - s.centre) < s.radius;
        volume += inside ? cell * cell * cell : 0.0;
        moment += inside ? cell * cell * cell * (d.x * d.x + d.y * d.y) : 0.0;
      }
  EXPECT_NEAR(body_volume(set, p) / volume, 1.0, 2e-3);
  const SymmetricMatrix3 inertia = body_inertia(set, p, 3.0);
  EXPECT_NEAR(inertia.zz / (3.0 * moment / volume), 1.0, 2e-3);
  EXPECT_NEAR(inertia.xy, 0.0, 1e-12);
  EXPECT_NEAR(*energy(set, {}).rotation / (0.5 * inertia.zz * 4.0), 1.0, 1e-12);
}

TEST(Particles, clumps_without_their_spheres_are_refused) {
  const std::string shape = "3.6 2.2 1.6 0 0 0 0 0 2 ";
  const std::string place = "1 3 1 2 3 1 0 0 0 ";
  const auto error = [&](const std::string& row, const ParticleOptions& options) {
    return particle_error(clump_columns, row, options);
  };
  EXPECT_NE(error(place + shape + "4 1002", {}).find("give --clump 2=FILE"), std::string::npos);
  EXPECT_NE(error(place + shape + "4 1001", with_cross()).find("give --clump 1=FILE"),
            std::string::npos);
  EXPECT_NE(error(place + shape + "5 1002", with_cross()).find("has 4 spheres, the particle 5"),
            std::string::npos);
  EXPECT_NE(error(place + "3.6 2.2 1.7 0 0 0 0 0 2 4 1002", with_cross()).find("another shape"),
            std::string::npos);
  EXPECT_NE(error(place + shape + "4 1002", with_cross("2=missing.csv")).find("cannot be read"),
            std::string::npos);
  for (const char* bad : {"cross.csv", "=cross.csv", "two=cross.csv", "0=cross.csv"})
    EXPECT_NE(error(place + shape + "4 1002", with_cross(bad)).find("NUMBER=FILE"),
              std::string::npos);
}

TEST(Particles, ellipsoids_of_three_axes_have_the_kernels_set) {
  const ParticleSet set = particles_of(
      one_frame("id x y z quat1 quat2 quat3 quat4 shapex shapey shapez f_subspheres f_spacing",
                {"1 0 0 0 1 0 0 0 2 3 1 21 4"}),
      {});
  const SphereSet truth = make_ellipsoid_spheres({2.0, 3.0, 1.0}, 21, SphereSpacing::medial);
  ASSERT_EQ(set.spheres.size(), 21u);
  for (std::size_t k = 0; k < 21; ++k) {
    EXPECT_EQ(norm(set.spheres[k].centre - truth.centres[k]), 0.0);
    EXPECT_EQ(set.spheres[k].radius, truth.radii[k]);
  }
}

TEST(Particles, spheres_of_the_hosts_multisphere_are_grouped_by_body) {
  const ParticleSet set = particles_of(
      one_frame("id id_multisphere x y z radius",
                {"1 1 0 0 0 1", "2 1 0 1.5 0 0.5", "3 1 0 -1.5 0 0.5", "4 -1 9 0 0 1"}),
      {});
  ASSERT_EQ(set.particles.size(), 2u);
  const Particle& body = set.particles[1];
  EXPECT_EQ(body.sphere_count, 3u);
  EXPECT_NEAR(body.semiaxes.x, 2.0, 1e-12);
  EXPECT_NEAR(body.semiaxes.y, 1.0, 1e-12);
  EXPECT_NEAR(std::abs(rotation(body.orientation).column_x.y), 1.0, 1e-12);
}

TEST(Particles, errors_name_column_row_and_range) {
  EXPECT_EQ(particle_error("id x y radius", "1 0 0 1"),
            "test.dump:10: frame 1: expected a column \"z\" (the position of the particles), found "
            "only: id x y radius");
  EXPECT_NE(particle_error("id x y z", "1 0 0 0").find("--semiaxes"), std::string::npos);
  for (const char* columns : {"id x y z shapex", "id x y z shapex shapey", "id x y z shapez"})
    EXPECT_NE(particle_error(columns, std::string(columns).find("shapey") == std::string::npos
                                          ? "1 0 0 0 1"
                                          : "1 0 0 0 1 1")
                  .find("semi-axes"),
              std::string::npos)
        << columns;
  for (const char* columns :
       {"id x y z quat1 shapex shapey shapez", "id x y z quat4 shapex shapey shapez"})
    EXPECT_NE(particle_error(columns, "1 0 0 0 1 3 2 1").find("orientation"), std::string::npos);
  EXPECT_EQ(particle_error("id x y z radius", "1 0 0 0 -2"),
            "test.dump:10: frame 1: expected semi-axes > 0 (and 1e-30 to 1e+30), found -2 -2 -2");
  EXPECT_NE(particle_error("id x y z shapex shapey shapez", "1 0 0 0 2 1 1").find("quat1"),
            std::string::npos);
  EXPECT_NE(particle_error("id x y z quat1 quat2 quat3 quat4 shapex shapey shapez",
                           "1 0 0 0 1 0 0 0 1e5 1 1")
                .find("factor of 10000"),
            std::string::npos);
  EXPECT_EQ(particle_error("id x y z radius", "1.5 0 0 0 1"),
            "test.dump:10: frame 1: expected a whole number (id), found 1.5");
  ParticleOptions joined;
  joined.bodies = "mol";
  EXPECT_NE(particle_error("id mol x y z radius", "1 1e80 0 0 0 1", joined).find("(body)"),
            std::string::npos);
  EXPECT_NE(particle_error("id x y z radius", "1 0 0 1e31 1").find("position"), std::string::npos);
  const std::string columns = "id x y z quat1 quat2 quat3 quat4 shapex shapey shapez f_subspheres";
  EXPECT_EQ(particle_error(columns, "1 0 0 0 1 1 0 0 2 1 1 0"),
            "test.dump:10: frame 1: expected a quaternion quat1..quat4 of length 1, found length "
            "1.4142135623730951");
  EXPECT_EQ(particle_error(columns, "1 0 0 0 1 0 0 0 2 1 1 2.5"),
            "test.dump:10: frame 1: expected a whole number of sub-spheres from 0 to 9999, found "
            "2.5");
  for (const char* bad :
       {"1 0 0 0 1 0 0 0 2 1 1 4", "1 0 0 0 1 0 0 0 1 2 2 5", "1 0 0 0 1 0 0 0 3 2 1 5"})
    EXPECT_NE(particle_error(columns, bad).find("multi-sphere"), std::string::npos) << bad;
}

} // namespace
} // namespace ellipsoid::post

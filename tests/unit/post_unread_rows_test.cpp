// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// Rows that are left as text and read later, in threads: the same frames, the same messages, in the
// same order as when every row is read at once.
#include "../../postprocess/fuzz/fuzz_case.h"
#include "frame_loop.h"
#include "messages.h"

#include <cstdio>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ellipsoid::post {
namespace {

std::string frame_text(int step, const std::vector<std::string>& rows,
                       const std::string& count = "") {
  std::string text =
      fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n"
                  "ITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id x y z radius\n",
                  step, count.empty() ? std::to_string(rows.size()) : count);
  for (const std::string& row : rows)
    text += row + "\n";
  return text;
}

/// `count` frames of two rows, their steps from `first`.
std::string good_frames(int first, int count) {
  std::string text;
  for (int k = first; k < first + count; ++k)
    text += frame_text(k, {"1 0 0 0 1", "2 5 0 0 1"});
  return text;
}

TEST(UnreadRows, are_whole_lines_of_the_frame) {
  TextDumpReader reader(memory_bytes(good_frames(0, 2)), "test.dump");
  Frame frame;
  ASSERT_TRUE(reader.next_unread(frame));
  EXPECT_EQ(frame.unread, "1 0 0 0 1\n2 5 0 0 1\n");
  EXPECT_EQ(frame.location.line, 10u);
  read_rows(frame);
  EXPECT_TRUE(frame.unread.empty());
  EXPECT_EQ(frame.required("x", "")[1], 5.0);
  ASSERT_TRUE(reader.next_unread(frame));
  EXPECT_EQ(frame.location.line, 21u);
  EXPECT_FALSE(reader.next_unread(frame));
}

TEST(UnreadRows, of_a_last_line_without_end_are_read_at_once) {
  std::string text = good_frames(0, 1);
  text.back() = ' '; // without a blank the last number may be cut
  TextDumpReader reader(memory_bytes(text), "test.dump");
  Frame frame;
  ASSERT_TRUE(reader.next_unread(frame));
  EXPECT_TRUE(frame.unread.empty());
  EXPECT_EQ(frame.required("x", "")[1], 5.0);
  text.pop_back();
  TextDumpReader cut(memory_bytes(text), "test.dump");
  EXPECT_THROW(cut.next_unread(frame), InputError);
}

TEST(UnreadRows, are_held_up_to_a_number_of_bytes) {
  const std::string blanks(500000, ' ');
  const std::vector<std::string> rows(200, "1" + blanks + "0 0 0 1");
  std::string text = frame_text(0, rows) + good_frames(1, 1);
  TextDumpReader reader(memory_bytes(text), "test.dump");
  Frame frame;
  ASSERT_TRUE(reader.next_unread(frame));
  EXPECT_TRUE(frame.unread.empty());
  EXPECT_LT(frame.unread.capacity(), text.size());
  EXPECT_EQ(frame.required("radius", "").size(), 200u);
  EXPECT_EQ(frame.required("radius", "")[199], 1.0);
  ASSERT_TRUE(reader.next_unread(frame));
  EXPECT_EQ(frame.location.line, 219u);
}

/// Something is wrong behind `whole` good frames.
struct Fault {
  std::string text, message;
  int whole;
};

std::vector<Fault> faults() {
  const std::string after = good_frames(7, 20);
  const auto broken = [&](const std::string& frame, const std::string& message) {
    return Fault{good_frames(0, 6) + frame + after, "line" + message, 6};
  };
  return {
      broken(frame_text(6, {"1 0 0 0", "2 0 0 0 1"}),
             ":76: frame 7: expected 5 values in row 1 of 2, found 4: \"1 0 0 0\""),
      broken(frame_text(6, {"1 0 0 0 1 7", "2 0 0 0 1"}),
             ":76: frame 7: expected 5 values in row 1 of 2, found more: \"1 0 0 0 1 7\""),
      broken(frame_text(6, {"1 0 0 0 1"}, "2"),
             ":77: frame 7: expected row 2 of 2, found \"ITEM: TIMESTEP\""),
      broken(frame_text(6, {"1 x 0 0 1"}, "2"), // no row counts of a frame that is not whole
             ":77: frame 7: expected row 2 of 2, found \"ITEM: TIMESTEP\""),
      broken(frame_text(6, {std::string("1 0 \0 0 1", 9), "2 0 0 0 1"}),
             ":76: frame 7: expected text, found a NUL byte: these are binary data"),
      {good_frames(0, 6) + frame_text(6, {"1 0 0 0 1", "2 0 0 0 1"}, "1") + after,
       "line:77: frame 8: expected \"ITEM: TIMESTEP\", found \"2 0 0 0 1\"", 7},
      {good_frames(0, 6) + frame_text(6, {"1 0 0 0 1"}, "2"),
       "line:77: frame 7: expected row 2 of 2, found the end of the file (the last frame is cut "
       "off)",
       6},
      {good_frames(0, 6) + frame_text(6, {"1 0 0 0 1", "2 0 0 0 1", "3 0 0 0 1"}, "3000000"),
       "line:79: frame 7: expected row 4 of 3000000, found the end of the file (the last frame is "
       "cut "
       "off)",
       6},
  };
}

TEST(UnreadRows, name_the_first_fault) {
  for (const Fault& fault : faults())
    for (const std::size_t held : {0u, 1u, 5u}) {
      const Reading reading = reading_of(fault.text, held);
      EXPECT_EQ(reading.frames, static_cast<std::size_t>(fault.whole)) << fault.message;
      EXPECT_EQ(reading.error, "fuzz" + fault.message.substr(4));
    }
}

/// What a command would print: measured steps, warnings, errors; and its exit code.
std::string in_threads(const std::vector<std::string>& files, unsigned threads) {
  FrameOptions options;
  options.runs = files;
  options.frames = "all";
  options.threads = threads;
  static int calls = 0;
  const std::string once = fmt::format("late steps of call {}", ++calls);
  std::string steps;
  testing::internal::CaptureStderr();
  const int code = for_measured_frames(options, [&](const ChosenFrame& chosen) {
    const std::int64_t step = chosen.frame.timestep;
    if (step % 3 == 0)
      report_warning(fmt::format("step {}", step), step > 5 ? once : "");
    if (step == 4)
      throw InputError("nothing to measure");
    return [&steps, step] { steps += fmt::format(" {}", step); };
  });
  return fmt::format("{}; exit {}\n{}", steps, code, testing::internal::GetCapturedStderr());
}

void write(const std::string& name, const std::string& text) {
  std::FILE* file = std::fopen(name.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  std::fwrite(text.data(), 1, text.size(), file);
  std::fclose(file);
}

TEST(UnreadRows, in_threads_nothing_behind_a_fault_counts) {
  int number = 0;
  for (const Fault& fault : faults()) {
    const std::string name = fmt::format("unread{}.dump", ++number);
    write(name, fault.text);
    const std::string alone = in_threads({name}, 1);
    EXPECT_EQ(alone.substr(0, 9), " 0 1 2 3 ") << alone;
    EXPECT_NE(alone.find("error: " + name + fault.message.substr(4) + "\n"), std::string::npos)
        << alone;
    EXPECT_NE(alone.find(fault.whole == 6 ? " 3 5; exit" : " 3 5 6; exit"), std::string::npos)
        << alone;
    for (const unsigned threads : {2u, 3u, 7u})
      EXPECT_EQ(in_threads({name}, threads), alone) << threads;
  }
}

TEST(UnreadRows, in_threads_a_value_that_is_no_number_counts_for_its_frame) {
  write("word.dump",
        good_frames(0, 6) + frame_text(6, {"1 0 0 0 1", "2 0 0 nan 1"}) + good_frames(7, 3));
  const std::string alone = in_threads({"word.dump"}, 1);
  EXPECT_EQ(alone.substr(0, 25), " 0 1 2 3 5 7 8 9; exit 1\n") << alone;
  EXPECT_NE(
      alone.find("error: word.dump:77: frame 7: expected a finite number in column \"z\", found "
                 "\"nan\"\n"),
      std::string::npos)
      << alone;
  for (const unsigned threads : {2u, 5u})
    EXPECT_EQ(in_threads({"word.dump"}, threads), alone) << threads;
}

TEST(UnreadRows, in_threads_runs_are_reported_one_after_the_other) {
  write("steps.20.dump", good_frames(20, 1));
  write("steps.21.dump", frame_text(21, {"1 0 0"}));
  write("steps.22.dump", good_frames(22, 1));
  write("whole.dump", good_frames(0, 30));
  const std::vector<std::string> files = {"steps.*.dump", "whole.dump", "none.dump"};
  const std::string alone = in_threads(files, 1);
  EXPECT_EQ(alone.substr(0, 8), " 20 0 1 ") << alone;
  EXPECT_NE(alone.find("steps.21.dump:10: frame 1: expected 5 values in row 1 of 1"),
            std::string::npos)
      << alone;
  for (const unsigned threads : {2u, 5u})
    EXPECT_EQ(in_threads(files, threads), alone) << threads;
}

} // namespace
} // namespace ellipsoid::post

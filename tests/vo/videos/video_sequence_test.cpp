#include "vo/videos/video_sequence.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/same_pixels.h"
#include "tests/support/temp_folder.h"
#include "tests/support/video_files.h"
#include "vo/dataset/sequence_source.h"
#include "vo/files/input.h"

namespace {

namespace fs = std::filesystem;
using support::error_kind;
using support::error_text;
using support::have_same_pixels;
using support::noise_camera;
using support::noise_images;
using support::riff_number;
using support::TempFolder;
using support::write_video_of;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kStampsNote = "the stamps are the container's times of presentation";

/// Videos that this test writes.
class VideoSequence : public testing::Test {
 protected:
  void SetUp() override {
#ifndef EDVO_HAS_VIDEO
    GTEST_SKIP() << "libopencv-videoio-dev was not found";
#endif
  }

  fs::path file(const std::string& name) const {
    return folder.path() / name;
  }

  /// Writes a video with other bytes than the file that is there.
  fs::path write_changed(const std::string& name, const std::string& bytes) const {
    return folder.write(name, bytes);
  }

  TempFolder folder;
};

TEST_F(VideoSequence, LosslessOnesKeepEveryPixelOfColourAndOfGrey) {
  for (const int channels : {3, 1}) {
    const std::vector<cv::Mat> images = noise_images(9, channels);
    const fs::path path = file("video" + std::to_string(channels) + ".avi");
    write_video_of(path, images, 25);
    EXPECT_EQ(vo::detect_format(path), vo::SequenceFormat::video);
    const vo::SequenceSource video =
        vo::open_sequence(path, vo::SequenceFormat::video, noise_camera());
    ASSERT_EQ(video.timestamps.size(), images.size());
    EXPECT_THAT(video.notes, ElementsAre(kStampsNote));
    for (std::size_t i = 0; i < images.size(); ++i) {
      EXPECT_EQ(video.timestamps[i], std::stod("0." + std::to_string(100 + 4 * i).substr(1)));
      EXPECT_TRUE(have_same_pixels(video.read(i).image, images[i])) << channels << ", " << i;
      EXPECT_TRUE(video.read(i).depth.empty());
    }
  }
}

TEST_F(VideoSequence, AFrameIsTheSameInWhateverOrderFramesAreReadAndByHoweverManyThreads) {
  const std::vector<cv::Mat> images = noise_images(12, 3);
  for (const char* name : {"video.avi", "video.mp4"}) {
    write_video_of(file(name), images, 30);
    const vo::SequenceSource in_order = vo::open_video(file(name), noise_camera());
    std::vector<cv::Mat> frames;
    for (std::size_t i = 0; i < images.size(); ++i) {
      frames.push_back(in_order.read(i).image);
    }
    const vo::SequenceSource video = vo::open_video(file(name), noise_camera());
    for (const std::size_t i : {11, 3, 3, 4, 0, 7, 6, 11, 0}) {
      EXPECT_TRUE(have_same_pixels(video.read(i).image, frames[i])) << name << " " << i;
    }
    std::vector<std::future<cv::Mat>> reads;
    for (std::size_t i = 0; i < images.size(); ++i) {
      reads.push_back(std::async(std::launch::async, [&video, i] { return video.read(i).image; }));
    }
    for (std::size_t i = 0; i < images.size(); ++i) {
      EXPECT_TRUE(have_same_pixels(reads[i].get(), frames[i])) << name << " " << i;
    }
  }
}

TEST_F(VideoSequence, AnAviStatesItsFramesRateAndCodecWhereRiffHasThem) {
  write_video_of(file("video.avi"), noise_images(9, 3), 29.97);
  const std::string bytes = vo::read_file(file("video.avi"));
  const std::size_t main = bytes.find("avih") + 8;
  EXPECT_EQ(riff_number(bytes, 4), bytes.size() - 8);
  EXPECT_EQ(riff_number(bytes, main + 16), 9U) << "dwTotalFrames";
  EXPECT_EQ(riff_number(bytes, main + 32), 96U) << "dwWidth";
  EXPECT_EQ(riff_number(bytes, main + 36), 64U) << "dwHeight";
  const std::size_t stream = bytes.find("strh") + 8;
  EXPECT_EQ(bytes.substr(stream, 8), "vidsFFV1");
  EXPECT_NEAR(
      static_cast<double>(riff_number(bytes, stream + 24)) / riff_number(bytes, stream + 20), 29.97,
      1e-9)
      << "dwRate / dwScale, Hz";
  EXPECT_EQ(riff_number(bytes, stream + 32), 9U) << "dwLength";
}

TEST_F(VideoSequence, OfAFileThatIsCutWhatIsWholeIsRead) {
  const std::vector<cv::Mat> images = noise_images(20, 3);
  write_video_of(file("video.avi"), images, 30);
  const std::string bytes = vo::read_file(file("video.avi"));
  const fs::path cut = write_changed("cut.avi", bytes.substr(0, bytes.size() * 6 / 10));
  const vo::SequenceSource video = vo::open_video(cut, noise_camera());
  EXPECT_GE(video.timestamps.size(), 10U);
  EXPECT_LT(video.timestamps.size(), 13U);
  EXPECT_THAT(video.notes,
              ElementsAre(vo::concat("the file is cut before its container's end: the first ",
                                     video.timestamps.size(), " frames are read"),
                          kStampsNote));
  for (std::size_t i = 0; i < video.timestamps.size(); ++i) {
    EXPECT_TRUE(have_same_pixels(video.read(i).image, images[i])) << i;
  }
  const fs::path head = write_changed("head.avi", bytes.substr(0, 2000));
  EXPECT_THAT(error_text([&] { vo::open_video(head, noise_camera()); }), HasSubstr("head.avi: "));
}

TEST_F(VideoSequence, AnMp4WithoutItsIndexIsAnError) {
  write_video_of(file("video.mp4"), noise_images(20, 3), 30);
  const std::string bytes = vo::read_file(file("video.mp4"));
  const fs::path cut = write_changed("cut.mp4", bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(error_text([&] { vo::open_video(cut, noise_camera()); }),
              testing::EndsWith("cut.mp4: is cut before the end that its container states, and "
                                "cannot be decoded without what is missing"));
}

TEST_F(VideoSequence, ANumberOfFramesThatTheContainerStatesWronglyIsNoted) {
  write_video_of(file("video.avi"), noise_images(6, 3), 30);
  std::string bytes = vo::read_file(file("video.avi"));
  bytes[bytes.find("strh") + 8 + 32] = 50;
  const vo::SequenceSource video =
      vo::open_video(write_changed("stated.avi", bytes), noise_camera());
  EXPECT_EQ(video.timestamps.size(), 6U);
  EXPECT_THAT(video.notes, ElementsAre("the container states 50 frames, of which 6 can be decoded",
                                       kStampsNote));
}

TEST_F(VideoSequence, WhereTheContainersTimesDoNotIncreaseStampsAreEven) {
  write_video_of(file("video.mp4"), noise_images(6, 3), 30);
  std::string bytes = vo::read_file(file("video.mp4"));
  bytes.replace(bytes.find("stts") + 16, 4, 4, '\0');  // the time from frame to frame
  const vo::SequenceSource video =
      vo::open_video(write_changed("still.mp4", bytes), noise_camera());
  EXPECT_THAT(video.notes,
              ElementsAre(HasSubstr("the container's times of presentation do not increase: the "
                                    "stamps are the frames' numbers by its rate of ")));
  ASSERT_EQ(video.timestamps.size(), 6U);
  EXPECT_GT(video.timestamps[1], 0);
  for (std::size_t i = 0; i < video.timestamps.size(); ++i) {
    EXPECT_NEAR(video.timestamps[i], static_cast<double>(i) * video.timestamps[1], 1e-8);
  }
}

TEST_F(VideoSequence, AFileWithoutVideoIsAnError) {
  write_video_of(file("video.avi"), noise_images(6, 3), 30);
  std::string bytes = vo::read_file(file("video.avi"));
  const std::size_t stream = bytes.find("vidsFFV1");
  const fs::path sound = write_changed("sound.avi", bytes.replace(stream, 8, "auds\1\0\0\0", 8));
  EXPECT_THAT(error_text([&] { vo::open_video(sound, noise_camera()); }),
              testing::EndsWith("sound.avi: has no video that can be decoded, expected one in a "
                                "codec of FFmpeg's"));
}

TEST_F(VideoSequence, TheCameraMustBeGivenAndOfTheImagesSize) {
  write_video_of(file("video.avi"), noise_images(2, 3), 30);
  EXPECT_THAT(error_text([&] { vo::open_video(file("video.avi"), std::nullopt); }),
              HasSubstr("video.avi: a video says nothing of its camera; name it with --camera"));
  const vo::RgbdCamera other{vo::PinholeCamera::from_horizontal_fov(64, 96, 60)};
  EXPECT_THAT(error_text([&] { vo::open_video(file("video.avi"), other); }),
              HasSubstr("video.avi: is 96x64 px, expected the camera's 64x96"));
}

/// The matrix of an MP4's track header that turns by a quarter, clockwise: (a b u c d v x y w).
std::string quarter_turn() {
  const auto fixed = [](int value) {
    return std::string{static_cast<char>(value < 0 ? -1 : 0), static_cast<char>(value), 0, 0};
  };
  return fixed(0) + fixed(1) + fixed(0) + fixed(-1) + fixed(0) + fixed(0);
}

TEST_F(VideoSequence, ImagesAreAsStoredAlsoWherePlayersTurnThem) {
  write_video_of(file("video.mp4"), noise_images(3, 3), 30);
  const cv::Mat upright = vo::open_video(file("video.mp4"), noise_camera()).read(2).image;
  std::string bytes = vo::read_file(file("video.mp4"));
  bytes.replace(bytes.find("tkhd") + 4 + 40, 24, quarter_turn());
  const vo::SequenceSource video =
      vo::open_video(write_changed("turned.mp4", bytes), noise_camera());
  EXPECT_THAT(video.notes,
              ElementsAre(kStampsNote, HasSubstr("the file says that players turn its images")));
  EXPECT_TRUE(have_same_pixels(video.read(2).image, upright));
}

TEST_F(VideoSequence, AnMp4IsNearToWhatWasWritten) {
  std::vector<cv::Mat> images;
  for (int i = 0; i < 8; ++i) {
    cv::Mat image(64, 96, CV_8UC3);
    for (int v = 0; v < image.rows; ++v) {
      for (int u = 0; u < image.cols; ++u) {
        const double wave = 100 + 60 * std::sin(0.1 * (u + 2 * i)) * std::cos(0.08 * v);
        image.at<cv::Vec3b>(v, u) = cv::Vec3b::all(cv::saturate_cast<uchar>(wave));
      }
    }
    images.push_back(image);
  }
  write_video_of(file("video.mp4"), images, 30);
  const vo::SequenceSource video = vo::open_video(file("video.mp4"), noise_camera());
  ASSERT_EQ(video.timestamps.size(), images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    EXPECT_NEAR(video.timestamps[i], static_cast<double>(i) / 30, 1e-9);
    EXPECT_LT(cv::norm(video.read(i).image, images[i], cv::NORM_L1) / (64 * 96 * 3), 3)
        << "levels of 255 in the mean";
  }
}

TEST_F(VideoSequence, OneSequenceMakesTheSameBytesTwice) {
  for (const char* end : {".avi", ".mp4"}) {
    write_video_of(file(std::string("a") + end), noise_images(5, 3), 30);
    write_video_of(file(std::string("b") + end), noise_images(5, 3), 30);
    EXPECT_EQ(vo::read_file(file(std::string("a") + end)),
              vo::read_file(file(std::string("b") + end)));
  }
}

TEST_F(VideoSequence, WhatAVideoCannotHoldIsAnErrorAndLeavesNothing) {
  EXPECT_EQ(error_kind([&] { write_video_of(file("video.mkv"), noise_images(2, 3), 30); }),
            vo::ErrorKind::usage);
  EXPECT_THAT(error_text([&] { write_video_of(file("v.avi"), {cv::Mat(63, 96, CV_8UC3)}, 30); }),
              HasSubstr("v.avi: a video has images of even width and height, got 96x63 px"));
  std::vector<cv::Mat> images = noise_images(3, 3);
  images.back() = cv::Mat(64, 96, CV_8UC1, cv::Scalar(3));
  EXPECT_THAT(error_text([&] { write_video_of(file("v.avi"), images, 30); }),
              HasSubstr("v.avi: frame 2 is of 96x64 px in 1 channels, expected the first one's "
                        "96x64 in 3"));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(VideoRate, IsTheMeanOfTheStampsAndHoldsThoseThatAreEven) {
  EXPECT_EQ(vo::video_rate({5, 5.1, 5.2}), 10);
  EXPECT_EQ(vo::video_rate({0, 1 / 29.97, 2 / 29.97}), 29.97);
  EXPECT_EQ(vo::video_rate({7}), 30);
  EXPECT_TRUE(vo::video_holds({0, 0.0333333, 0.066667}));
  EXPECT_FALSE(vo::video_holds({5, 5.1, 5.2})) << "a video begins at 0";
  EXPECT_FALSE(vo::video_holds({0, 0.09, 0.2}));
}

}  // namespace

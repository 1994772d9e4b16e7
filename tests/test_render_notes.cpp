// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "animation.hpp"
#include "fixtures.hpp"
#include "image.hpp"
#include "planescope/camera.hpp"
#include "planescope/compare_pictures.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"
#include "planescope/result.hpp"
#include "png_chunks.hpp"
#include "test_render_scene.hpp"

/// \file What a picture says of itself, its camera as a file, and pictures that move.
namespace planescope {
namespace {

using draw::PngChunk;
using testing::TemporaryFolder;
using testing::toy_room;
using testing::ToyScene;

/// The toy room as a result folder.
class Notes : public ::testing::Test {
 protected:
  Notes() {
    const ToyScene toy = toy_room(0.04F);
    save(toy.scene, toy.cloud, folder_ / "room", {"room.ply", "0123456789abcdef"});
    save_geometry(toy.scene, toy.cloud, folder_ / "room");
    options_.size = {320, 240};
  }
  Camera draw(const std::string& name) {
    return render(folder_ / "room", options_, folder_ / name);
  }
  std::vector<PngChunk> chunks(const std::string& name) const {
    return draw::png_chunks(testing::read_bytes(folder_ / name), name);
  }
  PictureComparison compared(const char* a, const char* b) const {
    return compare_pictures(folder_ / a, folder_ / b);
  }
  TemporaryFolder folder_;
  RenderOptions options_;
};

TEST_F(Notes, SayHowThePictureCanBeMadeAgain) {
  options_.view = View::Left;
  options_.camera.zoom = 1.5;
  options_.annotation.title = "R\u00e4ume";
  draw("a.png");
  std::map<std::string, std::string> said;
  for (const auto& [key, text] : draw::png_texts(testing::read_bytes(folder_ / "a.png"), "a.png"))
    said[key] = text;
  EXPECT_EQ(said["Title"], "R\u00e4ume");
  EXPECT_EQ(said["Source"], "room.ply 0123456789abcdef");
  EXPECT_EQ(said["Software"].substr(0, 13), "planescope 0.");
  EXPECT_EQ(said["planescope:options"], load_result(folder_ / "room").options_hash);
  EXPECT_NE(said["planescope:drawing"].find(R"("layers":["segments"])"), std::string::npos);
  RenderOptions again;
  again.size = options_.size;
  again.annotation.title = options_.annotation.title;
  again.camera.fixed = parse_camera(said["planescope:camera"], "a.png");
  render(folder_ / "room", again, folder_ / "b.png");
  EXPECT_TRUE(compared("a.png", "b.png").identical());
}

TEST_F(Notes, HoldTheResolution) {
  options_.dpi = 600;
  draw("a.png");
  const auto all = chunks("a.png");
  const auto found = std::find_if(all.begin(), all.end(),
                                  [](const PngChunk& chunk) { return chunk.type == "pHYs"; });
  ASSERT_NE(found, all.end());
  // 600 / 0.0254 = 23622 = 0x5c46 a metre, both ways; unit 1.
  EXPECT_EQ(found->data, std::string("\0\0\x5c\x46\0\0\x5c\x46\1", 9));
}

TEST_F(Notes, ACameraFileMakesTheSamePicture) {
  for (const bool parallel : {false, true}) {
    options_ = {};
    options_.size = {320, 240};
    options_.camera.azimuth = 33.3;
    options_.camera.roll = 7;
    options_.camera.parallel = parallel;
    write_camera(draw("a.png"), folder_ / "camera.json");
    options_.camera = {};
    options_.camera.fixed = read_camera(folder_ / "camera.json");
    draw("b.png");
    EXPECT_TRUE(compared("a.png", "b.png").identical()) << parallel;
  }
}

TEST(CameraFile, IsRefusedInWordsWhereItIsNone) {
  const auto refusal = [](const std::string& json) {
    try {
      parse_camera(json, "c.json");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Input);
      return std::string(error.what());
    }
    return std::string("none");
  };
  const std::string good = R"({"position":[0,0,1],"focal":[0,0,0],"up":[0,1,0]})";
  EXPECT_EQ(refusal(good), "none");
  EXPECT_NE(refusal("{").find("c.json: is not JSON"), std::string::npos);
  EXPECT_NE(refusal(R"({"position":[0,0,1],"focal":[0,0,0]})").find("`up`"), std::string::npos);
  EXPECT_NE(refusal(R"({"position":[0,0,1],"focal":[0,0,1],"up":[0,1,0]})").find("same place"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"position":[0,0,1],"focal":[0,0,0],"up":[0,0,2]})").find("along the view"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"position":[0,0,"x"],"focal":[0,0,0],"up":[0,1,0]})").find("`position`"),
            std::string::npos);
  EXPECT_NE(
      refusal(R"({"position":[0,0,1],"focal":[0,0,0],"up":[0,1,0],"view_angle":180})").find("170"),
      std::string::npos);
}

TEST_F(Notes, AnOrbitIsAnAnimatedPngWhoseFirstFrameOthersShow) {
  render_orbit(folder_ / "room", options_, 5, folder_ / "orbit.png");
  std::map<std::string, int> count;
  std::vector<std::string> sequence;
  std::string control;
  for (const PngChunk& chunk : chunks("orbit.png")) {
    ++count[chunk.type];
    if (chunk.type == "acTL") control = chunk.data;
    // Frames and their data are numbered on from 0 (APNG 1.0).
    if (chunk.type == "fcTL" || chunk.type == "fdAT") sequence.push_back(chunk.data.substr(0, 4));
  }
  EXPECT_EQ(control, std::string("\0\0\0\5\0\0\0\0", 8));  // five frames, for ever
  EXPECT_EQ(count["fcTL"], 5);
  EXPECT_GE(count["IDAT"], 1);
  EXPECT_GE(count["fdAT"], 4);
  for (std::size_t i = 0; i < sequence.size(); ++i)
    EXPECT_EQ(sequence[i], draw::big_endian(static_cast<std::uint32_t>(i)));
  const draw::Image first = draw::read_png(folder_ / "orbit.png");
  EXPECT_EQ(first.width, 320);
  EXPECT_FALSE(draw::is_uniform(first, 0, 240));
}

TEST_F(Notes, TransparentPicturesLieOnAnyGround) {
  draw("opaque.png");
  options_.transparent = true;
  draw("clear.png");
  const draw::Image opaque = draw::read_png(folder_ / "opaque.png");
  const draw::Image clear = draw::read_png(folder_ / "clear.png");
  ASSERT_EQ(clear.alpha.size(), 320U * 240);
  EXPECT_EQ(clear.alpha[0], 0);
  EXPECT_GT(std::count(clear.alpha.begin(), clear.alpha.end(), 255), 320 * 240 / 4);
  draw::Image on_white{320, 240, {}};
  for (std::size_t i = 0; i < clear.rgb.size(); ++i) {
    const int alpha = clear.alpha[i / 3];
    on_white.rgb.push_back(
        static_cast<std::uint8_t>((clear.rgb[i] * alpha + 255 * (255 - alpha) + 127) / 255));
  }
  int most = 0;
  for (std::size_t i = 0; i < opaque.rgb.size(); ++i)
    most = std::max(most, std::abs(opaque.rgb[i] - on_white.rgb[i]));
  EXPECT_LE(most, 3) << "over white it is the opaque picture";
}

}  // namespace
}  // namespace planescope

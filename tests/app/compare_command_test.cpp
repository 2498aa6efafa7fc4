#include "app/process.h"
#include "image/image_file.h"
#include "support/catch.h"

#include <cmath>

using namespace raywalk;
using namespace raywalk::test;

namespace {

Image ramp(int width, int height, float gain) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    image.pixels.emplace_back(gain * static_cast<float>(i) / static_cast<float>(width * height));
  return image;
}

void put(const Folder& folder, const std::string& name, const Image& image) {
  REQUIRE(write_image(folder / name, image));
}

}  // namespace

TEST_CASE("compare prints the metrics of two pictures of any format") {
  const Folder folder;
  put(folder, "a.pfm", ramp(8, 6, 1));
  put(folder, "b.pfm", ramp(8, 6, 0.5F));
  put(folder, "a.png", ramp(8, 6, 1));
  const Outcome outcome = folder.run({"compare", "a.pfm", "b.pfm"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  for (const char* word :
       {"a.pfm against b.pfm, 8 x 6 pixels", "MSE", "relMSE", "PSNR", "dB", "FLIP", "99%", "column 7 of row 5"})
    CHECK_THAT(outcome.out, contains(word));
  // A PNG of the same is near, and not equal: it has 256 steps.
  const std::string near = folder.run({"compare", "a.png", "a.pfm"}).out;
  CHECK_THAT(near, contains("e-0") && !contains("the pictures are equal"));
  CHECK_THAT(folder.run({"compare", "a.png", "a.png"}).out, contains("the pictures are equal"));
  if (has_exr()) {
    put(folder, "a.exr", ramp(8, 6, 1));
    CHECK_THAT(folder.run({"compare", "a.exr", "a.pfm"}).out, contains("the pictures are equal"));
  }
}

TEST_CASE("compare writes a picture of the difference: signed as floats, to be seen as PNG") {
  const Folder folder;
  put(folder, "a.pfm", ramp(8, 6, 0.5F));
  put(folder, "b.pfm", ramp(8, 6, 1));
  CHECK(folder.run({"compare", "a.pfm", "b.pfm", "-o", "d.pfm"}).exit_code == 0);
  const auto difference = read_pfm(folder / "d.pfm");
  REQUIRE(difference);
  CHECK(difference->at(7, 5).x == Approx(-0.5 * 47 / 48));
  CHECK(folder.run({"compare", "a.pfm", "b.pfm", "-o", "d.png"}).exit_code == 0);
  CHECK(folder.holds("d.png"));
}

TEST_CASE("compare says what it cannot compare") {
  const Folder folder;
  put(folder, "a.pfm", ramp(8, 6, 1));
  put(folder, "b.pfm", ramp(6, 8, 1));
  folder.write("text.png", "no picture");
  folder.write("half.png", "\x89PNG\r\n\x1a\nand then nothing");
  Outcome outcome = folder.run({"compare", "a.pfm", "b.pfm"});
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("8 x 6 and 6 x 8") && contains("hint: render both with the same --size"));
  Image holes = ramp(8, 6, 1);
  holes.at(3, 3).y = std::nanf("");
  put(folder, "nan.pfm", holes);
  outcome = folder.run({"compare", "a.pfm", "nan.pfm"});
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("1 of 48 pixels of the second picture") && !contains("--size"));
  outcome = folder.run({"compare", "a.pfm", "text.png"});
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("text.png") && contains("expected a PNG, PFM, EXR or HDR"));
  CHECK(folder.run({"compare", "half.png", "a.pfm"}).exit_code == 1);
  CHECK(folder.run({"compare", "a.pfm", "nowhere.pfm"}).exit_code == 1);
  CHECK(folder.run({"compare", "a.pfm"}).exit_code == 2);
  outcome = folder.run({"compare", "a.pfm", "a.pfm", "-o", "d.gif"});
  CHECK(outcome.exit_code == 2);
  CHECK_THAT(outcome.err, contains(".png, .pfm or .exr"));
  CHECK(folder.run({"compare", "a.pfm", "a.pfm", "-o", "nowhere/d.png"}).exit_code == 1);
  CHECK_THAT(folder.run({"compare", "--help"}).out,
             contains("FLIP") && contains("Examples") && contains(".png, .pfm, .exr or .hdr"));
}

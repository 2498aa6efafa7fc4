#include "app/arguments.h"

#include "support/catch.h"

using namespace raywalk;

TEST_CASE("sizes are two whole numbers") {
  CHECK(parse_size("640x480") == ImageSize{640, 480});
  CHECK(parse_size("1X32768") == ImageSize{1, 32768});
  for (const std::string text : {"", "x", "640", "640x", "x480", "0x1", "1x0", "-1x1", "+1x1", "1.5x1", "1x1x1", "1 x1",
                                 "1x1 ", "32769x1", "99999999999x1", "axb"})
    CHECK_FALSE(parse_size(text).has_value());
}

TEST_CASE("a pixel is a cell or a place in the image") {
  CHECK(parse_pixel("0") == PixelChoice(Cell{0}));
  CHECK(parse_pixel("20") == PixelChoice(Cell{20}));
  CHECK(parse_pixel("40,12") == PixelChoice(ImagePixel{40, 12}));
  for (const std::string text : {"", ",", "1,", ",1", "-1", "1,-1", "1,2,3", "a", "1.5", "1 ,2", "32768"})
    CHECK_FALSE(parse_pixel(text).has_value());
}

TEST_CASE("whole numbers, seeds and shares are nothing but numbers") {
  CHECK(parse_whole("7", 1, 9) == 7);
  CHECK(parse_seed("18446744073709551615") == 18446744073709551615U);
  CHECK(parse_share("0.25") == 0.25);
  CHECK(parse_share("1e-3") == 1e-3);
  for (const std::string text : {"", "0", "10", "-7", "+7", "7 ", " 7", "7.0", "0x7", "99999999999"})
    CHECK_FALSE(parse_whole(text, 1, 9).has_value());
  for (const std::string text : {"", "-1", "18446744073709551616", "1.5", " 1"})
    CHECK_FALSE(parse_seed(text).has_value());
  CHECK(parse_share("1") == 1.0);
  CHECK(parse_amount("5") == 5.0);
  for (const std::string text : {"", "-0.1", "nan", "inf", "1e999", "0.1x", " 0.1", "x"}) {
    CHECK_FALSE(parse_amount(text).has_value());
    CHECK_FALSE(parse_share(text).has_value());
  }
  for (const std::string text : {"1.0001", "5"}) CHECK_FALSE(parse_share(text).has_value());
}

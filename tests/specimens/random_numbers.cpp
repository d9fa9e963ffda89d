// Random numbers: the published stream, and its mapping to uniform numbers.
#include <array>
#include <cmath>
#include <cstdint>

#include <hfdem/base/random.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

TEST_CASE("the stream is that of the published generator") {
  // SplitMix64 from seed 1234567, as its authors' code prints it.
  hfdem::Random random(1234567);
  for (const std::uint64_t expected :
       {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U,
        16408922859458223821U})
    CHECK(random.bits() == expected);
}

TEST_CASE("a stream can be entered anywhere") {
  hfdem::Random walked(1234567), jumped(1234567);
  for (int k = 0; k < 3; ++k) walked.bits();
  jumped.skip(3);
  CHECK(jumped.bits() == walked.bits());
}

TEST_CASE("a fraction is the upper 53 bits of the stream, exactly") {
  hfdem::Random random(1234567);
  // 6457827717110365317 = 2^11 * 3153236189995295.56...
  CHECK(random.fraction() == 3153236189995295.0 / 9007199254740992.0);
}

TEST_CASE("numbers between two bounds are uniform") {
  hfdem::Random random(7);
  constexpr int count = 100000, bins = 10;
  std::array<int, bins> in_bin{};
  double sum = 0, squares = 0;
  for (int k = 0; k < count; ++k) {
    const double number = random.between(-1, 3);
    REQUIRE(number >= -1);
    REQUIRE(number < 3);
    ++in_bin[static_cast<std::size_t>((number + 1) / 4 * bins)];
    sum += number;
    squares += (number - 1) * (number - 1);
  }
  CHECK(sum / count == test::near(1, 0.02));              // 5 standard errors
  CHECK(squares / count == test::near(16.0 / 12, 0.02));  // 7 standard errors
  for (const int n : in_bin) CHECK(n == test::near(count / bins, 0.05));
}

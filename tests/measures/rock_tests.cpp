// Rock tests against closed forms: lattices whose moduli and strengths follow from one contact.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/measure/mohr_coulomb.hpp>
#include <hfdem/measure/rock_tests.hpp>
#include <hfdem/measure/sample_mean.hpp>
#include <hfdem/observe/crack_map.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using hfdem::InvalidParameter;
using hfdem::RunStopped;
using hfdem::measure::LoadFrame;
using hfdem::measure::RockTest;
using test::near;
using Bond = hfdem::LinearParallelBond;
namespace measure = hfdem::measure;

const Bond law{Bond::Params{}};
const LoadFrame fast{.strain_rate = 0.1, .largest_strain = 0.02};

/// The square array turned by 45 degrees, for odd numbers of columns and rows. The sides of its box
/// go through the centres of the rim's discs, and no disc is in a corner, so that all have the same
/// share of a side.
hfdem::Specimen diamond(int columns, int rows) {
  constexpr double R = 5e-3, pitch = R * std::numbers::sqrt2;
  hfdem::Specimen s{.width = pitch * (columns - 1),
                    .height = pitch * (rows - 1),
                    .density = 3169,
                    .bonding_gap = 1e-6 * R};
  for (int row = 0; row < rows; ++row)
    for (int column = 1 - row % 2; column < columns; column += 2) {
      s.centre.push_back({pitch * column, pitch * row});
      s.radius.push_back(R);
    }
  return s;
}

RockTest compressed(double confinement) {
  return measure::compression(diamond(11, 21), law, confinement, fast, {});
}

hfdem::Specimen small_rock() { return hfdem::random_packing({.width = 0.06, .height = 0.12}); }

}  // namespace

TEST_CASE("columns of discs are as stiff and as strong in tension as their bonds") {
  const auto test = measure::direct_tension(hfdem::square_array(6, 16, 5e-3), law, fast, {});
  const auto moduli = measure::elastic_moduli(test);
  CHECK(moduli.young == near(17e9, 0.01));  // of the bond: the particles carry no tension
  CHECK(std::abs(moduli.poisson) < 1e-6);
  CHECK(test.strength == near(8e6, 0.01));
  CHECK(test.strain_at_strength == near(8e6 / 17e9, 0.01));
  CHECK(test.breaks.size() >= 6);
  for (const auto& b : test.breaks) CHECK(b.mode == hfdem::Mode::tension);
}

TEST_CASE("a load rises from the start on, without a wave, however fast it is") {
  const auto test = measure::direct_tension(hfdem::square_array(6, 16, 5e-3), law,
                                            {.strain_rate = 1, .largest_strain = 0.02}, {});
  int looked_at = 0;
  for (const auto& r : test.curve) {
    if (r.strain == 0 || r.strain > 3e-4) continue;
    CHECK(r.stress == near(17e9 * r.strain, 0.02));
    ++looked_at;
  }
  CHECK(looked_at >= 5);
}

TEST_CASE("columns of discs do not fail in compression, which is said") {
  CHECK_THROWS_WITH_AS(
      measure::compression(hfdem::square_array(6, 12, 5e-3), law, 0, {.largest_strain = 1e-3}, {}),
      doctest::Contains("load_frame.largest_strain"), RunStopped);
}

// In the diamond all contacts are alike: normal stress (s1 + s3) / 2 and shear stress (s1 - s3) / 2
// in each, half of the normal stress in the particle and half in the bond. The particle slips at
// friction 0.5, the rest of the shear is the bond's.
TEST_CASE("the moduli of the diamond are its closed forms") {
  // Without confinement normal and shear stress are equal, so that the particles slip from the
  // start: 34 closing = 0.5 * 17 closing + 6.8 shear, in GPa.
  constexpr double shear_over_closing = (34 - 0.5 * 17) / (17 / 2.5);
  const RockTest test = compressed(0);
  const auto moduli = measure::elastic_moduli(test);
  CHECK(moduli.young == near(4 * 17e9 / (1 + shear_over_closing), 0.01));
  CHECK(moduli.poisson == near((shear_over_closing - 1) / (shear_over_closing + 1), 0.01));
}

TEST_CASE("ends come nearer by the strain of the grains and the give of the platens") {
  const RockTest test = compressed(0);
  const double height = diamond(11, 21).height, spacing = 2 * 5e-3 * std::numbers::sqrt2;
  int looked_at = 0;
  for (const auto& r : test.curve) {
    if (r.stress < 20e6 || r.strain > test.strain_at_strength) continue;
    const double give = r.stress * spacing / (4 * 17e9);  // a platen is half a cell: 2 (E + E_b)
    CHECK(r.strain == near(r.shortening.y + 2 * give / height, 0.01));
    ++looked_at;
  }
  CHECK(looked_at > 10);
}

TEST_CASE("the strengths of the diamond under confinement are its closed forms") {
  const double tangent = std::tan(30 * std::numbers::pi / 180);
  const double sine = (0.5 + tangent) / 2;  // of the lattice's friction angle
  std::vector<hfdem::Vec2> strengths;
  for (const double confinement : {0.0, 5e6, 10e6}) {
    const RockTest test = compressed(confinement);
    CAPTURE(confinement);
    // (s1 - s3) / 2 - 0.5 (s1 + s3) / 4 = c + tan(phi) (s1 + s3) / 4
    CHECK(test.strength == near((2 * 15e6 + confinement * (1 + sine)) / (1 - sine), 0.01));
    CHECK(test.confinement == confinement);
    REQUIRE(!test.breaks.empty());
    CHECK(test.breaks.front().mode == hfdem::Mode::shear);
    strengths.push_back({confinement, test.strength});
  }
  const auto coulomb = measure::MohrCoulomb::through(strengths);
  CHECK(coulomb.friction_angle == near(std::asin(sine) * 180 / std::numbers::pi, 0.02));
  CHECK(coulomb.cohesion == near(15e6 / std::sqrt(1 - sine * sine), 0.02));
}

TEST_CASE("half the rate of loading gives the same strength") {
  LoadFrame slow = fast;
  slow.strain_rate /= 2;
  const auto test = measure::compression(diamond(7, 11), law, 0, slow, {});
  CHECK(test.strength == near(2 * 15e6 / (1 - 0.5386751), 0.01));
}

TEST_CASE("the tension in a Brazilian plate is that of point loads along its arcs") {
  const hfdem::BrazilianDisc plate{.diameter = 0.2, .loading_angle = 30};
  // Two opposite loads P on a plate of diameter D: 2 P / (pi D) across, -6 P / (pi D) along them.
  const double half = 15 * std::numbers::pi / 180;
  double tension = 0, resultant = 0;
  constexpr int pieces = 1000;
  for (int k = 0; k < pieces; ++k) {
    const double angle = half * (2 * (k + 0.5) / pieces - 1), load = 1.0 / pieces;
    const double sine = std::sin(angle), cosine = std::cos(angle);
    tension += load * (2 * cosine * cosine - 6 * sine * sine) / (std::numbers::pi * plate.diameter);
    resultant += load * cosine;
  }
  CHECK(plate.tension(resultant) == near(tension, 1e-5));
}

TEST_CASE("a Brazilian plate is round but for its flats, and as wide as told") {
  const hfdem::BrazilianDisc plate{.diameter = 0.15, .loading_angle = 20};
  const auto s = hfdem::brazilian_disc(plate, {});
  CHECK(s.width == 0.15);
  CHECK(s.height == near(0.15 * std::cos(10 * std::numbers::pi / 180)));
  double area = 0;
  int on_flats = 0;
  for (hfdem::Index i = 0; i < s.size(); ++i) {
    area += std::numbers::pi * s.radius[i] * s.radius[i];
    CHECK(norm(s.centre[i] - hfdem::Vec2{0.075, s.height / 2}) <= 0.075);
    on_flats += s.touches(i, hfdem::Side::top) + s.touches(i, hfdem::Side::bottom);
  }
  CHECK(area / (1 - 0.1) == near(std::numbers::pi / 4 * 0.15 * 0.15, 0.03));
  // Flats of 26 mm, discs of 8 mm
  CHECK(on_flats >= 4);
  CHECK(on_flats <= 10);
}

TEST_CASE("a small random rock is twice as strong split as pulled at most") {
  const auto rock = hfdem::random_packing({.width = 0.1, .height = 0.12});
  const auto pulled = measure::direct_tension(rock, law, fast, {});
  CHECK(pulled.strength > 3e6);
  CHECK(pulled.strength < 8e6);  // of a bond
  const hfdem::BrazilianDisc plate{.diameter = 0.15};
  const auto split = measure::brazilian(hfdem::brazilian_disc(plate, {}), plate, law, fast, {});
  CHECK(split.strength > 0.7 * pulled.strength);
  CHECK(split.strength < 2 * pulled.strength);
}

TEST_CASE("a test says where and when bonds broke, and ends where it was told") {
  const auto rock = small_rock();
  LoadFrame frame = fast;
  frame.end_below = 0.8;
  frame.largest_strain = 0.003;
  const auto test = measure::compression(rock, law, 2e6, frame, {});
  REQUIRE(!test.curve.empty());
  CHECK(test.curve.front().stress == near(2e6, 0.01));
  CHECK(test.curve.front().shortening.y == 0);
  double last = 0;
  for (const auto& b : test.breaks) {
    CHECK(b.strain >= last);
    last = b.strain;
  }
  CHECK(last <= 0.003);
  CHECK(test.displacement.size() == rock.size());
  const double end = test.curve.back().stress - 2e6, peak = test.strength - 2e6;
  const bool dropped = end<0.85 * peak, out_of_strain = test.curve.back().strain> 0.00298;
  CHECK((dropped || out_of_strain));
}

TEST_CASE("without a modulus scattered bonds are the same bonds, with one they are weaker") {
  const auto rock = small_rock();
  using Scattered = hfdem::ScatteredParallelBond;
  const auto strength = [&rock](const auto& contact) {
    return measure::direct_tension(rock, contact, {.strain_rate = 0.1, .grip_depth = 0.01}, {})
        .strength;
  };
  const double even = strength(law);
  CHECK(strength(Scattered(Scattered::Params{})) == even);
  CHECK(strength(Scattered({{}, 3.0, 1})) < 0.9 * even);
}

TEST_CASE("grips that cannot hold a specimen are refused") {
  const auto pull = [](double depth) {
    return measure::direct_tension(small_rock(), law, {.grip_depth = depth}, {});
  };
  CHECK_THROWS_WITH_AS(pull(0.04), doctest::Contains("load_frame.grip_depth"), InvalidParameter);
  CHECK_THROWS_WITH_AS(pull(1e-3), doctest::Contains("hold no disc"), InvalidParameter);
}

TEST_CASE("Brazilian plates that cannot be are refused") {
  CHECK_THROWS_WITH_AS(hfdem::brazilian_disc({.diameter = 0.05}, {}),
                       doctest::Contains("brazilian.diameter"), InvalidParameter);
  CHECK_THROWS_WITH_AS(hfdem::brazilian_disc({.loading_angle = 90}, {}),
                       doctest::Contains("brazilian.loading_angle"), InvalidParameter);
}

TEST_CASE("a crack map shows each broken bond across its contact, where its discs have gone") {
  // Two discs side by side that move 1 mm to the right.
  const auto map_of = [](const RockTest& test, double exaggeration) {
    return svg(hfdem::observe::CrackMap{.specimens = {{"two discs", &test}},
                                        .exaggeration = exaggeration});
  };
  RockTest test;
  test.specimen = {
      .width = 0.1, .height = 0.1, .centre = {{0.04, 0.05}, {0.06, 0.05}}, .radius = {0.01, 0.01}};
  test.displacement = {{1e-3, 0}, {1e-3, 0}};
  test.breaks = {{.strain = 0, .mode = hfdem::Mode::tension, .contact = {{0, 1}, {1, 0, 0.01, 0}}}};
  // Three columns on 880 pixels with 24 between them, each 1.16 specimens wide; paths are relative.
  const double scale = ((880 + 24) / 3.0 - 24) / (1.16 * 0.1);
  const auto stroke_at = [&](double x) {
    using hfdem::observe::drawing::number;
    return "m" + number(std::round(10 * (x + 0.008) * scale) / 10) + " ";
  };
  const std::string facet = "l0-" + hfdem::observe::drawing::number(2 * 0.01 * scale);
  for (const double exaggeration : {0.0, 20.0}) {
    const std::string picture = map_of(test, exaggeration);
    const std::string start = stroke_at(0.05 + exaggeration * 1e-3);
    const auto at = picture.find(facet);
    REQUIRE(at != std::string::npos);
    CHECK(picture.substr(0, at).rfind(start) != std::string::npos);
    CHECK(picture.find(facet, at + 1) == std::string::npos);
    CHECK(picture.substr(0, at).rfind("#d55e00") == std::string::npos);  // vermillion comes after
  }
  test.breaks.front().mode = hfdem::Mode::shear;
  const std::string sheared = map_of(test, 0);
  CHECK(sheared.substr(0, sheared.find(facet)).rfind("#d55e00") != std::string::npos);
}

TEST_CASE("Student's t is that of the tables") {
  const std::vector<std::pair<int, double>> table{{1, 12.7062}, {2, 4.3027},  {3, 3.1824},
                                                  {4, 2.7764},  {9, 2.2622},  {10, 2.2281},
                                                  {30, 2.0423}, {100, 1.9840}};
  for (const auto& [freedom, t] : table) CHECK(measure::student_t_95(freedom) == near(t, 3e-5));
}

TEST_CASE("a mean and its interval are those of a sample") {
  const std::vector<double> values{1, 2, 3, 6};
  const auto m = measure::SampleMean::of(values);
  CHECK(m.mean == near(3));
  CHECK(m.deviation == near(std::sqrt(14.0 / 3)));
  CHECK(m.ci95 == near(3.1824 * std::sqrt(14.0 / 3) / 2, 1e-4));
  CHECK(std::isnan(measure::SampleMean::of(std::vector{5.0}).ci95));
}

TEST_CASE("the envelope through strengths of a Coulomb rock gives its friction and cohesion") {
  const double sine = std::sin(37.5 * std::numbers::pi / 180), K = (1 + sine) / (1 - sine);
  std::vector<hfdem::Vec2> strengths;
  for (const double sigma_3 : {0.0, 3e6, 10e6})
    strengths.push_back({sigma_3, 2 * 5.8e6 * std::sqrt(K) + K * sigma_3});
  const auto coulomb = measure::MohrCoulomb::through(strengths);
  CHECK(coulomb.friction_angle == near(37.5));
  CHECK(coulomb.cohesion == near(5.8e6));
}

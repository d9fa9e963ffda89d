// Numerical solutions of the KGD fracture (similarity and transient solvers, errors in the last
// columns' heads), and what the tests of its approximations share.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include <hfdem/analytic/kgd.hpp>

#include <doctest/doctest.h>

#include "laws/near.hpp"

namespace test {

using hfdem::analytic::KgdFracture;
using hfdem::analytic::KgdProblem;

/// The point (K_m, tau) of the map of regimes in units E' = mu' = Q = C' = 1, where time is tau.
inline KgdProblem unit_problem(double K_m, double tau) {
  return {.E_prime = 1,
          .K_IC = K_m / std::sqrt(32 / std::numbers::pi),
          .viscosity = 1.0 / 12,
          .leak_off = 0.5,
          .rate = 1,
          .time = tau};
}
/// The same without leak-off, at time 1.
inline KgdProblem tight_problem(double K_m) {
  KgdProblem p = unit_problem(K_m, 1);
  p.leak_off = 0;
  return p;
}

/// The true solution, and how far Dontsov's is from it: per cent, and the efficiency itself.
struct Row {
  double K_m, tau, l, w, p, efficiency, off_l, off_w, off_efficiency;
};

/// No leak-off; errors below 1e-4.
inline constexpr std::array<Row, 10> tight_rows{{
    {0.20, 0, 0.615296, 1.125931, 0.544882, 1, 0.08, 0.07, 0},
    {0.50, 0, 0.613371, 1.127586, 0.546018, 1, 0.10, 0.12, 0},
    {0.70, 0, 0.609720, 1.130920, 0.548324, 1, 0.16, 0.19, 0},
    {1.09, 0, 0.594839, 1.146457, 0.559372, 1, 0.36, 0.40, 0},
    {1.50, 0, 0.567758, 1.181425, 0.585840, 1, 0.54, 0.62, 0},
    {2.00, 0, 0.523967, 1.255265, 0.647751, 1, 0.51, 0.77, 0},
    {3.00, 0, 0.434265, 1.481781, 0.876781, 1, 0.20, 0.53, 0},
    {4.80, 0, 0.325911, 1.957128, 1.508901, 1, 0.03, 0.14, 0},
    {6.99, 0, 0.254732, 2.500276, 2.456682, 1, 0.01, 0.03, 0},
    {10.0, 0, 0.200818, 3.170463, 3.948030, 1, 0.00, 0.01, 0},
}};

/// With leak-off; errors below 2e-4.
inline constexpr std::array<Row, 20> leaky_rows{{
    {0.70, 1e-12, 6.02198e-09, 1.12436e-04, 5.51727e+03, 0.98218, 0.166, 0.180, 0},
    {0.70, 1e-6, 5.40601e-05, 1.06810e-02, 5.82133e+01, 0.83917, 0.214, 0.115, -0.0005},
    {0.70, 1e0, 2.42724e-01, 7.17299e-01, 8.64644e-01, 0.25429, 0.051, 0.047, -0.0013},
    {0.70, 1e6, 3.14911e+02, 2.57575e+01, 2.39111e-02, 0.01186, 0.001, 0.121, -0.0001},
    {1.09, 1e-12, 5.87862e-09, 1.13977e-04, 5.62625e+03, 0.98261, 0.365, 0.389, -0.0001},
    {1.09, 1e-6, 5.30134e-05, 1.08260e-02, 5.91926e+01, 0.84232, 0.351, 0.345, -0.0007},
    {1.09, 1e0, 2.41441e-01, 7.27753e-01, 8.71361e-01, 0.25849, 0.071, 0.270, -0.0015},
    {1.09, 1e6, 3.14835e+02, 2.61621e+01, 2.40227e-02, 0.01212, 0.002, 0.309, -0.0001},
    {2.00, 1e-12, 5.18664e-09, 1.24862e-04, 6.50909e+03, 0.98466, 0.507, 0.768, -0.0001},
    {2.00, 1e-6, 4.74119e-05, 1.19159e-02, 6.79530e+01, 0.85909, 0.446, 0.777, -0.0007},
    {2.00, 1e0, 2.31564e-01, 8.24556e-01, 9.62821e-01, 0.29053, 0.088, 0.769, -0.0015},
    {2.00, 1e6, 3.14170e+02, 3.01949e+01, 2.59902e-02, 0.01444, 0.002, 0.768, -0.0001},
    {4.80, 1e-12, 3.23830e-09, 1.95084e-04, 1.51371e+04, 0.99042, 0.034, 0.137, 0},
    {4.80, 1e-6, 3.05910e-05, 1.89584e-02, 1.55717e+02, 0.90925, 0.027, 0.140, 0},
    {4.80, 1e0, 1.86717e-01, 1.47994e+00, 1.99123e+00, 0.43327, -0.046, 0.129, -0.0004},
    {4.80, 1e6, 3.09894e+02, 6.02490e+01, 4.88351e-02, 0.02928, -0.013, 0.153, 0},
    {6.99, 1e-12, 2.53458e-09, 2.49401e-04, 2.46284e+04, 0.99250, 0.007, 0.033, 0},
    {6.99, 1e-6, 2.42383e-05, 2.43885e-02, 2.51840e+02, 0.92815, 0.006, 0.034, 0},
    {6.99, 1e0, 1.62439e-01, 1.99622e+00, 3.07570e+00, 0.50914, -0.042, 0.016, -0.0003},
    {6.99, 1e6, 3.06304e+02, 8.66674e+01, 7.08130e-02, 0.04168, -0.019, 0.029, 0},
}};

}  // namespace test

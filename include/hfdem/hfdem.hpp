/// @file
/// Everything, for the impatient. A program that needs little includes `simulator.hpp` and its four
/// policies, and compiles faster.
#pragma once

#include <hfdem/analytic/kgd.hpp>
#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/base/version.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/measure/crack.hpp>
#include <hfdem/measure/elastic_moduli.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/specimen_picture.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>
